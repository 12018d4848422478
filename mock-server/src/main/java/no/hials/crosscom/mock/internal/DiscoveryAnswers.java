package no.hials.crosscom.mock.internal;

import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/**
 * Answers the questions of discovery (docs/reference/wire-format.md#discovery): {@code
 * WHEREAREYOU?}, and for C3 Bridge, in both modes, the names of its proxy variables.
 */
public final class DiscoveryAnswers {
  private static final String QUESTION = "WHEREAREYOU?";

  /** The bytes of a question that C3 Bridge reads (docs/reference/wire-format.md#discovery). */
  private static final int MAX_LENGTH = 32;

  private final VariableTable variables;
  private final @Nullable C3ProxyVariables bridge;

  /**
   * Creates the answers of one server.
   *
   * @param bridge the proxy variables of C3 Bridge, null for KUKAVARPROXY
   */
  public DiscoveryAnswers(VariableTable variables, @Nullable C3ProxyVariables bridge) {
    this.variables = variables;
    this.bridge = bridge;
  }

  /** Returns the answer to a datagram, null for none. */
  @Nullable String to(String datagram) {
    if (bridge == null) {
      return datagram.equals(QUESTION) ? where(DiscoveryAnswers::plain) : null;
    }
    String asked = question(datagram);
    return asked.equals(QUESTION) ? where(String::valueOf) : bridge.findProxy(asked);
  }

  /** A 0 ends the question (docs/reference/wire-format.md#discovery). */
  private static String question(String datagram) {
    String text = datagram.substring(0, Math.min(MAX_LENGTH, datagram.length()));
    int end = text.indexOf(0);
    return end < 0 ? text : text.substring(0, end);
  }

  private String where(Function<KrlValue, String> print) {
    return "KUKA|"
        + orEmpty(() -> print.apply(variables.value("$MODEL_NAME[]")))
        + "|"
        + orEmpty(() -> print.apply(variables.value("$KR_SERIALNO")));
  }

  /** Returns a text without its quotes (assumed). */
  private static String plain(KrlValue value) {
    return value instanceof KrlString string ? string.text() : value.toString();
  }

  /** Returns an empty field if the variable cannot be read. */
  private static String orEmpty(Supplier<String> field) {
    try {
      return field.get();
    } catch (IllegalArgumentException e) {
      return "";
    }
  }
}
