package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlString;
import org.jspecify.annotations.Nullable;

/**
 * Holds the text of a CHAR array, such as {@code $MODEL_NAME[]}.
 *
 * <p>A controller prints an empty CHAR array as one blank (krl.md 1.1), so one blank is read as the
 * empty text.
 */
public class KRLString extends ScannedVariable {
  private @Nullable String value;

  /**
   * Makes a variable without a value.
   *
   * @param name the name on the controller; {@code []} is put behind it if it has no brackets
   */
  public KRLString(String name) {
    super(wholeArray(name));
  }

  @Override
  boolean holdsText() {
    return true;
  }

  @Override
  public @Nullable String getValue() {
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the text, without the quotes around it; no longer than the array on the
   *     controller; without double quotes, which no KRL literal can hold
   */
  public void setValue(String newValue) {
    value = new KrlString(newValue).text();
  }

  @Override
  public String getStringValue() {
    if (value == null) {
      throw noValue();
    }
    // an empty literal is written as the controller prints it
    return new KrlString(value.isEmpty() ? " " : value).print();
  }

  @Override
  void read(KrlScanner scanner) {
    String read = scanner.readString();
    scanner.expectEnd();
    value = read.equals(" ") ? "" : read;
  }
}
