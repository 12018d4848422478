package no.hials.crosscom.KRL;

import java.util.Objects;
import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/**
 * Holds a STRUC of the user's own as a Java record. One access reads or writes all of it, and costs
 * about the same as that of a single number.
 *
 * <p>Each component of the record stands for the field of the same name, whatever its case, or of
 * the name that {@link KrlName} gives:
 *
 * <table>
 * <caption>Types of components</caption>
 * <tr><th>KRL</th><th>Java</th></tr>
 * <tr><td>INT</td><td>{@code int}</td></tr>
 * <tr><td>REAL</td><td>{@code double}, {@code float}</td></tr>
 * <tr><td>BOOL</td><td>{@code boolean}</td></tr>
 * <tr><td>CHAR</td><td>{@code char}</td></tr>
 * <tr><td>CHAR[n]</td><td>{@code String}; one blank is the empty text</td></tr>
 * <tr><td>ENUM</td><td>an enum</td></tr>
 * <tr><td>FRAME, POS, E6POS, AXIS, E6AXIS</td><td>{@code KRLFrame}, {@code KRLPos}, ...</td></tr>
 * <tr><td>STRUC</td><td>a record</td></tr>
 * <tr><td>array of INT, REAL, BOOL or ENUM with one dimension</td><td>an array</td></tr>
 * </table>
 *
 * <p>A controller does not print a field that is not initialised. That is an error, unless the
 * component is an {@link java.util.Optional} of such a type; a primitive one is then boxed, as in
 * {@code Optional<Integer>}. An empty one is not written, so that the controller leaves the field
 * as it is. A KRLFrame and its like are never an error when part of them is missing: their getters
 * throw, and what is missing is not written. Those components can be changed in place, and do not
 * take part in the record's {@code equals} by value; where that matters, map the FRAME to a record.
 *
 * <p>Assumed, since no real controller's answer with a numeric array in a structure is known: it is
 * printed and written as {@code A[] 1 2 3}. If some elements are not initialised, a list {@code
 * A[1] 1, A[2] 2} is read, too, which must begin with 1 and have no gap.
 *
 * <p>Every error in a field names its path, such as {@code MYWELD.SEAM.X}. The record's constructor
 * runs when the variable is read, so it may check values; no lock is held then.
 *
 * @param <T> the record
 */
public final class KRLRecord<T extends Record> extends KRLVariable {
  private final Class<T> type;
  private final RecordShape shape;
  private @Nullable T value;

  /** What the last write sent. */
  private @Nullable String sent;

  /**
   * Makes a variable without a value.
   *
   * @param name the name on the controller
   * @param type the record's class; it need not be public, but if it is in a named module, its
   *     package must be open to this one
   * @throws IllegalArgumentException if a component cannot be mapped; it names class and component
   */
  public KRLRecord(String name, Class<T> type) {
    super(name);
    this.type = Objects.requireNonNull(type, "type");
    this.shape = RecordShape.of(type);
  }

  @Override
  boolean holdsText() {
    return true;
  }

  @Override
  public @Nullable T getValue() {
    return value;
  }

  /**
   * Gives the local value.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public T recordValue() {
    if (value == null) {
      throw noValue();
    }
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the value, whose arrays and frames are not copied
   * @throws IllegalArgumentException if the value of a component cannot be written: a number that
   *     is NaN, infinite or too large for a 32-bit float, a text with a double quote or not ISO
   *     8859-1, an array without elements, or null; the local value is as before
   */
  public void setValue(T newValue) {
    print(Objects.requireNonNull(newValue, "newValue"));
    value = newValue;
  }

  private String print(T printed) {
    StringBuilder text = new StringBuilder(255);
    shape.print(text, printed, getName());
    return text.toString();
  }

  /**
   * Gives the text that writes the structure.
   *
   * @return an aggregate of all components but those that are empty
   * @throws IllegalStateException if there is no value, or all components are empty
   * @throws IllegalArgumentException if a part that can be changed in place has become one that
   *     cannot be written
   */
  @Override
  public String getStringValue() {
    String text = print(recordValue());
    if (text.equals("{}")) {
      throw new IllegalStateException(getName() + " has no field to write: all are empty");
    }
    sent = text;
    return text;
  }

  /**
   * Keeps the record if what was written is what was sent, so that its frames and arrays stay those
   * of the program. Otherwise the text is read by {@link #setValueFromString}: the record's
   * constructor is the program's own code, which does not run under the client's lock.
   */
  @Override
  protected boolean setValueFrom(KrlScanner scanner, boolean written) {
    return written && sent != null && sent.contentEquals(scanner.text());
  }

  @Override
  protected void setValueFromString(String strValue) {
    KrlScanner scanner = new KrlScanner(strValue);
    Record read = shape.read(scanner, getName());
    value = type.cast(read);
  }
}
