package no.hials.crosscom.lang.internal;

import java.util.List;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.Interval;

/** The tokens of a line as the parser reads them. ANTLR's own streams hold a whole file. */
public final class LineTokens implements TokenStream {
  private static final Token END = new CommonToken(Token.EOF);

  private final TokenSource source;
  private final List<Token> tokens;
  private int index;

  /**
   * Creates a stream.
   *
   * @param source the source of the tokens
   * @param tokens the tokens of the line and its end
   */
  public LineTokens(TokenSource source, List<Token> tokens) {
    this.source = source;
    this.tokens = tokens;
  }

  @Override
  public Token LT(int offset) {
    int wanted = index + (offset > 0 ? offset - 1 : offset);
    return wanted < tokens.size() ? tokens.get(Math.max(wanted, 0)) : END;
  }

  @Override
  public int LA(int offset) {
    return LT(offset).getType();
  }

  @Override
  public void consume() {
    index++;
  }

  @Override
  public Token get(int position) {
    return tokens.get(position);
  }

  @Override
  public int index() {
    return index;
  }

  @Override
  public void seek(int position) {
    index = position;
  }

  @Override
  public int size() {
    return tokens.size();
  }

  /** Does nothing, because all tokens stay. */
  @Override
  public int mark() {
    return 0;
  }

  @Override
  public void release(int marker) {
    // all tokens stay
  }

  @Override
  public TokenSource getTokenSource() {
    return source;
  }

  @Override
  public String getSourceName() {
    return source.getSourceName();
  }

  @Override
  public String getText(Interval interval) {
    throw new UnsupportedOperationException();
  }

  @Override
  public String getText() {
    throw new UnsupportedOperationException();
  }

  @Override
  public String getText(RuleContext context) {
    throw new UnsupportedOperationException();
  }

  @Override
  public String getText(Token start, Token stop) {
    throw new UnsupportedOperationException();
  }
}
