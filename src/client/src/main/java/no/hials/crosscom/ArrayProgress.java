package no.hials.crosscom;

/** Listens to the progress of reading or writing an array element by element. */
@FunctionalInterface
public interface ArrayProgress {
  /**
   * Called after each element, in the thread that reads or writes. An exception ends the operation.
   *
   * @param done number of elements done
   * @param total number of elements of the array
   */
  void elementsDone(int done, int total);
}
