package no.hials.crosscom.lang;

import java.util.Locale;
import java.util.Set;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;

/**
 * Knows the statements of KRL that are not supported, so that they are told from unknown ones
 * (splines: krl.md 4; the others assumed to be complete).
 */
final class UnsupportedStatements {
  private static final Set<String> WORDS =
      Set.of(
          "ANIN",
          "ANOUT",
          "ASYCANCEL",
          "ASYCONT",
          "ASYPTP",
          "ASYSTOP",
          "CHANNEL",
          "CONFIRM",
          "CONST_VEL",
          "ENDSPLINE",
          "EXTFCTP",
          "EXTP",
          "PTP_SPLINE",
          "SCIRC",
          "SCIRC_REL",
          "SLIN",
          "SLIN_REL",
          "SPL",
          "SPLINE",
          "SPL_REL",
          "SPTP",
          "SPTP_REL",
          "STOP",
          "TIME_BLOCK");

  private UnsupportedStatements() {}

  /** Says whether a line is one. */
  static boolean contain(Line line) {
    return WORDS.contains(upper(line.keyword())) && !isName(line);
  }

  /** Says whether its word is a variable, a subprogram or a label that is called so. */
  private static boolean isName(Line line) {
    int behind = line.second().getType();
    return line.keyword() == line.first()
        && Line.BEHIND_A_NAME.contains(behind)
        && (behind != KrlGrammarParser.COLON || line.tokens().size() == 3);
  }

  /** Says whether a line begins what {@code ENDSPLINE} ends. */
  static boolean beginSpline(Line line) {
    return upper(line.first()).equals("SPLINE") || upper(line.first()).equals("PTP_SPLINE");
  }

  /** Says whether a line is an {@code ENDSPLINE}. */
  static boolean endSpline(Line line) {
    return upper(line.first()).equals("ENDSPLINE");
  }

  static void report(Line line, Errors errors) {
    errors.add(line.keyword(), upper(line.keyword()) + " is not supported");
  }

  private static String upper(Token token) {
    return token.getText().toUpperCase(Locale.ROOT);
  }
}
