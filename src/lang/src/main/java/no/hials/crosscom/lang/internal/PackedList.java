package no.hials.crosscom.lang.internal;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.RandomAccess;

/**
 * The statements or declarations of a block, stored as bytes: a tree of records would take more
 * than ten times the memory of its file. An element is created whenever it is read.
 *
 * <p>Users of the tree cannot change the list, and any number of threads can read it.
 */
public final class PackedList<E> extends AbstractList<E> implements RandomAccess {
  /** The elements of a part: a longer list grows without copying what it has. */
  private static final int PART_BITS = 10;

  private static final int PART_SIZE = 1 << PART_BITS;

  private final TreeBytes tree;
  private final Class<E> type;

  /** The parts before the last one, all full. */
  private List<Part> full = List.of();

  private Part last = new Part();
  private int size;

  /** Some elements as bytes. */
  private static final class Part {
    /** Where each element begins. */
    private int[] offsets = new int[4];

    private int count;
    private byte[] bytes = new byte[64];
    private int end;

    void append(byte[] element) {
      if (count == offsets.length) {
        offsets = Arrays.copyOf(offsets, Math.min(PART_SIZE, count + (count >> 1) + 4));
      }
      offsets[count++] = write(element);
    }

    void replace(int index, byte[] element) {
      offsets[index] = write(element);
    }

    private int write(byte[] added) {
      int start = end;
      end += added.length;
      if (end > bytes.length) {
        bytes = Arrays.copyOf(bytes, end + (end >> 1));
      }
      System.arraycopy(added, 0, bytes, start, added.length);
      return start;
    }

    void trim() {
      offsets = Arrays.copyOf(offsets, count);
      bytes = Arrays.copyOf(bytes, end);
    }
  }

  /**
   * Creates an empty list.
   *
   * @param tree the tree of the file
   * @param type the class of the elements
   */
  public PackedList(TreeBytes tree, Class<E> type) {
    this.tree = tree;
    this.type = type;
  }

  @Override
  public E get(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("index " + index + ", size " + size);
    }
    Part part = part(index);
    return type.cast(tree.read(part.bytes, part.offsets[index % PART_SIZE]));
  }

  private Part part(int index) {
    int number = index >> PART_BITS;
    return number < full.size() ? full.get(number) : last;
  }

  @Override
  public int size() {
    return size;
  }

  /** Adds an element to the end. */
  public void append(E element) {
    if (last.count == PART_SIZE) {
      if (full.isEmpty()) {
        full = new ArrayList<>();
      }
      last.trim();
      full.add(last);
      last = new Part();
    }
    last.append(tree.of(element));
    size++;
  }

  /** Replaces an element, even after {@link #trim}. The bytes of the old element stay. */
  public void replace(int index, E element) {
    part(index).replace(index % PART_SIZE, tree.of(element));
  }

  /** Frees the memory that is reserved for more elements. */
  public PackedList<E> trim() {
    last.trim();
    return this;
  }
}
