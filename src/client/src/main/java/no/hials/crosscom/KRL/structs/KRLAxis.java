package no.hials.crosscom.KRL.structs;

import no.hials.crosscom.protocol.value.Axis;

/**
 * Holds an AXIS: the positions of the robot axes A1 to A6, in degrees, or mm for a linear axis.
 *
 * <p>A field that was neither set nor read is 0.0, in getters and in writes, as in JOpenShowVar
 * 0.2.2; {@link #isSet} returns false for it. If a field was missing in the controller's last
 * answer, getters throw {@link IllegalStateException} and writes leave it out until it is set.
 */
public class KRLAxis extends NumberStruct {
  /**
   * Creates a structure whose fields are 0.0.
   *
   * @param name the name on the controller
   */
  public KRLAxis(String name) {
    this(name, "A1", "A2", "A3", "A4", "A5", "A6");
  }

  /**
   * Creates a structure with other fields.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields, including the fields of KRLAxis
   */
  protected KRLAxis(String name, String... nodes) {
    super(name, nodes);
  }

  /** Returns axis A1, in degrees, or mm for a linear axis. */
  public double getA1() {
    return get("A1");
  }

  /** Returns axis A2, in degrees, or mm for a linear axis. */
  public double getA2() {
    return get("A2");
  }

  /** Returns axis A3, in degrees, or mm for a linear axis. */
  public double getA3() {
    return get("A3");
  }

  /** Returns axis A4, in degrees, or mm for a linear axis. */
  public double getA4() {
    return get("A4");
  }

  /** Returns axis A5, in degrees, or mm for a linear axis. */
  public double getA5() {
    return get("A5");
  }

  /** Returns axis A6, in degrees, or mm for a linear axis. */
  public double getA6() {
    return get("A6");
  }

  /** Sets axis A1, in degrees, or mm for a linear axis. */
  public void setA1(double d) {
    set("A1", d);
  }

  /** Sets axis A2, in degrees, or mm for a linear axis. */
  public void setA2(double d) {
    set("A2", d);
  }

  /** Sets axis A3, in degrees, or mm for a linear axis. */
  public void setA3(double d) {
    set("A3", d);
  }

  /** Sets axis A4, in degrees, or mm for a linear axis. */
  public void setA4(double d) {
    set("A4", d);
  }

  /** Sets axis A5, in degrees, or mm for a linear axis. */
  public void setA5(double d) {
    set("A5", d);
  }

  /** Sets axis A6, in degrees, or mm for a linear axis. */
  public void setA6(double d) {
    set("A6", d);
  }

  /** Sets A1 to A6 to exactly 6 values, in degrees, or mm for linear axes. */
  public void setA1ToA6(double... values) {
    set("A1", 6, values);
  }

  /** Returns A1 to A6 as a new array of 6, in degrees, or mm for linear axes. */
  public double[] asArrayA1ToA6() {
    return get("A1", 6);
  }

  /**
   * Returns A1 to A6 as an immutable record.
   *
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public Axis toAxis() {
    return Axis.of(asArrayA1ToA6());
  }

  /** Sets A1 to A6, in degrees, or mm for linear axes. */
  public void setValue(Axis value) {
    set("A1", 6, value.a1(), value.a2(), value.a3(), value.a4(), value.a5(), value.a6());
  }
}
