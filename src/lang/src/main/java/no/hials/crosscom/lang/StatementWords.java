package no.hials.crosscom.lang;

import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.WritableToken;

/**
 * The words that begin a statement or declaration of newer KRL. Older programs use them as names,
 * so they are keywords only at the beginning of a line and only if no name fits there.
 */
final class StatementWords {
  private static final Map<String, Integer> KEYWORDS =
      Map.ofEntries(
          Map.entry("ANIN", KrlGrammarParser.ANIN),
          Map.entry("ANOUT", KrlGrammarParser.ANOUT),
          Map.entry("CHANNEL", KrlGrammarParser.CHANNEL),
          Map.entry("CONFIRM", KrlGrammarParser.CONFIRM),
          Map.entry("CONST_VEL", KrlGrammarParser.CONST_VEL),
          Map.entry("ENDSPLINE", KrlGrammarParser.ENDSPLINE),
          Map.entry("EXTFCTP", KrlGrammarParser.EXTFCT),
          Map.entry("EXTP", KrlGrammarParser.EXT),
          Map.entry("ON_ERROR_PROCEED", KrlGrammarParser.ON_ERROR_PROCEED),
          Map.entry("PTP_SPLINE", KrlGrammarParser.SPLINE),
          Map.entry("SCIRC", KrlGrammarParser.SCIRC),
          Map.entry("SCIRC_REL", KrlGrammarParser.SCIRC_REL),
          Map.entry("SLIN", KrlGrammarParser.SLIN),
          Map.entry("SLIN_REL", KrlGrammarParser.SLIN_REL),
          Map.entry("SPL", KrlGrammarParser.SPL),
          Map.entry("SPLINE", KrlGrammarParser.SPLINE),
          Map.entry("SPL_REL", KrlGrammarParser.SPL_REL),
          Map.entry("SPTP", KrlGrammarParser.SPTP),
          Map.entry("SPTP_REL", KrlGrammarParser.SPTP_REL),
          Map.entry("STOP", KrlGrammarParser.STOP),
          Map.entry("TIME_BLOCK", KrlGrammarParser.TIME_BLOCK));

  /** Assumed to be complete. */
  private static final Set<String> UNSUPPORTED =
      Set.of("ASYCANCEL", "ASYCONT", "ASYPTP", "ASYSTOP");

  /** Motions, whose target can begin with a parenthesis. */
  private static final Set<Integer> MOTIONS =
      Set.of(
          KrlGrammarParser.SCIRC,
          KrlGrammarParser.SCIRC_REL,
          KrlGrammarParser.SLIN,
          KrlGrammarParser.SLIN_REL,
          KrlGrammarParser.SPTP,
          KrlGrammarParser.SPTP_REL);

  private StatementWords() {}

  /** Turns the name that begins a line into the keyword that it is there. */
  static void mark(Line line) {
    Token word = line.keyword();
    if (word.getType() == KrlGrammarParser.NAME) {
      Integer keyword = KEYWORDS.get(ErrorWords.upper(word));
      if (keyword != null && !isName(line, keyword)) {
        ((WritableToken) word).setType(keyword);
      }
    }
  }

  /** Returns whether a line is a statement of KRL that is not supported. */
  static boolean isUnsupported(Line line) {
    Token word = line.keyword();
    return word.getType() == KrlGrammarParser.NAME
        && UNSUPPORTED.contains(ErrorWords.upper(word))
        && !isName(line, 0);
  }

  /** Returns whether the keyword is the name of a variable, subprogram or label here. */
  private static boolean isName(Line line, int keyword) {
    List<Token> tokens = line.tokens();
    int next = line.second().getType();
    return switch (next) {
      case KrlGrammarParser.COLON -> line.keyword() == line.first() && tokens.size() == 3;
      case KrlGrammarParser.LEFT_PARENTHESIS -> !MOTIONS.contains(keyword);
      default -> line.keyword() == line.first() && Line.AFTER_A_NAME.contains(next);
    };
  }
}
