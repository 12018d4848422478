package no.hials.crosscom.lang;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;

/**
 * Limits the depth of expressions before they are parsed. The parser, the builder and code that
 * walks the tree are recursive; a hostile line must not exhaust their stack.
 */
final class NestingLimit {
  /** Far above any line of a real program. */
  static final int MAX = 250;

  private NestingLimit() {}

  /**
   * Returns whether the expressions of a line are within the limit, and reports where they exceed
   * it.
   */
  static boolean holds(List<Token> tokens, Errors errors) {
    // For each open bracket: the depth of the deepest element so far, and of the current element.
    // Each operator counts as nested in the previous operator, as left-to-right evaluation does.
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
        default -> depth += ErrorWords.isOperator(token) ? 1 : 0;
      }
      if (depth + open.size() > MAX) {
        errors.add(token, "an expression with more than " + MAX + " operators and brackets");
        return false;
      }
    }
    return true;
  }
}
