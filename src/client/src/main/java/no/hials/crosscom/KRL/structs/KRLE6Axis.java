package no.hials.crosscom.KRL.structs;

import no.hials.crosscom.protocol.value.E6Axis;

/**
 * Holds an E6AXIS: the positions of the robot axes A1 to A6 and of the external axes E1 to E6.
 *
 * <p>A field that was neither set nor read is 0.0, in getters and in writes, as in JOpenShowVar
 * 0.2.2; {@link #isSet} returns false for it. If a field was missing in the controller's last
 * answer, getters throw {@link IllegalStateException} and writes leave it out until it is set.
 */
public class KRLE6Axis extends KRLAxis {
  /**
   * Creates a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLE6Axis(String name) {
    super(name, "A1", "A2", "A3", "A4", "A5", "A6", "E1", "E2", "E3", "E4", "E5", "E6");
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
  public void setE1(double d) {
    set("E1", d);
  }

  /** Sets external axis E2, in degrees, or mm for a linear axis. */
  public void setE2(double d) {
    set("E2", d);
  }

  /** Sets external axis E3, in degrees, or mm for a linear axis. */
  public void setE3(double d) {
    set("E3", d);
  }

  /** Sets external axis E4, in degrees, or mm for a linear axis. */
  public void setE4(double d) {
    set("E4", d);
  }

  /** Sets external axis E5, in degrees, or mm for a linear axis. */
  public void setE5(double d) {
    set("E5", d);
  }

  /** Sets external axis E6, in degrees, or mm for a linear axis. */
  public void setE6(double d) {
    set("E6", d);
  }

  /** Sets E1 to E6 to exactly 6 values, in degrees, or mm for linear axes. */
  public void setE1ToE6(double... values) {
    set("E1", 6, values);
  }

  /** Returns E1 to E6 as a new array of 6, in degrees, or mm for linear axes. */
  public double[] asArrayE1ToE6() {
    return get("E1", 6);
  }

  /**
   * Returns all fields as an immutable record.
   *
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public E6Axis toE6Axis() {
    return new E6Axis(
        getA1(), getA2(), getA3(), getA4(), getA5(), getA6(), getE1(), getE2(), getE3(), getE4(),
        getE5(), getE6());
  }

  /** Sets all fields, in degrees, or mm for linear axes. */
  public void setValue(E6Axis value) {
    set(
        "A1",
        12,
        value.a1(),
        value.a2(),
        value.a3(),
        value.a4(),
        value.a5(),
        value.a6(),
        value.e1(),
        value.e2(),
        value.e3(),
        value.e4(),
        value.e5(),
        value.e6());
  }
}
