package no.hials.crosscom;

import java.io.IOException;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes one variable of the controller as values of a Java type. Any number of threads
 * can use a handle; it lives as long as its client. Handles of the same client, name and type are
 * equal, so that each finds the results of the other.
 *
 * <p>Reading numbers by {@link OfReal} and {@link OfInt}, BOOLs, and positions creates no objects
 * but the record of a position, as long as one thread at a time uses the handle.
 *
 * @param <T> the type of the values; see {@link CrossComClient#handle}
 */
public sealed class Handle<T> {
  final TypedAccess client;
  private final String name;
  private final Class<T> type;

  /** The slot that no thread uses, if any. */
  private final AtomicReference<@Nullable Slot<T>> free;

  Handle(TypedAccess client, String name, Class<T> type) {
    this.client = client;
    this.name = Objects.requireNonNull(name, "name");
    this.type = Objects.requireNonNull(type, "type");
    this.free = new AtomicReference<>(Slot.of(name, type)); // refuses a wrong name or type
  }

  /** Returns the variable's name. */
  public String name() {
    return name;
  }

  /** Returns the type of the values. */
  public Class<T> type() {
    return type;
  }

  /** Returns a slot for this thread, which {@link #release} gives back. */
  final Slot<T> acquire() {
    Slot<T> slot = free.getAndSet(null);
    return slot == null ? Slot.of(name, type) : slot;
  }

  final void release(Slot<T> slot) {
    free.set(slot);
  }

  /**
   * Reads the variable.
   *
   * @return its value
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not of this type, or a field is
   *     missing
   * @throws CrossComException if the exchange fails
   */
  public T read() throws IOException {
    Slot<T> slot = acquire();
    try {
      client.readVariable(slot.variable());
      return slot.value();
    } finally {
      release(slot);
    }
  }

  /**
   * Writes the variable: an array element by element, a record with the fields of its components.
   *
   * @param value the new value
   * @throws CrossComAccessException if the controller refuses, for example a read-only variable
   * @throws CrossComValueException if the text is too long to be sent
   * @throws CrossComException if the exchange fails; {@link CrossComException#isOutcomeUnknown}
   *     returns whether the controller may have done it
   * @throws IllegalArgumentException if the controller cannot have the value, such as a number that
   *     is out of range
   * @throws UnsupportedOperationException if the type is {@code KrlValue}
   */
  public void write(T value) throws IOException {
    Objects.requireNonNull(value, "value");
    Slot<T> slot = acquire();
    try {
      slot.setter().accept(value);
      client.writeVariable(slot.variable());
    } finally {
      release(slot);
    }
  }

  /** Returns whether the other is a handle of the same client, name and type. */
  @Override
  public final boolean equals(@Nullable Object other) {
    return other instanceof Handle<?> handle
        && client == handle.client
        && name.equals(handle.name)
        && type == handle.type;
  }

  @Override
  public final int hashCode() {
    return Objects.hash(System.identityHashCode(client), name, type);
  }

  @Override
  public String toString() {
    return "Handle{" + name + ", " + type.getSimpleName() + "}";
  }

  /** Reads and writes a REAL, or an INT as a whole number, without creating objects. */
  public static final class OfReal extends Handle<Double> {
    OfReal(TypedAccess client, String name) {
      super(client, name, Double.class);
    }

    /**
     * Reads the variable, as {@link #read} does.
     *
     * @return the double nearest to the digits that the controller prints
     * @throws CrossComException as by {@link #read}
     */
    public double readAsDouble() throws IOException {
      Slot<Double> slot = acquire();
      try {
        KRLReal variable = (KRLReal) slot.variable();
        client.readVariable(variable);
        return variable.doubleValue();
      } finally {
        release(slot);
      }
    }

    /**
     * Writes the variable, as {@link #write(Object)} does.
     *
     * @param value sent as the nearest 32-bit float
     * @throws CrossComException as by {@link #write(Object)}
     */
    public void write(double value) throws IOException {
      Slot<Double> slot = acquire();
      try {
        KRLReal variable = (KRLReal) slot.variable();
        variable.setValue(value);
        client.writeVariable(variable);
      } finally {
        release(slot);
      }
    }
  }

  /** Reads and writes an INT without creating objects. */
  public static final class OfInt extends Handle<Integer> {
    OfInt(TypedAccess client, String name) {
      super(client, name, Integer.class);
    }

    /**
     * Reads the variable, as {@link #read} does.
     *
     * @return the value
     * @throws CrossComException as by {@link #read}
     */
    public int readAsInt() throws IOException {
      Slot<Integer> slot = acquire();
      try {
        KRLInt variable = (KRLInt) slot.variable();
        client.readVariable(variable);
        return variable.intValue();
      } finally {
        release(slot);
      }
    }

    /**
     * Writes the variable, as {@link #write(Object)} does.
     *
     * @param value the new value
     * @throws CrossComException as by {@link #write(Object)}
     */
    public void write(int value) throws IOException {
      Slot<Integer> slot = acquire();
      try {
        KRLInt variable = (KRLInt) slot.variable();
        variable.setValue(value);
        client.writeVariable(variable);
      } finally {
        release(slot);
      }
    }
  }
}
