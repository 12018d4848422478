package no.hials.crosscom;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.KRL.KRLVariable;

/**
 * The calls of {@link CrossComClient} that read and write variables as Java values. They are built
 * on the calls for {@link KRLVariable}.
 */
abstract sealed class TypedAccess implements Closeable permits OriginalAccess {

  /** Reads a variable of the controller into its local copy. */
  public abstract void readVariable(KRLVariable variable) throws IOException;

  /** Writes the local copy of a variable to the controller. */
  public abstract void writeVariable(KRLVariable variable) throws IOException;

  /** Reads several variables. */
  public abstract List<VariableResult> readVariables(List<? extends KRLVariable> several);

  /**
   * Reads a variable of the controller into its local copy, as {@link #readVariable} does.
   *
   * @param variable receives the value; unchanged if reading fails
   * @return the variable
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not of the variable's type
   * @throws CrossComException if the exchange fails
   */
  public <V extends KRLVariable> V read(V variable) throws IOException {
    readVariable(variable);
    return variable;
  }

  /**
   * Reads a variable as a Java type:
   *
   * <ul>
   *   <li>a record of {@link no.hials.crosscom.protocol.value}: {@code Frame}, {@code Pos}, {@code
   *       E6Pos}, {@code Axis}, {@code E6Axis}, {@code Load};
   *   <li>a record of your own for a STRUC, as described in {@link
   *       no.hials.crosscom.KRL.KRLRecord};
   *   <li>an enum for an ENUM; {@link no.hials.crosscom.KRL.KrlName} gives a constant another name;
   *   <li>{@code Integer}, {@code Double}, {@code Boolean}, {@code Character}, {@code String};
   *   <li>{@code int[]}, {@code double[]}, {@code boolean[]} for a whole array;
   *   <li>{@code KrlValue} for a variable of any type, to be read only.
   * </ul>
   *
   * <p>A record has the fields of its components; other fields are ignored, so that a {@code Frame}
   * can be read from an E6POS.
   *
   * @param name the variable's name
   * @param type the type
   * @return the value
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not of the type, or a field is
   *     missing, being uninitialised or not a field of the variable
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if the type maps to no KRL type
   */
  public <T> T read(String name, Class<T> type) throws IOException {
    return handle(name, type).read();
  }

  /**
   * Writes a record to a FRAME, another position, or a STRUC. Fields without a component stay as
   * they are.
   *
   * @param name the variable's name
   * @param value the new value; its class is one of those of {@link #read(String, Class)}
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComValueException if the text is too long to be sent
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if the controller cannot have the value of a component, or the
   *     class maps to no KRL type
   */
  public <R extends Record> void write(String name, R value) throws IOException {
    @SuppressWarnings("unchecked") // the class of an object is that of its type or of a subtype
    Class<R> type = (Class<R>) Objects.requireNonNull(value, "value").getClass();
    handle(name, type).write(value);
  }

  /**
   * Reads a REAL, or an INT as a whole number.
   *
   * @param name the variable's name, such as {@code $POS_ACT.X}
   * @return the double nearest to the digits that the controller prints; {@code (float)} of it is
   *     the controller's 32-bit value
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not a number
   * @throws CrossComException if the exchange fails
   */
  public double readReal(String name) throws IOException {
    return realHandle(name).readAsDouble();
  }

  /**
   * Writes a REAL.
   *
   * @param name the variable's name
   * @param value sent as the nearest 32-bit float
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if it is NaN, infinite or too large for a 32-bit float
   */
  public void writeReal(String name, double value) throws IOException {
    realHandle(name).write(value);
  }

  /**
   * Reads an INT.
   *
   * @param name the variable's name
   * @return the value
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not an INT
   * @throws CrossComException if the exchange fails
   */
  public int readInt(String name) throws IOException {
    return intHandle(name).readAsInt();
  }

  /**
   * Writes an INT.
   *
   * @param name the variable's name
   * @param value the new value
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  public void writeInt(String name, int value) throws IOException {
    intHandle(name).write(value);
  }

  /**
   * Reads a BOOL.
   *
   * @param name the variable's name
   * @return the value
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not a BOOL
   * @throws CrossComException if the exchange fails
   */
  public boolean readBool(String name) throws IOException {
    return read(name, Boolean.class);
  }

  /**
   * Writes a BOOL.
   *
   * @param name the variable's name
   * @param value the new value
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  public void writeBool(String name, boolean value) throws IOException {
    handle(name, Boolean.class).write(value);
  }

  /**
   * Reads a CHAR array.
   *
   * @param name the variable's name, such as {@code $MODEL_NAME[]}
   * @return the text without quotes; one blank is the empty text
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not a text, or is too long for an
   *     answer of C3 Bridge
   * @throws CrossComException if the exchange fails
   */
  public String readString(String name) throws IOException {
    return read(name, String.class);
  }

  /**
   * Writes a CHAR array.
   *
   * @param name the variable's name
   * @param value the text without quotes
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComValueException if the text cannot be sent
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if the text has a double quote
   */
  public void writeString(String name, String value) throws IOException {
    handle(name, String.class).write(value);
  }

  /**
   * Reads an ENUM.
   *
   * @param name the variable's name
   * @param type has a constant for each value, with the same name in any case or with a {@link
   *     no.hials.crosscom.KRL.KrlName}
   * @return the constant
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if no constant has the name of the controller's value
   * @throws CrossComException if the exchange fails
   */
  public <E extends Enum<E>> E readEnum(String name, Class<E> type) throws IOException {
    return read(name, type);
  }

  /**
   * Writes an ENUM.
   *
   * @param name the variable's name
   * @param value the constant, whose class is that of {@link #readEnum}
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  public <E extends Enum<E>> void writeEnum(String name, E value) throws IOException {
    Objects.requireNonNull(value, "value");
    handle(name, value.getDeclaringClass()).write(value);
  }

  /**
   * Reads a whole array of REAL in one access.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @return a new array of the elements, as {@link #readReal} returns them
   * @throws CrossComAccessException if the controller refuses; a {@link
   *     no.hials.crosscom.KRL.KRLRealArray} of known length can then be read element by element
   * @throws CrossComValueException if the controller's value is not an array of numbers, or is too
   *     long for an answer of C3 Bridge; then the same can be done
   * @throws CrossComException if the exchange fails
   */
  public double[] readRealArray(String name) throws IOException {
    return read(name, double[].class);
  }

  /**
   * Writes elements 1 and following of an array of REAL, one access each.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @param values the elements, at least one
   * @throws CrossComAccessException if the controller refuses an element; the elements before it
   *     were written
   * @throws CrossComException if an exchange fails
   */
  public void writeRealArray(String name, double... values) throws IOException {
    handle(name, double[].class).write(values);
  }

  /**
   * Reads a whole array of INT, as {@link #readRealArray} does.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @return a new array of the elements
   * @throws CrossComException as by {@link #readRealArray}
   */
  public int[] readIntArray(String name) throws IOException {
    return read(name, int[].class);
  }

  /**
   * Writes elements of an array of INT, as {@link #writeRealArray} does.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @param values the elements, at least one
   * @throws CrossComException as by {@link #writeRealArray}
   */
  public void writeIntArray(String name, int... values) throws IOException {
    handle(name, int[].class).write(values);
  }

  /**
   * Reads a whole array of BOOL, as {@link #readRealArray} does.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @return a new array of the elements
   * @throws CrossComException as by {@link #readRealArray}
   */
  public boolean[] readBoolArray(String name) throws IOException {
    return read(name, boolean[].class);
  }

  /**
   * Writes elements of an array of BOOL, as {@link #writeRealArray} does.
   *
   * @param name the variable's name, with or without {@code []} after it
   * @param values the elements, at least one
   * @throws CrossComException as by {@link #writeRealArray}
   */
  public void writeBoolArray(String name, boolean... values) throws IOException {
    handle(name, boolean[].class).write(values);
  }

  /**
   * Returns a new handle for repeated access to a variable, without sending anything.
   *
   * @param name the variable's name
   * @param type one of the types of {@link #read(String, Class)}
   * @return the handle
   * @throws IllegalArgumentException if the name is blank or the type maps to no KRL type
   */
  public <T> Handle<T> handle(String name, Class<T> type) {
    return new Handle<>(this, name, type);
  }

  /**
   * Returns a new handle for repeated access to a REAL.
   *
   * @param name the variable's name
   * @return the handle
   * @throws IllegalArgumentException if the name is blank
   */
  public Handle.OfReal realHandle(String name) {
    return new Handle.OfReal(this, name);
  }

  /**
   * Returns a new handle for repeated access to an INT.
   *
   * @param name the variable's name
   * @return the handle
   * @throws IllegalArgumentException if the name is blank
   */
  public Handle.OfInt intHandle(String name) {
    return new Handle.OfInt(this, name);
  }

  /**
   * Reads several variables, as {@link #readVariables(List)} does: on C3 Bridge 1.2 or later in as
   * few messages as possible. If one cannot be read, the others have their values. No exchange
   * throws: its failure is in the results.
   *
   * @param handles handles of this client
   * @return a value or a failure for each handle
   * @throws IllegalArgumentException if a handle is of another client
   */
  public ReadResults read(Handle<?>... handles) {
    check(Arrays.asList(Objects.requireNonNull(handles, "handles")));
    List<Reading<?>> readings = new ArrayList<>();
    try {
      for (Handle<?> handle : handles) {
        readings.add(Reading.of(handle));
      }
      List<VariableResult> read =
          readVariables(readings.stream().map(reading -> reading.slot.variable()).toList());
      ReadResults results = new ReadResults();
      for (int i = 0; i < handles.length; i++) {
        results.add(handles[i], readings.get(i).slot, read.get(i));
      }
      return results;
    } finally {
      readings.forEach(Reading::end);
    }
  }

  /** Refuses handles of another client. */
  final void check(List<Handle<?>> handles) {
    for (Handle<?> handle : handles) {
      if (Objects.requireNonNull(handle, "handle").client != this) {
        throw new IllegalArgumentException(handle + " is a handle of " + handle.client);
      }
    }
  }

  /** A handle and its slot during a read. */
  private record Reading<T>(Handle<T> handle, Slot<T> slot) {
    static <T> Reading<T> of(Handle<T> handle) {
      return new Reading<>(handle, handle.acquire());
    }

    void end() {
      handle.release(slot);
    }
  }
}
