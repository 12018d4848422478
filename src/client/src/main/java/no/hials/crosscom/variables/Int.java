package no.hials.crosscom.variables;

/** Holds an INT. */
public class Int extends Variable<Integer> {
  /**
   * Creates a variable.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param value the value
   * @param readTime the time of the access, in ns
   */
  public Int(int id, String name, Integer value, long readTime) {
    super(id, name, "Int", value, readTime);
  }
}
