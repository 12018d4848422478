package no.hials.crosscom.KRL;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/**
 * Reads and prints a record of numbers of {@code protocol.value}, such as an E6POS, without
 * creating other objects. All numbers are handled as {@code double}, which holds every INT.
 * Immutable.
 */
final class NumberShape {
  private static final ClassValue<Optional<NumberShape>> SHAPES =
      new ClassValue<>() {
        @Override
        protected Optional<NumberShape> computeValue(Class<?> type) {
          return type.getPackage() == Frame.class.getPackage()
                  && Arrays.stream(type.getRecordComponents())
                      .allMatch(component -> component.getType().isPrimitive())
              ? Optional.of(new NumberShape(type))
              : Optional.empty();
        }
      };

  private final String[] names;
  private final boolean[] ints;
  private final MethodHandle[] accessors;
  private final MethodHandle constructor;

  /** Returns the shape of a class; null if it is another record. */
  static @Nullable NumberShape of(Class<?> type) {
    return SHAPES.get(type).orElse(null);
  }

  private NumberShape(Class<?> type) {
    RecordComponent[] components = type.getRecordComponents();
    int count = components.length;
    names = new String[count];
    ints = new boolean[count];
    accessors = new MethodHandle[count];
    Class<?>[] own = new Class<?>[count];
    Class<?>[] doubles = new Class<?>[count];
    MethodHandles.Lookup lookup = MethodHandles.publicLookup();
    try {
      for (int i = 0; i < count; i++) {
        names[i] = components[i].getName().toUpperCase(Locale.ROOT);
        own[i] = components[i].getType();
        ints[i] = own[i] == int.class;
        accessors[i] =
            lookup
                .unreflect(components[i].getAccessor())
                .asType(MethodType.methodType(double.class, Object.class));
        doubles[i] = double.class;
      }
      MethodHandle canonical = lookup.findConstructor(type, MethodType.methodType(void.class, own));
      constructor =
          MethodHandles.explicitCastArguments(canonical, MethodType.methodType(type, doubles))
              .asSpreader(double[].class, count)
              .asType(MethodType.methodType(Record.class, double[].class));
    } catch (ReflectiveOperationException e) {
      throw new LinkageError("the records of protocol.value are public", e);
    }
  }

  double[] scratch() {
    return new double[names.length];
  }

  /**
   * Reads the whole text.
   *
   * @param path the variable's name
   * @param values scratch space
   * @param written the record of a write, whose answer may name only some fields; null for a read
   * @return {@code written} if the text has its values, otherwise a new record
   */
  Record read(KrlScanner scanner, String path, double[] values, @Nullable Record written) {
    long seen = 0;
    boolean same = written != null;
    int next = 0;
    scanner.openStruct();
    while (true) {
      int index = next;
      if (next == names.length || !scanner.nextFieldIs(names[next])) {
        if (!scanner.nextField()) {
          break;
        }
        index = find(scanner, next);
      }
      if (index < 0) {
        scanner.skipFieldValue();
        continue;
      }
      if ((seen & 1L << index) != 0) {
        throw RecordShape.twice(path, names[index]);
      }
      seen |= 1L << index;
      try {
        values[index] = ints[index] ? scanner.readInt() : scanner.readReal();
      } catch (KrlSyntaxException e) {
        throw RecordShape.wrong(path, names[index], e);
      }
      next = index + 1;
    }
    scanner.expectEnd();
    for (int i = 0; i < names.length; i++) {
      double before = written == null ? 0 : get(written, i);
      if ((seen & 1L << i) != 0) {
        same &= ints[i] ? values[i] == before : (float) values[i] == (float) before;
      } else if (written != null) {
        values[i] = before;
      } else {
        throw RecordShape.missing(path + "." + names[i]);
      }
    }
    return same && written != null ? written : create(values);
  }

  /** Returns the field at the scanner; a controller has its own order. */
  private int find(KrlScanner scanner, int start) {
    for (int i = 0; i < names.length; i++) {
      int index = start + i < names.length ? start + i : start + i - names.length;
      if (scanner.fieldIs(names[index])) {
        return index;
      }
    }
    return -1;
  }

  private Record create(double[] values) {
    try {
      return (Record) constructor.invokeExact(values);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new AssertionError("a record's constructor declares no exceptions", e);
    }
  }

  private double get(Object record, int index) {
    try {
      return (double) accessors[index].invokeExact(record);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new AssertionError("a record's accessor declares no exceptions", e);
    }
  }

  /** Throws if a number is out of the range of a REAL. */
  void check(Record record, String path) {
    for (int i = 0; i < names.length; i++) {
      try {
        KrlReal.toFloat(get(record, i));
      } catch (IllegalArgumentException e) {
        throw RecordShape.wrong(path, names[i], e);
      }
    }
  }

  void print(KrlText text, Record record) {
    text.openStruct();
    for (int i = 0; i < names.length; i++) {
      text.nextField(names[i]);
      double value = get(record, i);
      if (ints[i]) {
        text.append((int) value);
      } else {
        text.append((float) value);
      }
    }
    text.closeStruct();
  }
}
