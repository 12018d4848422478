package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlString;
import org.jspecify.annotations.Nullable;

/** Holds a CHAR: one character, printed in double quotes. */
public class KRLChar extends ScannedVariable {
  private char value;
  private boolean present;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLChar(String name) {
    super(name);
  }

  @Override
  String typeForPeople() {
    return "CHAR";
  }

  @Override
  public @Nullable Character getValue() {
    return present ? value : null;
  }

  /**
   * Returns the local value, without creating an object.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public char charValue() {
    if (!present) {
      throw noValue();
    }
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the character, but not a double quote, which KRL literals cannot contain
   */
  public void setValue(char newValue) {
    value = new KrlString(String.valueOf(newValue)).text().charAt(0);
    present = true;
  }

  @Override
  public String getStringValue() {
    return new KrlString(String.valueOf(charValue())).print();
  }

  @Override
  void read(KrlScanner scanner) {
    int start = scanner.position();
    String read = scanner.readString();
    scanner.expectEnd();
    if (read.length() != 1) {
      throw scanner.wrongAt(start, "one character in double quotes");
    }
    value = read.charAt(0);
    present = true;
  }
}
