package no.hials.crosscom.variables;

/** Holds a REAL. */
public class Real extends Variable<Double> {
  /**
   * Creates a variable.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param value the value
   * @param readTime the time of the access, in ns
   */
  public Real(int id, String name, Double value, long readTime) {
    super(id, name, "Real", value, readTime);
  }
}
