package no.hials.crosscom.lab.plot;

/** The path of a point in space. Immutable. */
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
   * @param name its name in the legend
   * @param x the x coordinates of the point
   * @param y the y coordinates, as many
   * @param z the z coordinates, as many; the track has a gap where one of the three is NaN
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
