package no.hials.crosscom.KRL.structs;

/** Holds a POS: a FRAME with Status and Turn, which tell apart the axis positions that reach it. */
public class KRLPos extends KRLFrame {
  /**
   * Makes a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLPos(String name) {
    this(name, "X", "Y", "Z", "A", "B", "C", "S", "T");
  }

  /**
   * Makes a structure with other fields.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields, those of KRLPos among them
   */
  protected KRLPos(String name, String... nodes) {
    super(name, nodes);
  }

  /** Status and Turn are INT on the controller. */
  @Override
  boolean isInt(int index) {
    String field = nodes()[index];
    return field.equals("S") || field.equals("T");
  }

  /**
   * Gives the Status.
   *
   * @return a whole number of bits
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getS() {
    return get("S");
  }

  /**
   * Gives the Turn.
   *
   * @return a whole number of bits
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getT() {
    return get("T");
  }

  /**
   * Sets the Status.
   *
   * @param d a whole number of bits
   * @return this
   */
  public KRLPos setS(double d) {
    set("S", d);
    return this;
  }

  /**
   * Sets the Turn.
   *
   * @param d a whole number of bits
   * @return this
   */
  public KRLPos setT(double d) {
    set("T", d);
    return this;
  }

  @Override
  public KRLPos setX(double d) {
    super.setX(d);
    return this;
  }

  @Override
  public KRLPos setY(double d) {
    super.setY(d);
    return this;
  }

  @Override
  public KRLPos setZ(double d) {
    super.setZ(d);
    return this;
  }

  @Override
  public KRLPos setA(double d) {
    super.setA(d);
    return this;
  }

  @Override
  public KRLPos setB(double d) {
    super.setB(d);
    return this;
  }

  @Override
  public KRLPos setC(double d) {
    super.setC(d);
    return this;
  }

  @Override
  public KRLPos setXToZ(double... values) {
    super.setXToZ(values);
    return this;
  }

  @Override
  public KRLPos setAToC(double... values) {
    super.setAToC(values);
    return this;
  }
}
