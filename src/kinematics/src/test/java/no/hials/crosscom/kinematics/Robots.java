package no.hials.crosscom.kinematics;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Objects;

/** The robots of the tests. */
final class Robots {
  static final RobotModel KR6 = RobotModel.kr6r900sixx();
  static final RobotModel INVENTED = invented();

  /** A3 of the KR 6 R900 sixx with the arm straight: atan(35/420). */
  static final double STRAIGHT = Math.toDegrees(Math.atan2(35, 420));

  private Robots() {}

  private static RobotModel invented() {
    try {
      return RobotModel.load(
          Path.of(
              Objects.requireNonNull(Robots.class.getResource("invented-r700.properties"))
                  .toURI()));
    } catch (IOException | URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
