package no.hials.crosscom.lang.internal;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import no.hials.crosscom.lang.Position;
import org.jspecify.annotations.Nullable;

/** Creates a record of a tree from the bytes of {@link TreeBytes}. */
final class TreeReader {
  private final String file;
  private final List<Object> constants;
  private final byte[] bytes;
  private int at;
  private int line;

  TreeReader(String file, List<Object> constants, byte[] bytes, int start) {
    this.file = file;
    this.constants = constants;
    this.bytes = bytes;
    this.at = start;
  }

  /** Returns the record that begins here. */
  Object node() {
    return node(number());
  }

  private Object node(int kind) {
    RecordClass type = RecordClass.of(kind - TreeBytes.RECORDS);
    @Nullable Object[] components = new Object[type.size()];
    for (int i = 0; i < components.length; i++) {
      components[i] = component(type, i);
    }
    return type.create(components);
  }

  private @Nullable Object component(RecordClass type, int component) {
    return switch (type.storage(component)) {
      case POSITION -> position();
      case TEXT -> {
        int text = number();
        yield text == TreeBytes.NULL ? null : constants.get(text - 1);
      }
      case INT -> signed();
      case REAL -> (double) Float.intBitsToFloat(bits());
      case BOOL -> bytes[at++] != 0;
      case CONSTANT -> type.constant(component, bytes[at++]);
      case CONSTANTS -> type.constants(component, number());
      case LIST -> list();
      case RECORD -> {
        int kind = number();
        yield kind == TreeBytes.NULL ? null : node(kind);
      }
    };
  }

  private @Nullable List<?> list() {
    int size = number();
    if (size == TreeBytes.NULL) {
      return null;
    } else if (size == TreeBytes.BLOCK) {
      return (List<?>) constants.get(number());
    } else if (size == TreeBytes.SIZES) {
      return List.of();
    }
    @Nullable Object[] elements = new Object[size - TreeBytes.SIZES];
    for (int i = 0; i < elements.length; i++) {
      int kind = number();
      elements[i] =
          switch (kind) {
            case TreeBytes.NULL -> null;
            case TreeBytes.TEXT -> constants.get(number());
            default -> node(kind);
          };
    }
    return Collections.unmodifiableList(Arrays.asList(elements));
  }

  private Position position() {
    int column = number();
    if ((column & 1) != 0) {
      line += signed();
    }
    return new Position(file, line, column >>> 1);
  }

  private int signed() {
    int value = number();
    return (value >>> 1) ^ -(value & 1);
  }

  private int number() {
    int value = 0;
    for (int shift = 0; ; shift += TreeBytes.BITS) {
      int part = bytes[at++];
      value |= (part & (TreeBytes.MORE - 1)) << shift;
      if ((part & TreeBytes.MORE) == 0) {
        return value;
      }
    }
  }

  private int bits() {
    int value = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      value |= (bytes[at++] & 0xFF) << shift;
    }
    return value;
  }
}
