package no.hials.crosscom.lang.internal;

import java.util.BitSet;
import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.InputMismatchException;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.ATN;
import org.antlr.v4.runtime.atn.ATNState;
import org.antlr.v4.runtime.atn.RuleTransition;
import org.jspecify.annotations.Nullable;

/**
 * Ends the parse of a line at its first error. ANTLR's own strategy guesses the intended token and
 * continues, and then also reports the errors that follow from a wrong guess.
 */
public final class FirstError extends BailErrorStrategy {
  /** The tokens that can follow each state of the parser; null if not yet asked. */
  private final @Nullable BitSet[] next;

  /** Creates the strategy of a parser. */
  public FirstError(ATN atn) {
    next = new BitSet[atn.states.size()];
  }

  @Override
  public void sync(Parser parser) {
    // Checked before an optional token is skipped, so that the message lists that token too.
    if (!isExpected(parser, parser.getInputStream().LA(1))) {
      throw new InputMismatchException(parser);
    }
  }

  /** Equals {@code getExpectedTokens().contains(token)}, but builds no set. */
  private boolean isExpected(Parser parser, int token) {
    ATN atn = parser.getATN();
    RuleContext rule = parser.getContext();
    BitSet expected = next(atn.states.get(parser.getState()));
    while (!expected.get(token - Token.EPSILON)) {
      if (!expected.get(0) || rule.isEmpty()) {
        return false;
      }
      RuleTransition call = (RuleTransition) atn.states.get(rule.invokingState).transition(0);
      expected = next(call.followState);
      rule = rule.parent;
    }
    return true;
  }

  /** Returns the tokens that can follow a state; bit 0 is {@link Token#EPSILON}. */
  private BitSet next(ATNState state) {
    BitSet known = next[state.stateNumber];
    if (known == null) {
      known = new BitSet();
      for (int token : state.atn.nextTokens(state).toSet()) {
        known.set(token - Token.EPSILON);
      }
      next[state.stateNumber] = known;
    }
    return known;
  }
}
