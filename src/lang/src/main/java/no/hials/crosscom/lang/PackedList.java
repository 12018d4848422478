package no.hials.crosscom.lang;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;

/** The statements or declarations of a block. Users of the tree cannot change it. */
final class PackedList<E> extends AbstractList<E> {
  private final List<E> elements = new ArrayList<>();

  void append(E element) {
    elements.add(element);
  }

  void replace(int index, E element) {
    elements.set(index, element);
  }

  @Override
  public E get(int index) {
    return elements.get(index);
  }

  @Override
  public int size() {
    return elements.size();
  }
}
