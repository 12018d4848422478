package no.hials.crosscom.lab.experiment;

/**
 * A figure in a plane. It begins at the origin; a part of 1 is one lap, and larger parts continue
 * with the next lap.
 */
enum Shape {
  /** Two waves there; two waves back in the next lap. */
  SINUSOID {
    @Override
    Point at(double part) {
      double half = Math.floorMod((long) Math.floor(part), 2L) + part - Math.floor(part);
      double along = half <= 1 ? half : 2 - half;
      return new Point(LENGTH * along, HEIGHT * Math.sin(4 * Math.PI * part));
    }

    @Override
    Point velocity(double part) {
      boolean there = Math.floorMod((long) Math.floor(part), 2L) == 0;
      return new Point(
          there ? LENGTH : -LENGTH, HEIGHT * 4 * Math.PI * Math.cos(4 * Math.PI * part));
    }
  },

  /** Round a square with sides of 2. */
  SQUARE {
    @Override
    Point at(double part) {
      double way = 4 * (part - Math.floor(part));
      double side = 2 * (way - Math.floor(way));
      return switch ((int) way) {
        case 0 -> new Point(side, 0);
        case 1 -> new Point(2, side);
        case 2 -> new Point(2 - side, 2);
        default -> new Point(0, 2 - side);
      };
    }

    @Override
    Point velocity(double part) {
      return switch ((int) (4 * (part - Math.floor(part)))) {
        case 0 -> new Point(8, 0);
        case 1 -> new Point(0, 8);
        case 2 -> new Point(-8, 0);
        default -> new Point(0, -8);
      };
    }
  },

  /** Round a circle with a radius of 1. */
  CIRCLE {
    @Override
    Point at(double part) {
      double angle = 2 * Math.PI * part;
      return new Point(Math.sin(angle), 1 - Math.cos(angle));
    }

    @Override
    Point velocity(double part) {
      double angle = 2 * Math.PI * part;
      return new Point(2 * Math.PI * Math.cos(angle), 2 * Math.PI * Math.sin(angle));
    }
  };

  private static final double LENGTH = 3;
  private static final double HEIGHT = 0.8;

  /**
   * A point, or a velocity per lap.
   *
   * @param u to the right
   * @param v upwards
   */
  record Point(double u, double v) {
    Point times(double factor) {
      return new Point(u * factor, v * factor);
    }
  }

  /** Returns the point of the figure. */
  abstract Point at(double part);

  /** Returns the velocity along the figure. */
  abstract Point velocity(double part);
}
