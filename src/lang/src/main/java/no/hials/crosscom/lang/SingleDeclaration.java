package no.hials.crosscom.lang;

import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.WritableToken;
import org.jspecify.annotations.Nullable;

/** Parses a declaration that is not in a file. Its names can be keywords, and of any length. */
final class SingleDeclaration {
  /** The keywords that a declaration begins with. */
  private static final Set<Integer> FIRST = Set.of(KrlGrammarParser.SIGNAL, KrlGrammarParser.STRUC);

  /** The keywords of a wiring. */
  private static final Set<Integer> WIRING = Set.of(KrlGrammarParser.TO, KrlGrammarParser.FALSE);

  private SingleDeclaration() {}

  /** Returns the declaration, or null after an error. */
  static @Nullable Declaration parse(String text, Errors errors) {
    LineReader lines = new LineReader(text);
    Line line = lines.next();
    if (line == null || lines.next() != null || text.indexOf(';') >= 0) {
      errors.add(errors.start(), "expected one declaration without a comment");
      return null;
    }
    freeKeywords(line.tokens());
    ContentContext content = line.parse(errors);
    if (content == null) {
      return null;
    }
    Declaration declaration =
        new DeclarationBuilder(errors, new ExpressionBuilder(errors), false, Integer.MAX_VALUE)
            .build(content, "");
    if (declaration == null) {
      errors.add(line.first(), "expected a declaration, found " + ErrorWords.found(line.first()));
    }
    return declaration;
  }

  /** Turns keywords into names, except the first one and those of a wiring. */
  private static void freeKeywords(List<Token> tokens) {
    int first = tokens.get(0).getType();
    boolean isSignal = first == KrlGrammarParser.SIGNAL;
    for (int i = FIRST.contains(first) ? 1 : 0; i < tokens.size() - 1; i++) {
      Token token = tokens.get(i);
      boolean isKeyword = Character.isLetter(token.getText().charAt(0));
      if (isKeyword && !(isSignal && i > 1 && WIRING.contains(token.getType()))) {
        ((WritableToken) token).setType(KrlGrammarParser.NAME);
      }
    }
  }
}
