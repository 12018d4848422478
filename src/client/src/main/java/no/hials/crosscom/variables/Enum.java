package no.hials.crosscom.variables;

/** Holds a value of an ENUM, with its {@code #}. */
@SuppressWarnings("JavaLangClash") // the original's name
public class Enum extends Variable<String> {
  /**
   * Creates a variable.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param value the value
   * @param readTime the time of the access, in ns
   */
  public Enum(int id, String name, String value, long readTime) {
    super(id, name, "Enum", value, readTime);
  }
}
