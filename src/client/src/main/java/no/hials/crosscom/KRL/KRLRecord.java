package no.hials.crosscom.KRL;

import java.util.Objects;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/**
 * Holds a user's own STRUC as a Java record. One access reads or writes the whole STRUC, and costs
 * about the same as an access to a single number.
 *
 * <p>Each component of the record maps to the field of the same name, ignoring case, or of the name
 * in {@link KrlName}:
 *
 * <table>
 * <caption>Types of components</caption>
 * <tr><th>KRL</th><th>Java</th></tr>
 * <tr><td>INT</td><td>{@code int}</td></tr>
 * <tr><td>REAL</td><td>{@code double}, {@code float}</td></tr>
 * <tr><td>BOOL</td><td>{@code boolean}</td></tr>
 * <tr><td>CHAR</td><td>{@code char}</td></tr>
 * <tr><td>CHAR[n]</td><td>{@code String}; a single blank is the empty text</td></tr>
 * <tr><td>ENUM</td><td>an enum</td></tr>
 * <tr><td>FRAME, POS, E6POS, AXIS, E6AXIS, LOAD</td><td>{@code Frame}, {@code Pos}, ... of {@link
 * no.hials.crosscom.protocol.value}</td></tr>
 * <tr><td>FRAME, POS, E6POS, AXIS, E6AXIS</td><td>{@code KRLFrame}, {@code KRLPos}, ...</td></tr>
 * <tr><td>STRUC</td><td>a record</td></tr>
 * <tr><td>array of INT, REAL, BOOL or ENUM with one dimension</td><td>an array</td></tr>
 * </table>
 *
 * <p>Fields without a component are ignored, and not written, so that a {@code Frame} can be read
 * from an E6POS. A REAL read as {@code double} is the double nearest to the printed digits; a
 * {@code float} is the controller's 32-bit value.
 *
 * <p>A controller does not print a field that is not initialised. That is an error, unless the
 * component is an {@link java.util.Optional} of such a type; primitive types are then boxed, as in
 * {@code Optional<Integer>}. An empty optional is not written, so the field stays unchanged on the
 * controller. Missing fields of a KRLFrame or similar structure are not an error: their getters
 * throw, and they are not written. Such a component can be changed in place, and the record's
 * {@code equals} does not compare its value; if that matters, map the FRAME to a record.
 *
 * <p>Assumed, since no answer of a real controller with a numeric array in a structure is known:
 * the array is printed and written as {@code A[] 1 2 3}. For arrays with elements that are not
 * initialised, a list {@code A[1] 1, A[2] 2} is also read; it must start with 1 and have no gap.
 *
 * <p>Every error in a field names its path, such as {@code MYWELD.SEAM.X}. The record's constructor
 * runs when the variable is read, without a lock, so it may check values.
 *
 * @param <T> the record
 */
public final class KRLRecord<T extends Record> extends KRLVariable {
  private final Class<T> type;
  private final RecordShape shape;
  private final boolean recordHoldsText;
  private final @Nullable NumberShape numbers;
  private final double[] scratch;
  private @Nullable T value;

  /** The text of the last write. */
  private @Nullable String sent;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   * @param type the record's class; it need not be public, but in a named module its package must
   *     be open to this module
   * @throws IllegalArgumentException if a component cannot be mapped; the message names class and
   *     component
   */
  public KRLRecord(String name, Class<T> type) {
    super(name);
    this.type = Objects.requireNonNull(type, "type");
    this.shape = RecordShape.of(type);
    this.recordHoldsText = shape.holdsText();
    this.numbers = NumberShape.of(type);
    this.scratch = numbers == null ? new double[0] : numbers.scratch();
  }

  @Override
  String typeForPeople() {
    return type.getSimpleName();
  }

  @Override
  protected boolean holdsText() {
    return recordHoldsText;
  }

  @Override
  public @Nullable T getValue() {
    return value;
  }

  /**
   * Returns the local value.
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
   * @param newValue the value; its arrays and frames are not copied
   * @throws IllegalArgumentException if the value of a component cannot be written: a number that
   *     is NaN, infinite or too large for a 32-bit float, a text with a double quote, an empty
   *     array, or null; the local value is then unchanged
   */
  public void setValue(T newValue) {
    Objects.requireNonNull(newValue, "newValue");
    if (numbers != null) {
      numbers.check(newValue, getName());
    } else {
      print(newValue);
    }
    value = newValue;
  }

  private String print(T printed) {
    StringBuilder text = new StringBuilder(255);
    shape.print(text, printed, getName());
    return text.toString();
  }

  /**
   * Returns the text that writes the structure.
   *
   * @return an aggregate of all components that are not empty
   * @throws IllegalStateException without a value, or if all components are empty
   * @throws IllegalArgumentException if a component that was changed in place cannot be written
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

  @Override
  protected boolean appendValue(KrlText text) {
    if (numbers == null) {
      return false;
    }
    numbers.print(text, recordValue());
    return true;
  }

  /**
   * Sets a record of numbers in place. Keeps another record if the text is the text of the last
   * write, so that the record keeps the program's frames and arrays. Otherwise {@link
   * #setValueFromString} reads the text: the record's constructor is the program's own code, which
   * must not run under the client's lock.
   */
  @Override
  protected boolean setValueFrom(KrlScanner scanner, boolean written) {
    if (numbers != null) {
      value = type.cast(numbers.read(scanner, getName(), scratch, written ? value : null));
      return true;
    }
    return written && sent != null && sent.contentEquals(scanner.text());
  }

  @Override
  protected void setValueFromString(String strValue) {
    KrlScanner scanner = new KrlScanner(strValue);
    Record read = shape.read(scanner, getName());
    value = type.cast(read);
  }
}
