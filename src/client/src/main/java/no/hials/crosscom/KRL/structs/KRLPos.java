package no.hials.crosscom.KRL.structs;

import no.hials.crosscom.protocol.value.Pos;

/**
 * Holds a POS: a FRAME with Status and Turn, which distinguish the axis positions that reach it.
 *
 * <p>A field that was neither set nor read is 0.0, in getters and in writes, as in JOpenShowVar
 * 0.2.2; {@link #isSet} returns false for it. If a field was missing in the controller's last
 * answer, getters throw {@link IllegalStateException} and writes leave it out until it is set.
 * {@code setX} to {@code setC} return this structure.
 */
public class KRLPos extends KRLFrame {
  /**
   * Creates a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLPos(String name) {
    this(name, "X", "Y", "Z", "A", "B", "C", "S", "T");
  }

  /**
   * Creates a structure with other fields.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields, including the fields of KRLPos
   */
  protected KRLPos(String name, String... nodes) {
    super(name, nodes);
  }

  /** Status and Turn are INTs on the controller. */
  @Override
  boolean isInt(int index) {
    String field = nodes()[index];
    return field.equals("S") || field.equals("T");
  }

  /** Returns the Status, a bit field, as a whole number. */
  public double getS() {
    return get("S");
  }

  /** Returns the Turn, a bit field, as a whole number. */
  public double getT() {
    return get("T");
  }

  /** Sets the Status, a bit field, as a whole number. */
  public void setS(double d) {
    set("S", d);
  }

  /** Sets the Turn, a bit field, as a whole number. */
  public void setT(double d) {
    set("T", d);
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

  /**
   * Returns X to C, S and T as an immutable record.
   *
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public Pos toPos() {
    return new Pos(getX(), getY(), getZ(), getA(), getB(), getC(), (int) getS(), (int) getT());
  }

  /** Sets X to C, in mm and degrees, S and T. */
  public void setValue(Pos value) {
    setValue(value.frame());
    set("S", 2, value.s(), value.t());
  }
}
