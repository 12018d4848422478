package no.hials.crosscom.variables;

/** Holds a BOOL. */
public class Bool extends Variable<Boolean> {
  /**
   * Creates a variable.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param value the value
   * @param readTime the time of the access, in ns
   */
  public Bool(int id, String name, Boolean value, long readTime) {
    super(id, name, "Boolean", value, readTime);
  }
}
