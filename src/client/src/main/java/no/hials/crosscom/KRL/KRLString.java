package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlString;
import org.jspecify.annotations.Nullable;

/**
 * Holds the text of a CHAR array, such as {@code $MODEL_NAME[]}.
 *
 * <p>A controller prints an empty CHAR array as one blank, so one blank is read as the empty text
 * (docs/reference/krl-values.md#scalars).
 */
public class KRLString extends ScannedVariable {
  private @Nullable String value;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller; {@code []} is appended if it has no brackets
   */
  public KRLString(String name) {
    super(wholeArray(name));
  }

  @Override
  String typeForPeople() {
    return "CHAR array";
  }

  @Override
  public @Nullable String getValue() {
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the text without quotes around it; at most as long as the array on the
   *     controller; without double quotes, which KRL literals cannot contain
   */
  public void setValue(String newValue) {
    value = new KrlString(newValue).text();
  }

  @Override
  public String getStringValue() {
    if (value == null) {
      throw noValue();
    }
    // the controller prints an empty text as one blank
    return new KrlString(value.isEmpty() ? " " : value).print();
  }

  @Override
  void read(KrlScanner scanner) {
    String read = scanner.readString();
    scanner.expectEnd();
    value = read.equals(" ") ? "" : read;
  }
}
