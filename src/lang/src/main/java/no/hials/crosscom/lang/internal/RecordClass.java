package no.hials.crosscom.lang.internal;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement;
import org.jspecify.annotations.Nullable;

/** A class of records in a tree, found by reflection: how to take one apart and create it again. */
final class RecordClass {
  /** How a component is stored. */
  enum Storage {
    POSITION,
    TEXT,
    INT,
    REAL,
    BOOL,
    CONSTANT,
    CONSTANTS,
    LIST,
    RECORD
  }

  private static final List<RecordClass> ALL = new ArrayList<>();
  private static final Map<Class<?>, RecordClass> BY_CLASS;

  static {
    Map<String, Class<?>> classes = new TreeMap<>();
    find(Statement.class, classes);
    find(Declaration.class, classes);
    classes.values().forEach(type -> ALL.add(new RecordClass(ALL.size(), type)));
    BY_CLASS = ALL.stream().collect(Collectors.toMap(each -> each.type, Function.identity()));
  }

  private final int number;
  private final Class<?> type;
  private final Storage[] storages;

  /** The constants of the enumeration of each component; empty for other components. */
  private final List<List<?>> constants = new ArrayList<>();

  private final MethodHandle[] getters;
  private final MethodHandle constructor;

  private RecordClass(int number, Class<?> type) {
    this.number = number;
    this.type = type;
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types =
        Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
    storages = Arrays.stream(types).map(RecordClass::storage).toArray(Storage[]::new);
    getters = new MethodHandle[types.length];
    MethodHandles.Lookup lookup = MethodHandles.lookup();
    try {
      for (int i = 0; i < types.length; i++) {
        constants.add(constants(components[i].getGenericType()));
        getters[i] =
            lookup
                .unreflect(components[i].getAccessor())
                .asType(MethodType.methodType(Object.class, Object.class));
      }
      constructor =
          lookup
              .findConstructor(type, MethodType.methodType(void.class, types))
              .asSpreader(Object[].class, types.length)
              .asType(MethodType.methodType(Object.class, Object[].class));
    } catch (ReflectiveOperationException e) {
      throw new LinkageError("the record " + type.getName() + " has no canonical form", e);
    }
  }

  private static List<?> constants(Type type) {
    Type wanted = type instanceof ParameterizedType set ? set.getActualTypeArguments()[0] : type;
    return wanted instanceof Class<?> found && found.isEnum()
        ? List.of(found.getEnumConstants())
        : List.of();
  }

  /** Finds the classes of records that a tree can contain. */
  private static void find(Type type, Map<String, Class<?>> found) {
    if (type instanceof ParameterizedType list) {
      find(list.getActualTypeArguments()[0], found);
    } else if (type instanceof Class<?> wanted && wanted.isSealed()) {
      for (Class<?> permitted : wanted.getPermittedSubclasses()) {
        find(permitted, found);
      }
    } else if (type instanceof Class<?> wanted
        && wanted.isRecord()
        && wanted != Position.class
        && found.put(wanted.getName(), wanted) == null) {
      for (RecordComponent component : wanted.getRecordComponents()) {
        find(component.getGenericType(), found);
      }
    }
  }

  private static Storage storage(Class<?> type) {
    if (type == Position.class) {
      return Storage.POSITION;
    } else if (type == String.class) {
      return Storage.TEXT;
    } else if (type == int.class) {
      return Storage.INT;
    } else if (type == double.class) {
      return Storage.REAL;
    } else if (type == boolean.class) {
      return Storage.BOOL;
    } else if (type == List.class) {
      return Storage.LIST;
    } else if (type == Set.class) {
      return Storage.CONSTANTS;
    }
    return type.isEnum() ? Storage.CONSTANT : Storage.RECORD;
  }

  static RecordClass of(Object node) {
    return Objects.requireNonNull(BY_CLASS.get(node.getClass()));
  }

  static RecordClass of(int number) {
    return ALL.get(number);
  }

  int number() {
    return number;
  }

  int size() {
    return storages.length;
  }

  Storage storage(int component) {
    return storages[component];
  }

  /** Returns a constant of the enumeration of a component by its number. */
  Object constant(int component, int constant) {
    return constants.get(component).get(constant);
  }

  /** Returns the number of a constant of the enumeration of a component. */
  int number(int component, Object constant) {
    return constants.get(component).indexOf(constant);
  }

  /** Returns a set of constants; each bit is one. */
  Set<?> constants(int component, int bits) {
    Set<Object> set = new LinkedHashSet<>();
    for (int i = 0; bits >> i != 0; i++) {
      if (((bits >> i) & 1) != 0) {
        set.add(constant(component, i));
      }
    }
    return Collections.unmodifiableSet(set);
  }

  @Nullable Object component(Object node, int component) {
    try {
      return (@Nullable Object) getters[component].invokeExact(node);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  Object create(@Nullable Object[] components) {
    try {
      return (Object) constructor.invokeExact(components);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /** A record of a tree checks nothing, so only an error can come here. */
  private IllegalStateException failed(Throwable e) {
    if (e instanceof Error error) {
      throw error;
    }
    return new IllegalStateException("the record " + type.getName() + " cannot be stored", e);
  }
}
