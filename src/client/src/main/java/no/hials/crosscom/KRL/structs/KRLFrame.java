package no.hials.crosscom.KRL.structs;

/**
 * Holds a FRAME: a position X, Y, Z in mm and an orientation A, B, C in degrees, which is {@code
 * Rz(A) Ry(B) Rx(C)} (docs/reference/kinematics.md#orientation).
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

  /**
   * Returns the position along X.
   *
   * @return mm
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getX() {
    return get("X");
  }

  /**
   * Returns the position along Y.
   *
   * @return mm
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getY() {
    return get("Y");
  }

  /**
   * Returns the position along Z.
   *
   * @return mm
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getZ() {
    return get("Z");
  }

  /**
   * Returns the rotation about Z.
   *
   * @return degrees
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getA() {
    return get("A");
  }

  /**
   * Returns the rotation about the new Y'.
   *
   * @return degrees
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getB() {
    return get("B");
  }

  /**
   * Returns the rotation about the new X''.
   *
   * @return degrees
   * @throws IllegalStateException if it was missing in the controller's last answer
   */
  public double getC() {
    return get("C");
  }

  /**
   * Sets the position along X.
   *
   * @param d mm
   * @return this
   */
  public KRLFrame setX(double d) {
    set("X", d);
    return this;
  }

  /**
   * Sets the position along Y.
   *
   * @param d mm
   * @return this
   */
  public KRLFrame setY(double d) {
    set("Y", d);
    return this;
  }

  /**
   * Sets the position along Z.
   *
   * @param d mm
   * @return this
   */
  public KRLFrame setZ(double d) {
    set("Z", d);
    return this;
  }

  /**
   * Sets the rotation about Z.
   *
   * @param d degrees
   * @return this
   */
  public KRLFrame setA(double d) {
    set("A", d);
    return this;
  }

  /**
   * Sets the rotation about the new Y'.
   *
   * @param d degrees
   * @return this
   */
  public KRLFrame setB(double d) {
    set("B", d);
    return this;
  }

  /**
   * Sets the rotation about the new X''.
   *
   * @param d degrees
   * @return this
   */
  public KRLFrame setC(double d) {
    set("C", d);
    return this;
  }

  /**
   * Sets X to Z.
   *
   * @param values exactly 3; mm
   * @return this
   */
  public KRLFrame setXToZ(double... values) {
    set("X", 3, values);
    return this;
  }

  /**
   * Sets A to C.
   *
   * @param values exactly 3; degrees
   * @return this
   */
  public KRLFrame setAToC(double... values) {
    set("A", 3, values);
    return this;
  }

  /**
   * Returns X to Z.
   *
   * @return a new array of 3; mm
   */
  public double[] asArrayXToZ() {
    return get("X", 3);
  }

  /**
   * Returns A to C.
   *
   * @return a new array of 3; degrees
   */
  public double[] asArrayAToC() {
    return get("A", 3);
  }
}
