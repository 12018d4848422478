package no.hials.crosscom.bench;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.DoubleStream;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/**
 * A variable that one thread uses, and the values that it may have. Each write has the next number
 * as its value, so the server's end shows whether a write came twice.
 *
 * <p>A write with unknown outcome makes two values possible, until the variable is read. If it has
 * not arrived yet, it can still arrive on its old connection, and stays possible.
 */
final class CheckedVariable {
  private static final int HALF = 6;

  /** A type, with the values that stand for a number. */
  enum Kind {
    /** A number. */
    INT("INT", ""),
    /** A number with a fraction. */
    REAL("REAL", ""),
    /** A text that every code page for Western Europe has. */
    TEXT("CHAR", "[40]"),
    /** A text beyond ISO 8859-1. */
    WIDE_TEXT("CHAR", "[40]"),
    /** A structure; its twelve numbers follow each other, so that a mixture is noticed. */
    AXES("E6AXIS", "");

    private final String type;
    private final String dimension;

    Kind(String type, String dimension) {
      this.type = type;
      this.dimension = dimension;
    }

    private KRLVariable create(String name) {
      return switch (this) {
        case INT -> new KRLInt(name);
        case REAL -> new KRLReal(name);
        case TEXT, WIDE_TEXT -> new KRLString(name + "[]");
        case AXES -> new KRLE6Axis(name);
      };
    }

    private String text(long number) {
      return number + (this == TEXT ? " Größe" : " €");
    }

    private static double[] axes(long first) {
      return DoubleStream.iterate((double) first, i -> i + 1).limit(2 * HALF).toArray();
    }
  }

  private final Kind kind;
  private final KRLVariable variable;

  /** The number of the last write. */
  private long last;

  private final Set<Long> possible = new HashSet<>(Set.of(0L));

  /** The greatest number that the server has received; guarded by this, as the next field. */
  private long received;

  /** The writes with unknown outcome that the server has not received. */
  private final Set<Long> underway = new HashSet<>();

  CheckedVariable(Kind kind, String name, VariableTable table) {
    this.kind = kind;
    variable = kind.create(name);
    set(0);
    table.declare(name + kind.dimension, kind.type, null);
    table.set(variable.getName(), variable.getStringValue());
  }

  Kind kind() {
    return kind;
  }

  KRLVariable variable() {
    return variable;
  }

  /** Sets the variable to the next number, to be written. */
  void setNext() {
    last++;
    set(last);
  }

  /** Notes that the write is done; returns whether the variable still has the number. */
  boolean written() {
    allow(last);
    return has(last);
  }

  /** Notes that the write failed and was perhaps done. */
  void unknown() {
    possible.add(last);
    synchronized (this) {
      if (last > received) {
        underway.add(last);
      }
    }
  }

  /** Notes that the variable was read; returns whether its value is possible. */
  boolean read() {
    for (long number : possible) {
      if (has(number)) {
        allow(number);
        return true;
      }
    }
    return false;
  }

  private void allow(long number) {
    possible.clear();
    possible.add(number);
    synchronized (this) {
      possible.addAll(underway);
    }
  }

  /**
   * Notes that the server has received a write.
   *
   * @param text the value
   * @return whether it is the first time
   */
  synchronized boolean received(String text) {
    long number = Long.parseLong(text.replaceFirst("^[{A-Z\"]*(?:1 )?(\\d+)(?s:.*)", "$1"));
    boolean late = underway.remove(number);
    boolean next = number > received;
    received = Math.max(received, number);
    return late || next;
  }

  private void set(long number) {
    if (variable instanceof KRLInt it) {
      it.setValue((int) number);
    } else if (variable instanceof KRLReal it) {
      it.setValue(number + 0.5);
    } else if (variable instanceof KRLString it) {
      it.setValue(kind.text(number));
    } else if (variable instanceof KRLE6Axis it) {
      double[] axes = Kind.axes(number);
      it.setA1ToA6(Arrays.copyOf(axes, HALF));
      it.setE1ToE6(Arrays.copyOfRange(axes, HALF, 2 * HALF));
    } else {
      throw new AssertionError(variable);
    }
  }

  private boolean has(long number) {
    if (variable instanceof KRLE6Axis it) {
      try {
        return Arrays.equals(it.asArray(), Kind.axes(number));
      } catch (IllegalStateException e) {
        return false; // an axis is missing
      }
    }
    @Nullable Object value = variable.getValue();
    return switch (kind) {
      case INT -> Integer.valueOf((int) number).equals(value);
      case REAL -> Double.valueOf(number + 0.5).equals(value);
      default -> kind.text(number).equals(value);
    };
  }

  @Override
  public String toString() {
    return variable.getName() + " = " + variable.getValue() + ", possible " + possible;
  }
}
