package no.hials.crosscom.KRL.structs;

/**
 * Holds an E6AXIS: the positions of the robot axes A1 to A6 and of the external axes E1 to E6.
 *
 * <p>Getters throw {@link IllegalStateException} if the field was missing in the controller's last
 * answer. Setters return this structure.
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
  public KRLE6Axis setE1(double d) {
    set("E1", d);
    return this;
  }

  /** Sets external axis E2, in degrees, or mm for a linear axis. */
  public KRLE6Axis setE2(double d) {
    set("E2", d);
    return this;
  }

  /** Sets external axis E3, in degrees, or mm for a linear axis. */
  public KRLE6Axis setE3(double d) {
    set("E3", d);
    return this;
  }

  /** Sets external axis E4, in degrees, or mm for a linear axis. */
  public KRLE6Axis setE4(double d) {
    set("E4", d);
    return this;
  }

  /** Sets external axis E5, in degrees, or mm for a linear axis. */
  public KRLE6Axis setE5(double d) {
    set("E5", d);
    return this;
  }

  /** Sets external axis E6, in degrees, or mm for a linear axis. */
  public KRLE6Axis setE6(double d) {
    set("E6", d);
    return this;
  }

  /** Sets E1 to E6 to exactly 6 values, in degrees, or mm for linear axes. */
  public KRLE6Axis setE1ToE6(double... values) {
    set("E1", 6, values);
    return this;
  }

  /** Returns E1 to E6 as a new array of 6, in degrees, or mm for linear axes. */
  public double[] asArrayE1ToE6() {
    return get("E1", 6);
  }

  @Override
  public KRLE6Axis setA1(double d) {
    super.setA1(d);
    return this;
  }

  @Override
  public KRLE6Axis setA2(double d) {
    super.setA2(d);
    return this;
  }

  @Override
  public KRLE6Axis setA3(double d) {
    super.setA3(d);
    return this;
  }

  @Override
  public KRLE6Axis setA4(double d) {
    super.setA4(d);
    return this;
  }

  @Override
  public KRLE6Axis setA5(double d) {
    super.setA5(d);
    return this;
  }

  @Override
  public KRLE6Axis setA6(double d) {
    super.setA6(d);
    return this;
  }

  @Override
  public KRLE6Axis setA1ToA6(double... values) {
    super.setA1ToA6(values);
    return this;
  }
}
