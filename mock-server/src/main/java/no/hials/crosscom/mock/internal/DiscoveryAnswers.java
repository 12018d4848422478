package no.hials.crosscom.mock.internal;

import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/**
 * Knows the answer to the question where controllers are (docs/reference/wire-format.md#discovery),
 * and with C3 Bridge to questions for what it says of itself
 * (docs/reference/wire-format.md#discovery; in both modes, as in c3-vectors.tsv).
 */
public final class DiscoveryAnswers {
  private static final String QUESTION = "WHEREAREYOU?";

  /**
   * The most bytes of a question. What C3 Bridge gets of a longer one
   * (docs/reference/wire-format.md#discovery).
   */
  private static final int LONGEST = 32;

  private final VariableTable variables;
  private final @Nullable C3ProxyVariables bridge;

  /**
   * Makes the answers.
   *
   * @param bridge what C3 Bridge says of itself; null for a KUKAVARPROXY
   */
  public DiscoveryAnswers(VariableTable variables, @Nullable C3ProxyVariables bridge) {
    this.variables = variables;
    this.bridge = bridge;
  }

  /** Gives the answer to a datagram, or null if it gets none. */
  @Nullable String to(String datagram) {
    if (bridge == null) {
      return datagram.equals(QUESTION) ? where(DiscoveryAnswers::plain) : null;
    }
    String asked = question(datagram);
    return asked.equals(QUESTION) ? where(String::valueOf) : bridge.findProxy(asked);
  }

  /** c3-vectors.tsv, "udp7000 @PROXY_TYPE NUL + 40 bytes": a 0 ends the question. */
  private static String question(String datagram) {
    String text = datagram.substring(0, Math.min(LONGEST, datagram.length()));
    int end = text.indexOf(0);
    return end < 0 ? text : text.substring(0, end);
  }

  private String where(Function<KrlValue, String> print) {
    return "KUKA|"
        + orNothing(() -> print.apply(variables.value("$MODEL_NAME[]")))
        + "|"
        + orNothing(() -> print.apply(variables.value("$KR_SERIALNO")));
  }

  /**
   * Gives a text without its quotes. Assumed: docs/reference/wire-format.md#discovery shows neither
   * with nor without.
   */
  private static String plain(KrlValue value) {
    return value instanceof KrlString string ? string.text() : value.toString();
  }

  /**
   * Leaves a field empty whose variable cannot be read (docs/reference/wire-format.md#discovery).
   */
  private static String orNothing(Supplier<String> field) {
    try {
      return field.get();
    } catch (IllegalArgumentException e) {
      return "";
    }
  }
}
