package no.hials.crosscom.KRL;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Constructor;
import java.lang.reflect.InaccessibleObjectException;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.internal.EnumNames;
import no.hials.crosscom.protocol.value.KrlPrinter;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import org.jspecify.annotations.Nullable;

/** The mapping of a record class to a STRUC. Immutable. */
final class RecordShape {
  /** The mappings of classes, found by reflection once. */
  private static final ClassValue<RecordShape> SHAPES =
      new ClassValue<>() {
        @Override
        protected RecordShape computeValue(Class<?> type) {
          return new RecordShape(type, List.of());
        }
      };

  private static final Pattern ELEMENT = Pattern.compile("[^\\[]*\\[([1-9][0-9]{0,8})]");

  private final Class<?> type;
  private final Field[] fields;
  private final MethodHandle constructor;

  /**
   * A component and its field.
   *
   * @param name the field's name in upper case, without brackets
   * @param printedName the name as printed, with brackets for an array
   * @param type the type, without {@code Optional}
   * @param optional whether the type is an {@code Optional}
   * @param accessor returns the component of a record, as Object
   */
  private record Field(
      String name, String printedName, FieldType type, boolean optional, MethodHandle accessor) {}

  /** An error in a field; its message starts with the path. */
  static final class PathException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    PathException(String message, @Nullable Throwable cause) {
      super(message, cause);
    }
  }

  /** Returns the mapping of a class. */
  static RecordShape of(Class<?> type) {
    return SHAPES.get(type);
  }

  /**
   * @param outer the enclosing records
   */
  RecordShape(Class<?> type, List<Class<?>> outer) {
    this.type = type;
    if (!type.isRecord()) {
      throw new IllegalArgumentException(type.getTypeName() + " is not a record");
    }
    RecordComponent[] components = type.getRecordComponents();
    if (components.length == 0) {
      throw new IllegalArgumentException(type.getTypeName() + " has no components");
    }
    List<Class<?>> around = new ArrayList<>(outer);
    around.add(type);
    fields = new Field[components.length];
    for (int i = 0; i < fields.length; i++) {
      fields[i] = field(components[i], around);
      for (int j = 0; j < i; j++) {
        if (fields[j].name().equals(fields[i].name())) {
          throw unmappable(
              components[i], "has the name " + fields[i].name() + ", as another component has");
        }
      }
    }
    constructor = constructor(components);
  }

  /** Returns whether a component can contain a text or an ENUM. */
  boolean holdsText() {
    return Arrays.stream(fields).anyMatch(field -> field.type().holdsText());
  }

  private Field field(RecordComponent component, List<Class<?>> around) {
    KrlName given = component.getAnnotation(KrlName.class);
    String name = EnumNames.krlName(given, component.getName());
    if (name == null) {
      throw unmappable(
          component,
          given == null
              ? "has a name that KRL cannot have; give it another with @KrlName"
              : "has the @KrlName \"" + given.value() + "\", which is not a KRL name");
    }
    Type declared = component.getGenericType();
    boolean optional = component.getType() == Optional.class;
    if (optional) {
      if (!(declared instanceof ParameterizedType parameterized)) {
        throw unmappable(component, "is a raw Optional, which does not name the type of the value");
      }
      declared = parameterized.getActualTypeArguments()[0];
    }
    FieldType mapped;
    try {
      mapped = FieldType.of(declared, around);
    } catch (FieldType.UnmappableException e) {
      throw unmappable(component, e.getMessage());
    }
    Method accessor = component.getAccessor();
    MethodHandle handle;
    try {
      accessor.setAccessible(true);
      handle = MethodHandles.lookup().unreflect(accessor);
    } catch (InaccessibleObjectException | IllegalAccessException e) {
      throw inaccessible(e);
    }
    return new Field(
        name,
        name + mapped.brackets(),
        mapped,
        optional,
        handle.asType(MethodType.methodType(Object.class, Object.class)));
  }

  private MethodHandle constructor(RecordComponent[] components) {
    Class<?>[] types =
        Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
    try {
      Constructor<?> canonical = type.getDeclaredConstructor(types);
      canonical.setAccessible(true);
      return MethodHandles.lookup()
          .unreflectConstructor(canonical)
          .asSpreader(Object[].class, types.length)
          .asType(MethodType.methodType(Record.class, Object[].class));
    } catch (InaccessibleObjectException | ReflectiveOperationException e) {
      throw inaccessible(e);
    }
  }

  private IllegalArgumentException unmappable(RecordComponent component, @Nullable String why) {
    return new IllegalArgumentException(
        "component " + component.getName() + " of " + type.getTypeName() + " " + why);
  }

  private IllegalArgumentException inaccessible(Exception e) {
    return new IllegalArgumentException(
        type.getTypeName()
            + " cannot be reached; its module must open package "
            + type.getPackageName()
            + " to no.hials.crosscom",
        e);
  }

  /**
   * Reads the whole text.
   *
   * @param path the variable's name
   * @throws KrlSyntaxException if the text is not an aggregate
   * @throws PathException if a field is wrong
   */
  Record read(KrlScanner scanner, String path) {
    Object[] values = readFields(scanner, path);
    scanner.expectEnd();
    return make(values, path);
  }

  /** Reads the aggregate of a field; {@code path} is the path of the field. */
  Record readPart(KrlScanner scanner, String path) {
    return make(readFields(scanner, path), path);
  }

  private @Nullable Object[] readFields(KrlScanner scanner, String path) {
    @Nullable Object[] values = new @Nullable Object[fields.length];
    int next = 0;
    scanner.openStruct();
    while (scanner.nextField()) {
      int index = find(scanner, next);
      if (index < 0) {
        readElement(scanner, path, values);
        continue;
      }
      Field field = fields[index];
      if (values[index] != null) {
        throw twice(path, scanner.fieldName());
      }
      try {
        values[index] = field.type().read(scanner, path, field.name());
      } catch (KrlSyntaxException e) {
        // not the scanner's name, which may be a nested field
        throw wrong(path, field.printedName(), e);
      }
      next = index + 1;
    }
    return values;
  }

  /** Returns the field at the scanner; a controller has its own order. */
  private int find(KrlScanner scanner, int start) {
    for (int i = 0; i < fields.length; i++) {
      int index = start + i < fields.length ? start + i : start + i - fields.length;
      if (scanner.fieldIs(fields[index].printedName())) {
        return index;
      }
    }
    return -1;
  }

  /**
   * Reads an element of an array, the only field with a name other than its component; the record
   * ignores all other fields.
   */
  private void readElement(KrlScanner scanner, String path, @Nullable Object[] values) {
    String printed = scanner.fieldName();
    int bracket = printed.indexOf('[');
    String name = bracket < 0 ? printed : printed.substring(0, bracket);
    int index = 0;
    while (index < fields.length && !fields[index].name().equalsIgnoreCase(name)) {
      index++;
    }
    if (index == fields.length) {
      scanner.skipFieldValue();
      return;
    }
    Field field = fields[index];
    Matcher element = ELEMENT.matcher(printed);
    if (!(field.type() instanceof FieldType.Array array) || !element.matches()) {
      throw new PathException(
          path + "." + printed + " is not of the component's type, expected " + field.printedName(),
          null);
    }
    if (values[index] == null) {
      values[index] = new Elements();
    }
    try {
      Object value = array.readElement(scanner);
      if (!(values[index] instanceof Elements elements)
          || elements.byIndex.put(Integer.valueOf(element.group(1)), value) != null) {
        throw twice(path, printed);
      }
    } catch (KrlSyntaxException e) {
      throw wrong(path, printed, e);
    }
  }

  /** The elements of an array that is printed element by element. */
  private static final class Elements {
    final SortedMap<Integer, Object> byIndex = new TreeMap<>();
  }

  static PathException twice(String path, String field) {
    return new PathException(path + "." + field + " occurs twice", null);
  }

  static PathException wrong(String path, String field, IllegalArgumentException e) {
    return new PathException(path + "." + field + ": " + e.getMessage(), e);
  }

  private Record make(@Nullable Object[] values, String path) {
    for (int i = 0; i < fields.length; i++) {
      Object value = values[i];
      if (value instanceof Elements elements && fields[i].type() instanceof FieldType.Array array) {
        value = array(elements, array, path + "." + fields[i].name());
      }
      if (fields[i].optional()) {
        value = Optional.ofNullable(value);
      } else if (value == null) {
        throw missing(path + "." + fields[i].printedName());
      }
      values[i] = value;
    }
    try {
      return (Record) constructor.invokeExact(values);
    } catch (VirtualMachineError e) {
      throw e;
    } catch (RuntimeException | Error e) {
      throw new PathException(path + " is refused by " + type.getTypeName() + ": " + e, e);
    } catch (Throwable e) {
      throw new AssertionError("a record's constructor declares no exceptions", e);
    }
  }

  private static Object array(Elements elements, FieldType.Array type, String path) {
    int expected = 1;
    for (int index : elements.byIndex.keySet()) {
      if (index != expected) {
        throw missing(path + "[" + expected + "]");
      }
      expected++;
    }
    return type.arrayOf(elements.byIndex.values());
  }

  static PathException missing(String path) {
    return new PathException(
        path
            + " is missing in the controller's answer: it is not initialised, or not a field of that"
            + " variable",
        null);
  }

  /**
   * Prints a record.
   *
   * @param path the variable's name, or the path of the field
   * @throws PathException if a component has a value that cannot be written
   */
  void print(StringBuilder out, Object printed, String path) {
    KrlPrinter.openStruct(out);
    for (Field field : fields) {
      Object value = get(printed, field);
      if (field.optional() && value instanceof Optional<?> given) {
        if (given.isEmpty()) {
          continue;
        }
        value = given.get();
      }
      if (value == null) {
        throw new PathException(path + "." + field.name() + " must not be null", null);
      }
      KrlPrinter.nextField(out, field.printedName());
      try {
        field.type().print(out, value, path, field.name());
      } catch (PathException e) {
        throw e;
      } catch (IllegalArgumentException e) {
        throw wrong(path, field.name(), e);
      }
    }
    KrlPrinter.closeStruct(out);
  }

  private static @Nullable Object get(Object of, Field field) {
    try {
      return (Object) field.accessor().invokeExact(of);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new AssertionError("a record's accessor declares no exceptions", e);
    }
  }
}
