package no.hials.crosscom.lang;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.InputMismatchException;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.ATN;
import org.antlr.v4.runtime.atn.RuleTransition;
import org.antlr.v4.runtime.misc.IntervalSet;

/**
 * Ends the parse of a line at its first error. ANTLR's own strategy guesses the intended token and
 * continues, and then also reports the errors that follow from a wrong guess.
 */
final class FirstError extends BailErrorStrategy {
  @Override
  public void sync(Parser parser) {
    // Checked before an optional token is skipped, so that the message lists that token too.
    if (!isExpected(parser, parser.getInputStream().LA(1))) {
      throw new InputMismatchException(parser);
    }
  }

  /** Equals {@code getExpectedTokens().contains(token)}, but builds no set. */
  private static boolean isExpected(Parser parser, int token) {
    ATN atn = parser.getATN();
    RuleContext rule = parser.getContext();
    IntervalSet next = atn.nextTokens(atn.states.get(parser.getState()));
    while (!next.contains(token)) {
      if (!next.contains(Token.EPSILON) || rule.isEmpty()) {
        return false;
      }
      RuleTransition call = (RuleTransition) atn.states.get(rule.invokingState).transition(0);
      next = atn.nextTokens(call.followState);
      rule = rule.parent;
    }
    return true;
  }
}
