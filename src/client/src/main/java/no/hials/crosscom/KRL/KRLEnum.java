package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/** Holds a value of an ENUM, such as {@code #T1}. */
public class KRLEnum extends ScannedVariable {
  private String value = "";
  private boolean present;
  private final String typeForPeople;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLEnum(String name) {
    this(name, "ENUM");
  }

  KRLEnum(String name, String typeForPeople) {
    super(name);
    this.typeForPeople = typeForPeople;
  }

  @Override
  String typeForPeople() {
    return typeForPeople;
  }

  @Override
  public @Nullable String getValue() {
    return present ? value : null;
  }

  /**
   * Returns the local value, with the {@code #}.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public String stringValue() {
    if (!present) {
      throw noValue();
    }
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the value, with or without the {@code #}
   * @throws IllegalArgumentException if the value is not a name
   */
  public void setValue(String newValue) {
    value = "#" + new KrlEnum(newValue.startsWith("#") ? newValue.substring(1) : newValue).name();
    present = true;
  }

  @Override
  public String getStringValue() {
    return stringValue();
  }

  @Override
  void read(KrlScanner scanner) {
    String read = "#" + scanner.readEnum();
    scanner.expectEnd();
    value = read;
    present = true;
  }
}
