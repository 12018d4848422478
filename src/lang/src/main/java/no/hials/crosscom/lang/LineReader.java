package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.internal.FirstError;
import no.hials.crosscom.lang.internal.LineTokens;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarLexer;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.PredictionMode;
import org.jspecify.annotations.Nullable;

/** Splits a file into lines of tokens. */
final class LineReader {
  /** The tokens of a motion to six coordinates and its end. */
  private static final int USUAL_LENGTH = 24;

  private final KrlGrammarLexer lexer;
  private final KrlGrammarParser parser;
  private @Nullable Token end;

  LineReader(String text) {
    lexer = new KrlGrammarLexer(CharStreams.fromString(text));
    parser = new KrlGrammarParser(new LineTokens(lexer, List.of()));
    parser.removeErrorListeners();
    parser.setErrorHandler(new FirstError(parser.getATN()));
    // Only operators need prediction, and this mode is exact for them.
    parser.getInterpreter().setPredictionMode(PredictionMode.SLL);
  }

  /** Returns the next line that is not blank; null at the end of the file. */
  @Nullable Line next() {
    while (end == null) {
      Line line = read();
      if (line.tokens().size() > 1) {
        return line;
      }
    }
    return null;
  }

  /** Returns the end-of-file token. */
  Token end() {
    if (end == null) {
      throw new IllegalStateException("there are more lines");
    }
    return end;
  }

  private Line read() {
    List<Token> tokens = new ArrayList<>(USUAL_LENGTH);
    String comment = "";
    while (true) {
      Token token = lexer.nextToken();
      if (token.getChannel() == Token.DEFAULT_CHANNEL) {
        tokens.add(token);
      } else if (token.getType() == KrlGrammarLexer.COMMENT) {
        comment = token.getText().substring(1).strip();
      }
      if (token.getType() == Token.EOF) {
        end = token;
      }
      if (token.getType() == Token.EOF || token.getType() == KrlGrammarLexer.NEWLINE) {
        Line line = new Line(parser, tokens, comment);
        StatementWords.mark(line);
        return line;
      }
    }
  }
}
