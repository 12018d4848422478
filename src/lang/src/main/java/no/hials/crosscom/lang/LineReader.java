package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarLexer;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.PredictionMode;
import org.jspecify.annotations.Nullable;

/** Cuts a file into lines of tokens. */
final class LineReader {
  private final KrlGrammarLexer lexer;
  private final KrlGrammarParser parser;
  private @Nullable Token end;

  LineReader(String text) {
    lexer = new KrlGrammarLexer(CharStreams.fromString(text));
    parser = new KrlGrammarParser(new CommonTokenStream(lexer));
    parser.removeErrorListeners();
    parser.setErrorHandler(new FirstError());
    // Only operators are looked up in the prediction tables, and for them this mode is exact.
    parser.getInterpreter().setPredictionMode(PredictionMode.SLL);
  }

  /** Gives the next line with something on it; null at the end. */
  @Nullable Line next() {
    while (end == null) {
      Line line = read();
      if (line.tokens().size() > 1) {
        return line;
      }
    }
    return null;
  }

  /** Gives the token at the end of the file. */
  Token end() {
    if (end == null) {
      throw new IllegalStateException("there are lines left");
    }
    return end;
  }

  private Line read() {
    List<Token> tokens = new ArrayList<>();
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
        return new Line(parser, tokens, comment);
      }
    }
  }
}
