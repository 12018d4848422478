package no.hials.crosscom.lang.internal;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.RandomAccess;

/**
 * The statements or declarations of a block, stored as bytes: a tree of records would take more
 * than ten times the memory of its file. An element is created whenever it is read.
 *
 * <p>Users of the tree cannot change the list, and any number of threads can read it.
 */
public final class PackedList<E> extends AbstractList<E> implements RandomAccess {
  private final TreeBytes tree;
  private final Class<E> type;

  /** Where each element begins. */
  private int[] offsets = new int[4];

  private int size;
  private byte[] bytes = new byte[64];
  private int end;

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
    return type.cast(tree.read(bytes, offsets[index]));
  }

  @Override
  public int size() {
    return size;
  }

  /** Adds an element to the end. */
  public void append(E element) {
    if (size == offsets.length) {
      offsets = Arrays.copyOf(offsets, size + (size >> 1) + 4);
    }
    offsets[size++] = write(element);
  }

  /** Replaces an element, even after {@link #trim}. The bytes of the old element stay. */
  public void replace(int index, E element) {
    offsets[index] = write(element);
  }

  private int write(Object element) {
    byte[] added = tree.of(element);
    int start = end;
    end += added.length;
    if (end > bytes.length) {
      bytes = Arrays.copyOf(bytes, end + (end >> 1));
    }
    System.arraycopy(added, 0, bytes, start, added.length);
    return start;
  }

  /** Frees the memory that is reserved for more elements. */
  public PackedList<E> trim() {
    offsets = Arrays.copyOf(offsets, size);
    bytes = Arrays.copyOf(bytes, end);
    return this;
  }
}
