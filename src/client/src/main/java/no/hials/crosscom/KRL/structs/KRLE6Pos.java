package no.hials.crosscom.KRL.structs;

import no.hials.crosscom.protocol.value.E6Pos;

/**
 * Holds an E6POS: a POS with six external axes. The fields are in the order of the original client,
 * E1 to E6 before S and T; a controller prints S and T first.
 *
 * <p>A field that was neither set nor read is 0.0, in getters and in writes, as in JOpenShowVar
 * 0.2.2; {@link #isSet} returns false for it. If a field was missing in the controller's last
 * answer, getters throw {@link IllegalStateException} and writes leave it out until it is set.
 * {@code setX} to {@code setC} and {@code setE1} to {@code setE6} return this structure.
 */
public final class KRLE6Pos extends KRLPos {
  /**
   * Creates a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLE6Pos(String name) {
    super(name, "X", "Y", "Z", "A", "B", "C", "E1", "E2", "E3", "E4", "E5", "E6", "S", "T");
  }

  /** Returns external axis E1, in degrees, or mm for a linear axis. */
  public double getE1() {
    return get("E1");
  }

  /** Returns external axis E2, in degrees, or mm for a linear axis. */
  public double getE2() {
    return get("E2");
  }

  /** Returns external axis E3, in degrees, or mm for a linear axis. */
  public double getE3() {
    return get("E3");
  }

  /** Returns external axis E4, in degrees, or mm for a linear axis. */
  public double getE4() {
    return get("E4");
  }

  /** Returns external axis E5, in degrees, or mm for a linear axis. */
  public double getE5() {
    return get("E5");
  }

  /** Returns external axis E6, in degrees, or mm for a linear axis. */
  public double getE6() {
    return get("E6");
  }

  /** Sets external axis E1, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE1(double d) {
    set("E1", d);
    return this;
  }

  /** Sets external axis E2, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE2(double d) {
    set("E2", d);
    return this;
  }

  /** Sets external axis E3, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE3(double d) {
    set("E3", d);
    return this;
  }

  /** Sets external axis E4, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE4(double d) {
    set("E4", d);
    return this;
  }

  /** Sets external axis E5, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE5(double d) {
    set("E5", d);
    return this;
  }

  /** Sets external axis E6, in degrees, or mm for a linear axis. */
  public KRLE6Pos setE6(double d) {
    set("E6", d);
    return this;
  }

  /** Sets E1 to E6 to exactly 6 values, in degrees, or mm for linear axes. */
  public void setE1ToE6(double... values) {
    set("E1", 6, values);
  }

  /** Returns E1 to E6 as a new array of 6, in degrees, or mm for linear axes. */
  public double[] asArrayE1ToE6() {
    return get("E1", 6);
  }

  @Override
  public KRLE6Pos setX(double d) {
    super.setX(d);
    return this;
  }

  @Override
  public KRLE6Pos setY(double d) {
    super.setY(d);
    return this;
  }

  @Override
  public KRLE6Pos setZ(double d) {
    super.setZ(d);
    return this;
  }

  @Override
  public KRLE6Pos setA(double d) {
    super.setA(d);
    return this;
  }

  @Override
  public KRLE6Pos setB(double d) {
    super.setB(d);
    return this;
  }

  @Override
  public KRLE6Pos setC(double d) {
    super.setC(d);
    return this;
  }

  /**
   * Returns all fields as an immutable record.
   *
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public E6Pos toE6Pos() {
    return new E6Pos(
        getX(),
        getY(),
        getZ(),
        getA(),
        getB(),
        getC(),
        (int) getS(),
        (int) getT(),
        getE1(),
        getE2(),
        getE3(),
        getE4(),
        getE5(),
        getE6());
  }

  /** Sets all fields, in mm and degrees. */
  public void setValue(E6Pos value) {
    set(
        "X",
        12,
        value.x(),
        value.y(),
        value.z(),
        value.a(),
        value.b(),
        value.c(),
        value.e1(),
        value.e2(),
        value.e3(),
        value.e4(),
        value.e5(),
        value.e6());
    set("S", 2, value.s(), value.t());
  }
}
