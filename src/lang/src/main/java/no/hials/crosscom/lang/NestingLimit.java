package no.hials.crosscom.lang;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;

/**
 * Bounds the depth of expressions before they are parsed: parser, builder and whoever walks the
 * tree are recursive, and a hostile line must not exhaust their stack.
 */
final class NestingLimit {
  /** No line of a real program comes near. */
  static final int MAX = 250;

  private NestingLimit() {}

  /** Says whether the expressions of a line are flat enough, and reports where they are not. */
  static boolean holds(List<Token> tokens, Errors errors) {
    // Of each open bracket: the deepest element so far, and the one being read. Operators count
    // as if each were nested in the one before, which left to right they are.
    Deque<int[]> open = new ArrayDeque<>();
    int deepest = 0;
    int depth = 0;
    for (Token token : tokens) {
      switch (token.getType()) {
        case KrlGrammarParser.LEFT_PARENTHESIS,
            KrlGrammarParser.LEFT_BRACKET,
            KrlGrammarParser.LEFT_BRACE -> {
          open.push(new int[] {deepest, depth});
          deepest = 0;
          depth = 0;
        }
        case KrlGrammarParser.RIGHT_PARENTHESIS,
            KrlGrammarParser.RIGHT_BRACKET,
            KrlGrammarParser.RIGHT_BRACE -> {
          int inside = Math.max(deepest, depth);
          int[] outside = open.isEmpty() ? new int[2] : open.pop();
          deepest = outside[0];
          depth = outside[1] + inside + 1;
        }
        case KrlGrammarParser.COMMA -> {
          deepest = Math.max(deepest, depth);
          depth = 0;
        }
        default -> depth += ErrorWords.OPERATORS.contains(token.getType()) ? 1 : 0;
      }
      if (depth + open.size() > MAX) {
        errors.add(token, "an expression of more than " + MAX + " operators and brackets");
        return false;
      }
    }
    return true;
  }
}
