package no.hials.crosscom.lab.plot;

/** The course of a point in space. Immutable. */
public final class Track {
  private final String name;
  private final double[] x;
  private final double[] y;
  private final double[] z;

  private Track(String name, double[] x, double[] y, double[] z) {
    if (x.length != y.length || y.length != z.length) {
      throw new IllegalArgumentException(
          "a track must have as many x as y and z, has "
              + x.length
              + ", "
              + y.length
              + " and "
              + z.length);
    }
    this.name = name;
    this.x = x.clone();
    this.y = y.clone();
    this.z = z.clone();
  }

  /**
   * Creates a track.
   *
   * @param name what the legend calls it
   * @param x where the point was
   * @param y as many
   * @param z as many; a gap where one of the three is NaN
   * @return the track
   */
  public static Track of(String name, double[] x, double[] y, double[] z) {
    return new Track(name, x, y, z);
  }

  String name() {
    return name;
  }

  double[] x() {
    return x.clone();
  }

  double[] y() {
    return y.clone();
  }

  double[] z() {
    return z.clone();
  }
}
