package no.hials.crosscom.KRL.structs;

import no.hials.crosscom.protocol.value.Frame;

/**
 * Holds a FRAME: a position X, Y, Z in mm and an orientation A, B, C in degrees, which is {@code
 * Rz(A) Ry(B) Rx(C)} (docs/reference/kinematics.md#orientation).
 *
 * <p>A field that was neither set nor read is 0.0, in getters and in writes, as in JOpenShowVar
 * 0.2.2; {@link #isSet} returns false for it. If a field was missing in the controller's last
 * answer, getters throw {@link IllegalStateException} and writes leave it out until it is set.
 * {@code setX} to {@code setC} return this structure.
 */
public class KRLFrame extends NumberStruct {
  /**
   * Creates a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLFrame(String name) {
    this(name, "X", "Y", "Z", "A", "B", "C");
  }

  /**
   * Creates a structure with other fields.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields, including the fields of KRLFrame
   */
  protected KRLFrame(String name, String... nodes) {
    super(name, nodes);
  }

  /** An E6AXIS has E1 to E6 too, but none of X to C. */
  @Override
  final boolean accepts(long seen) {
    return (seen & 0b111111) != 0;
  }

  /** Returns the position along X, in mm. */
  public double getX() {
    return get("X");
  }

  /** Returns the position along Y, in mm. */
  public double getY() {
    return get("Y");
  }

  /** Returns the position along Z, in mm. */
  public double getZ() {
    return get("Z");
  }

  /** Returns the rotation about Z, in degrees. */
  public double getA() {
    return get("A");
  }

  /** Returns the rotation about the new Y', in degrees. */
  public double getB() {
    return get("B");
  }

  /** Returns the rotation about the new X'', in degrees. */
  public double getC() {
    return get("C");
  }

  /** Sets the position along X, in mm. */
  public KRLFrame setX(double d) {
    set("X", d);
    return this;
  }

  /** Sets the position along Y, in mm. */
  public KRLFrame setY(double d) {
    set("Y", d);
    return this;
  }

  /** Sets the position along Z, in mm. */
  public KRLFrame setZ(double d) {
    set("Z", d);
    return this;
  }

  /** Sets the rotation about Z, in degrees. */
  public KRLFrame setA(double d) {
    set("A", d);
    return this;
  }

  /** Sets the rotation about the new Y', in degrees. */
  public KRLFrame setB(double d) {
    set("B", d);
    return this;
  }

  /** Sets the rotation about the new X'', in degrees. */
  public KRLFrame setC(double d) {
    set("C", d);
    return this;
  }

  /** Sets X to Z to exactly 3 values, in mm. */
  public void setXToZ(double... values) {
    set("X", 3, values);
  }

  /** Sets A to C to exactly 3 values, in degrees. */
  public void setAToC(double... values) {
    set("A", 3, values);
  }

  /** Returns X to Z as a new array of 3, in mm. */
  public double[] asArrayXToZ() {
    return get("X", 3);
  }

  /** Returns A to C as a new array of 3, in degrees. */
  public double[] asArrayAToC() {
    return get("A", 3);
  }

  /**
   * Returns X to C as an immutable record.
   *
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public Frame toFrame() {
    return new Frame(getX(), getY(), getZ(), getA(), getB(), getC());
  }

  /** Sets X to C, in mm and degrees. */
  public void setValue(Frame value) {
    set("X", 6, value.x(), value.y(), value.z(), value.a(), value.b(), value.c());
  }
}
