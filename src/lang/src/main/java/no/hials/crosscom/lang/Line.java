package no.hials.crosscom.lang;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import no.hials.crosscom.lang.internal.LineTokens;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.jspecify.annotations.Nullable;

/**
 * A line that is not blank.
 *
 * @param parser parses the tokens
 * @param tokens the tokens without blanks and comments; the last is the end of the line
 * @param comment the comment, without {@code ;}; empty without a comment
 */
record Line(KrlGrammarParser parser, List<Token> tokens, String comment) {
  /** The types that need no {@code DECL} (docs/reference/krl-language.md#declarations). */
  private static final Set<String> BASE_TYPES =
      Set.of(
          "INT", "REAL", "BOOL", "CHAR", "FRAME", "POS", "E3POS", "E6POS", "AXIS", "E3AXIS",
          "E6AXIS");

  /** The tokens that can follow the first name of an assignment, a call or a label. */
  static final Set<Integer> AFTER_A_NAME =
      Set.of(
          KrlGrammarParser.ASSIGN,
          KrlGrammarParser.COLON,
          KrlGrammarParser.DOT,
          KrlGrammarParser.LEFT_BRACKET,
          KrlGrammarParser.LEFT_PARENTHESIS);

  Token first() {
    return tokens.get(0);
  }

  Token second() {
    return tokens.get(1);
  }

  /** Returns the token that determines the kind of line. */
  Token keyword() {
    for (Token token : tokens) {
      int type = token.getType();
      if (type != KrlGrammarParser.GLOBAL
          && type != KrlGrammarParser.DECL
          && type != KrlGrammarParser.CONST) {
        return token;
      }
    }
    throw new IllegalStateException("a line without its end");
  }

  /** Returns whether the line starts with a name and is neither a statement nor a declaration. */
  boolean isUnknown() {
    return ErrorWords.isName(first())
        && !AFTER_A_NAME.contains(second().getType())
        && !BASE_TYPES.contains(first().getText().toUpperCase(Locale.ROOT));
  }

  /** Returns whether the line begins as a declaration does. */
  boolean isDeclaration() {
    return switch (keyword().getType()) {
      case KrlGrammarParser.STRUC,
          KrlGrammarParser.ENUM,
          KrlGrammarParser.SIGNAL,
          KrlGrammarParser.CHANNEL,
          KrlGrammarParser.EXT,
          KrlGrammarParser.EXTFCT,
          KrlGrammarParser.IMPORT ->
          true;
      case KrlGrammarParser.INTERRUPT -> false;
      default ->
          keyword() != first()
              || (BASE_TYPES.contains(first().getText().toUpperCase(Locale.ROOT))
                  && !AFTER_A_NAME.contains(second().getType()));
    };
  }

  /** Returns whether the line is one word, as a mistyped {@code ENDIF} is. */
  boolean isOneWord() {
    return tokens.size() == 2;
  }

  /**
   * Parses the line.
   *
   * @param errors receives the error
   * @return null if there is an error
   */
  @Nullable ContentContext parse(Errors errors) {
    if (!NestingLimit.holds(tokens, errors)) {
      return null;
    }
    parser.setTokenStream(new LineTokens(parser.getTokenStream().getTokenSource(), tokens));
    try {
      return parser.line().content();
    } catch (ParseCancellationException e) {
      RecognitionException cause = (RecognitionException) Objects.requireNonNull(e.getCause());
      ErrorWords.report(cause, this, errors);
      return null;
    }
  }
}
