package no.hials.crosscom.KRL;

import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Function;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.internal.EnumNames;
import no.hials.crosscom.protocol.value.KrlPrinter;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.RealStyle;
import org.jspecify.annotations.Nullable;

/** Reads and prints the values of a Java type as fields of a STRUC. Immutable. */
abstract class FieldType {
  /** A float holds every INT up to this; the next INT is rounded to it. */
  private static final float EXACT = 1 << 24;

  private static final FieldType INT =
      new Scalar("", KrlScanner::readInt, (out, value) -> out.append((int) value));

  private static final FieldType FLOAT =
      new Scalar("", FieldType::readFloat, (out, value) -> print(out, new KrlReal((float) value)));

  private static final FieldType DOUBLE =
      new Scalar("", KrlScanner::readReal, (out, value) -> print(out, KrlReal.of((double) value)));

  private static final FieldType BOOL =
      new Scalar("", KrlScanner::readBool, (out, v) -> KrlPrinter.appendBool(out, (boolean) v));

  private static final FieldType CHAR =
      new Scalar("", FieldType::readChar, (out, value) -> printText(out, value.toString()));

  /** The controller prints an empty text as one blank. */
  private static final FieldType TEXT =
      new Scalar(
          "[]",
          scanner -> {
            String text = scanner.readString();
            return text.equals(" ") ? "" : text;
          },
          (out, value) -> printText(out, value.equals("") ? " " : (String) value));

  private static final Map<Class<?>, FieldType> SCALARS =
      Map.of(
          int.class, INT,
          Integer.class, INT,
          float.class, FLOAT,
          Float.class, FLOAT,
          double.class, DOUBLE,
          Double.class, DOUBLE,
          boolean.class, BOOL,
          Boolean.class, BOOL);

  private static final Map<Class<?>, FieldType> OTHERS =
      Map.of(
          char.class, CHAR,
          Character.class, CHAR,
          String.class, TEXT,
          KRLFrame.class, new Frame(KRLFrame.class, KRLFrame::new),
          KRLPos.class, new Frame(KRLPos.class, KRLPos::new),
          KRLE6Pos.class, new Frame(KRLE6Pos.class, KRLE6Pos::new),
          KRLAxis.class, new Frame(KRLAxis.class, KRLAxis::new),
          KRLE6Axis.class, new Frame(KRLE6Axis.class, KRLE6Axis::new));

  /** Thrown if a type cannot be mapped; the message completes a sentence about the component. */
  static final class UnmappableException extends Exception {
    private static final long serialVersionUID = 1L;

    UnmappableException(@Nullable String message) {
      super(message);
    }
  }

  /**
   * Returns the mapping of a type.
   *
   * @param around the enclosing records of the component, outermost first
   */
  static FieldType of(Type declared, List<Class<?>> around) throws UnmappableException {
    if (declared instanceof Class<?> type) {
      FieldType known = scalar(type);
      if (known == null) {
        known = OTHERS.get(type);
      }
      if (known != null) {
        return known;
      }
      if (type.isRecord()) {
        if (around.contains(type)) {
          throw new UnmappableException("is of type " + type.getTypeName() + ", which contains it");
        }
        return new Part(new RecordShape(type, around));
      }
      FieldType element = type.isArray() ? scalar(type.getComponentType()) : null;
      if (element != null
          && (type.getComponentType().isPrimitive() || element instanceof Constant)) {
        return new Array(type.getComponentType(), element);
      }
    }
    throw new UnmappableException(
        "is of type " + declared.getTypeName() + ", which maps to no KRL type");
  }

  /** Returns the type of an array element, or null. */
  private static @Nullable FieldType scalar(Class<?> type) throws UnmappableException {
    return type.isEnum() ? new Constant(type) : SCALARS.get(type);
  }

  /**
   * Reads the value at the scanner.
   *
   * @param path the path of the enclosing record
   * @param name the field's name
   * @throws KrlSyntaxException if the value is not of this type
   * @throws RecordShape.PathException if a part of it is invalid
   */
  abstract Object read(KrlScanner scanner, String path, String name);

  /**
   * Prints a value.
   *
   * @param path the path of the enclosing record
   * @param name the field's name
   * @throws RecordShape.PathException if a part of it cannot be written
   * @throws IllegalArgumentException if the value cannot be written
   */
  abstract void print(StringBuilder out, Object value, String path, String name);

  /** Returns whether a value can contain a text or an ENUM. */
  boolean holdsText() {
    return true;
  }

  /** Returns the brackets after the name of the field, if any. */
  String brackets() {
    return "";
  }

  /** A scalar that needs no path for its errors. */
  private static final class Scalar extends FieldType {
    private final String brackets;
    private final Function<KrlScanner, Object> reader;
    private final BiConsumer<StringBuilder, Object> printer;

    Scalar(
        String brackets,
        Function<KrlScanner, Object> reader,
        BiConsumer<StringBuilder, Object> printer) {
      this.brackets = brackets;
      this.reader = reader;
      this.printer = printer;
    }

    @Override
    Object read(KrlScanner scanner, String path, String name) {
      return reader.apply(scanner);
    }

    @Override
    void print(StringBuilder out, Object value, String path, String name) {
      printer.accept(out, value);
    }

    @Override
    boolean holdsText() {
      return this == CHAR || this == TEXT;
    }

    @Override
    String brackets() {
      return brackets;
    }
  }

  private static Object readFloat(KrlScanner scanner) {
    int start = scanner.position();
    float value = scanner.readFloat();
    if (Math.abs(value) >= EXACT) {
      // rare: a REAL is already a float, but an INT of the controller may have more digits
      String text = scanner.text().subSequence(start, scanner.position()).toString();
      KrlScanner again = new KrlScanner(text);
      if (isInt(text) && again.readInt() != (double) value) {
        throw new KrlSyntaxException(scanner.text(), start, "an INT that a float can hold", text);
      }
    }
    return value;
  }

  private static boolean isInt(String text) {
    return text.startsWith("'") || text.chars().noneMatch(c -> c == '.' || c == 'E' || c == 'e');
  }

  private static Object readChar(KrlScanner scanner) {
    int start = scanner.position();
    String text = scanner.readString();
    if (text.length() != 1) {
      throw scanner.wrongAt(start, "one character in double quotes");
    }
    return text.charAt(0);
  }

  private static void print(StringBuilder out, KrlReal number) {
    KrlPrinter.appendReal(out, number.value(), RealStyle.SHORTEST);
  }

  private static void printText(StringBuilder out, String text) {
    KrlPrinter.append(out, new KrlString(text), RealStyle.SHORTEST);
  }

  /** An ENUM. */
  private static final class Constant extends FieldType {
    private final EnumNames names;

    Constant(Class<?> type) throws UnmappableException {
      try {
        names = EnumNames.of(type);
      } catch (IllegalArgumentException e) {
        throw new UnmappableException(e.getMessage());
      }
    }

    @Override
    Object read(KrlScanner scanner, String path, String name) {
      int start = scanner.position();
      String text = scanner.readEnum();
      Object constant = names.constant(text);
      if (constant == null) {
        throw new KrlSyntaxException(scanner.text(), start, names.expected(), "#" + text);
      }
      return constant;
    }

    @Override
    void print(StringBuilder out, Object value, String path, String name) {
      out.append('#').append(names.name(value));
    }
  }

  /** A whole one-dimensional array. */
  static final class Array extends FieldType {
    private final Class<?> elementClass;
    private final FieldType element;

    Array(Class<?> elementClass, FieldType element) {
      this.elementClass = elementClass;
      this.element = element;
    }

    @Override
    boolean holdsText() {
      return element.holdsText();
    }

    /** Reads an element. */
    Object readElement(KrlScanner scanner) {
      return element.read(scanner, "", "");
    }

    /** Creates an array. */
    Object arrayOf(Collection<Object> elements) {
      Object array = java.lang.reflect.Array.newInstance(elementClass, elements.size());
      int i = 0;
      for (Object value : elements) {
        java.lang.reflect.Array.set(array, i++, value);
      }
      return array;
    }

    @Override
    Object read(KrlScanner scanner, String path, String name) {
      List<Object> elements = new ArrayList<>();
      do {
        elements.add(readElement(scanner));
      } while (scanner.hasMore() && !atEnd(scanner.text().charAt(scanner.position())));
      return arrayOf(elements);
    }

    private static boolean atEnd(char c) {
      return c == ',' || c == '}';
    }

    @Override
    void print(StringBuilder out, Object value, String path, String name) {
      int length = java.lang.reflect.Array.getLength(value);
      if (length == 0) {
        throw new IllegalArgumentException("must have at least 1 element, has 0");
      }
      for (int i = 0; i < length; i++) {
        if (i > 0) {
          out.append(' ');
        }
        try {
          Object part = java.lang.reflect.Array.get(value, i);
          if (part == null) {
            throw new IllegalArgumentException("must not be null");
          }
          element.print(out, part, path, name);
        } catch (IllegalArgumentException e) {
          throw new RecordShape.PathException(
              path + "." + name + "[" + (i + 1) + "]: " + e.getMessage(), e);
        }
      }
    }

    @Override
    String brackets() {
      return "[]";
    }
  }

  /** A record in a record. */
  private static final class Part extends FieldType {
    private final RecordShape shape;

    Part(RecordShape shape) {
      this.shape = shape;
    }

    @Override
    boolean holdsText() {
      return shape.holdsText();
    }

    @Override
    Object read(KrlScanner scanner, String path, String name) {
      return shape.readPart(scanner, path + "." + name);
    }

    @Override
    void print(StringBuilder out, Object value, String path, String name) {
      shape.print(out, value, path + "." + name);
    }
  }

  /** A FRAME or similar structure, which records its missing fields itself. */
  private static final class Frame extends FieldType {
    private final Class<? extends KRLStruct> type;
    private final Function<String, KRLStruct> constructor;
    private final List<String> fields;

    Frame(Class<? extends KRLStruct> type, Function<String, KRLStruct> constructor) {
      this.type = type;
      this.constructor = constructor;
      this.fields = List.of(constructor.apply("FIELDS").getNodes());
    }

    @Override
    boolean holdsText() {
      return false;
    }

    @Override
    Object read(KrlScanner scanner, String path, String name) {
      KRLStruct struct = constructor.apply(path + "." + name);
      int start = scanner.position();
      scanner.openStruct();
      while (scanner.nextField()) {
        String part = struct.getName() + "." + scanner.fieldName();
        if (!fields.contains(scanner.fieldName().toUpperCase(Locale.ROOT))) {
          throw new RecordShape.PathException(
              part + " is not a field of a " + type.getSimpleName() + ", which has " + fields,
              null);
        }
        try {
          scanner.readReal();
        } catch (KrlSyntaxException e) {
          throw new RecordShape.PathException(part + ": " + e.getMessage(), e);
        }
      }
      // only the structure itself can record its missing fields
      KRLVariable variable = struct;
      variable.setValueFromString(scanner.text().subSequence(start, scanner.position()).toString());
      return struct;
    }

    @Override
    void print(StringBuilder out, Object value, String path, String name) {
      if (value.getClass() != type) {
        // a KRLPos is also a KRLFrame, but with fields that a FRAME does not have
        throw new IllegalArgumentException(
            "must be a " + type.getSimpleName() + ", is a " + value.getClass().getSimpleName());
      }
      KRLStruct struct = (KRLStruct) value;
      boolean empty = Collections.disjoint(struct.getValue().keySet(), fields);
      out.append(empty ? "{}" : struct.getStringValue());
    }
  }
}
