package no.hials.crosscom.variables;

import java.util.Comparator;
import no.hials.crosscom.Callback;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * Holds a value returned by {@link no.hials.crosscom.CrossComClient#sendRequest}.
 *
 * @param <E> the Java type of the value
 */
public abstract class Variable<E> implements Comparable<Variable<E>> {
  private final int id;
  private final String name;
  private final String dataType;
  private long readTime;

  /** The value. */
  protected E value;

  /**
   * Creates a variable whose value is null until it is set.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param dataType the type's name, such as {@code Int}
   * @param readTime the time of the access, in ns
   */
  @SuppressWarnings("NullAway") // the original's constructor, for classes of programs
  public Variable(int id, String name, String dataType, long readTime) {
    this.id = id;
    this.name = name;
    this.dataType = dataType;
    this.readTime = readTime;
  }

  Variable(int id, String name, String dataType, E value, long readTime) {
    this(id, name, dataType, readTime);
    this.value = value;
  }

  /** Returns the variable's name. */
  public String getName() {
    return name;
  }

  /** Returns the type's name, such as {@code Int}. */
  public String getDataType() {
    return dataType;
  }

  /** Returns the time of the access, in ns. */
  public long getReadTime() {
    return readTime;
  }

  /** Returns the number of the request. */
  public int getId() {
    return id;
  }

  /** Returns the value. */
  public E getValue() {
    return value;
  }

  /**
   * Sets the value.
   *
   * @param value the new value
   */
  protected void setValue(E value) {
    this.value = value;
  }

  /**
   * Sets value and time.
   *
   * @param newValue the new value
   * @param newReadTime the time of the access, in ns
   */
  public void update(E newValue, long newReadTime) {
    setValue(newValue);
    readTime = newReadTime;
  }

  /** Compares the length of {@link #toString}, as the original does. */
  @Override
  public int compareTo(Variable<E> o) {
    return Comparator.<Variable<E>>comparingInt(v -> v.toString().length()).compare(this, o);
  }

  @Override
  public String toString() {
    return "ID = " + id + "\t" + name + " = " + getValue() + "\t#ReadTime: " + readTime;
  }

  /**
   * Parses the text of an answer.
   *
   * @param callback the answer
   * @return an {@link Int}, {@link Real}, {@link Bool}, {@link Enum} or {@link Struct}
   * @throws NumberFormatException if it is a text, an array or not a KRL value
   * @deprecated use a typed variable of {@link no.hials.crosscom.KRL}, or {@link KrlValue#parse}
   */
  @Deprecated
  @SuppressWarnings("rawtypes") // as in the original, so that its programs compile
  public static Variable parseVariable(Callback callback) throws NumberFormatException {
    return parse(
        callback.getId(),
        callback.getVariableName(),
        callback.getStringValue(),
        callback.getReadTime());
  }

  /**
   * Parses the text of an answer, for programs of version 0.1.
   *
   * @param callback the answer
   * @return an {@link Int}, {@link Real}, {@link Bool}, {@link Enum} or {@link Struct}
   * @throws NumberFormatException if it is a text, an array or not a KRL value
   * @deprecated use a typed variable of {@link no.hials.crosscom.KRL}, or {@link KrlValue#parse}
   */
  @Deprecated
  @SuppressWarnings("rawtypes") // as in the original, so that its programs compile
  public static Variable parseVariable(no.hials.crosscom.networking.Callback callback)
      throws NumberFormatException {
    return parse(
        callback.getId(),
        callback.getVariableName(),
        callback.getStringValue(),
        callback.getReadTime());
  }

  private static Variable<?> parse(int id, String name, String text, long time) {
    KrlValue value;
    try {
      value = KrlValue.parse(text.strip());
    } catch (KrlSyntaxException e) {
      throw (NumberFormatException) new NumberFormatException(e.getMessage()).initCause(e);
    }
    if (value instanceof KrlInt number) {
      return new Int(id, name, number.value(), time);
    } else if (value instanceof KrlReal number) {
      return new Real(id, name, Double.parseDouble(number.print()), time);
    } else if (value instanceof KrlBool bool) {
      return new Bool(id, name, bool.value(), time);
    } else if (value instanceof KrlEnum constant) {
      return new Enum(id, name, constant.print(), time);
    } else if (value instanceof KrlStruct struct) {
      return new Struct(id, name, Struct.nodes(struct), time);
    }
    throw new NumberFormatException(
        name
            + " must be an INT, REAL, BOOL, ENUM or aggregate, is "
            + PrintableText.shortened(text));
  }
}
