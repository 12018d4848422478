package no.hials.crosscom;

/** Hears how far reading or writing an array element by element has come. */
@FunctionalInterface
public interface ArrayProgress {
  /**
   * Takes the news. It is called by the thread that reads or writes, after each element; what it
   * throws ends the operation.
   *
   * @param done how many elements are done
   * @param total how many there are
   */
  void elementsDone(int done, int total);
}
