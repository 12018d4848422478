package no.hials.crosscom.lang;

import java.util.Set;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;

/**
 * The KRL statements that are not supported, as distinct from unknown statements
 * (docs/reference/krl-language.md#motions). The list is assumed to be complete.
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

  /** Returns whether a line is an unsupported statement. */
  static boolean contain(Line line) {
    return WORDS.contains(ErrorWords.upper(line.keyword())) && !isName(line);
  }

  /** Returns whether the keyword is the name of a variable, subprogram or label here. */
  private static boolean isName(Line line) {
    int next = line.second().getType();
    return line.keyword() == line.first()
        && Line.AFTER_A_NAME.contains(next)
        && (next != KrlGrammarParser.COLON || line.tokens().size() == 3);
  }

  /** Returns whether a line starts a spline block. */
  static boolean beginSpline(Line line) {
    return ErrorWords.upper(line.first()).equals("SPLINE")
        || ErrorWords.upper(line.first()).equals("PTP_SPLINE");
  }

  /** Returns whether a line ends a spline block. */
  static boolean endSpline(Line line) {
    return ErrorWords.upper(line.first()).equals("ENDSPLINE");
  }

  static void report(Line line, Errors errors) {
    errors.add(line.keyword(), ErrorWords.upper(line.keyword()) + " is not supported");
  }
}
