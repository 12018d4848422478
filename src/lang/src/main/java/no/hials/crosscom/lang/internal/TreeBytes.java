package no.hials.crosscom.lang.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.lang.Position;
import org.jspecify.annotations.Nullable;

/**
 * Converts the records of a file's tree to bytes. A record is the number of its class, then its
 * components in order; texts and the lists of blocks are numbers in a table of the file. {@link
 * TreeReader} is the opposite. The bytes never leave the memory.
 */
public final class TreeBytes {
  /** A record, a text or a list that is null. */
  static final int NULL = 0;

  /** A text in a list; the classes of records follow. */
  static final int TEXT = 1;

  static final int RECORDS = 2;

  /** The list of a block; the sizes of other lists follow. */
  static final int BLOCK = 1;

  static final int SIZES = 2;

  /** The bits of a number in a byte, and the bit that says that more bytes follow. */
  static final int BITS = 7;

  static final int MORE = 1 << BITS;

  private final String file;

  /** The texts, and the lists of blocks. */
  private final List<Object> constants = new ArrayList<>();

  private Map<String, Integer> numbers = new HashMap<>();
  private byte[] buffer = new byte[256];
  private int end;
  private int line;

  /** Creates the table of a file, whose name is in each position. */
  public TreeBytes(String file) {
    this.file = file;
  }

  /** Frees the memory that only {@link #of} needs. */
  public void close() {
    numbers = Map.of();
  }

  /** Returns the bytes of a record. */
  byte[] of(Object node) {
    end = 0;
    line = 0;
    node(node);
    return Arrays.copyOf(buffer, end);
  }

  /** Returns the record that begins at an index. */
  Object read(byte[] bytes, int start) {
    return new TreeReader(file, constants, bytes, start).node();
  }

  private void node(Object node) {
    RecordClass type = RecordClass.of(node);
    put(RECORDS + type.number());
    for (int i = 0; i < type.size(); i++) {
      Object value = type.component(node, i);
      if (value == null) {
        put(NULL);
      } else {
        component(type, i, value);
      }
    }
  }

  private void component(RecordClass type, int component, Object value) {
    switch (type.storage(component)) {
      case POSITION -> position((Position) value);
      case TEXT -> number(1 + constant((String) value));
      case INT -> signed((Integer) value);
      case REAL -> bits(Float.floatToRawIntBits(((Double) value).floatValue()));
      case BOOL -> put((Boolean) value ? 1 : 0);
      case CONSTANT -> put(type.number(component, value));
      case CONSTANTS -> {
        int bits = 0;
        for (Object each : (Set<?>) value) {
          bits |= 1 << type.number(component, each);
        }
        number(bits);
      }
      case LIST -> list((List<?>) value);
      case RECORD -> node(value);
    }
  }

  private void list(List<?> list) {
    if (list instanceof PackedList<?> block && !block.isEmpty()) {
      number(BLOCK);
      number(constants.size());
      constants.add(block.trim());
      return;
    }
    number(SIZES + list.size());
    for (Object element : list) {
      listElement(element);
    }
  }

  private void listElement(@Nullable Object element) {
    if (element == null) {
      put(NULL);
    } else if (element instanceof String text) {
      put(TEXT);
      number(constant(text));
    } else {
      node(element);
    }
  }

  private int constant(String text) {
    Integer known = numbers.putIfAbsent(text, constants.size());
    if (known != null) {
      return known;
    }
    constants.add(text);
    return constants.size() - 1;
  }

  /** Writes the column, and the line if it is not the line of the position before. */
  private void position(Position position) {
    boolean sameLine = position.line() == line;
    number((position.column() << 1) | (sameLine ? 0 : 1));
    if (!sameLine) {
      signed(position.line() - line);
      line = position.line();
    }
  }

  private void signed(int value) {
    number((value << 1) ^ (value >> (Integer.SIZE - 1)));
  }

  private void number(int value) {
    int rest = value;
    while ((rest & -MORE) != 0) {
      put((rest & (MORE - 1)) | MORE);
      rest >>>= BITS;
    }
    put(rest);
  }

  private void bits(int value) {
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      put(value >> shift);
    }
  }

  private void put(int value) {
    if (end == buffer.length) {
      buffer = Arrays.copyOf(buffer, 2 * end);
    }
    buffer[end++] = (byte) value;
  }
}
