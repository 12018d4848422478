package no.hials.crosscom.kinematics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.DoubleStream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

final class KinematicsPropertyTest {

  /** A robot and a position inside its limits. */
  record Pose(RobotModel robot, Axes axes) {

    /** Tells whether no solution for the flange, this one or another, is near a singularity. */
    boolean isRegular() {
      return robot.inverse(robot.forward(axes)).stream()
          .allMatch(solution -> Math.abs(determinant(robot.jacobian(solution))) > 1);
    }

    /** Reduces the matrix to a triangle, of which the determinant is the diagonal's product. */
    private static double determinant(double[][] matrix) {
      double product = 1;
      for (int i = 0; i < matrix.length; i++) {
        int pivot = i;
        for (int row = i + 1; row < matrix.length; row++) {
          pivot = Math.abs(matrix[row][i]) > Math.abs(matrix[pivot][i]) ? row : pivot;
        }
        double[] top = matrix[pivot];
        matrix[pivot] = matrix[i];
        matrix[i] = top;
        if (top[i] == 0) {
          return 0;
        }
        product *= pivot == i ? top[i] : -top[i];
        for (int row = i + 1; row < matrix.length; row++) {
          double factor = matrix[row][i] / top[i];
          for (int j = i; j < matrix.length; j++) {
            matrix[row][j] -= factor * top[j];
          }
        }
      }
      return product;
    }
  }

  @Property(tries = 300)
  void statusAndTurnLeadBackToTheAxes(@ForAll("regularPoses") Pose pose) throws Exception {
    RobotModel robot = pose.robot();
    Axes axes = pose.axes();

    Axes found = robot.inverse(robot.forward(axes), robot.status(axes), robot.turn(axes));

    assertThat(found.largestDifference(axes)).isLessThan(1e-6);
  }

  @Property(tries = 300)
  void theSolutionNearestToTheAxesIsTheAxes(@ForAll("regularPoses") Pose pose) throws Exception {
    Axes found = pose.robot().inverse(pose.robot().forward(pose.axes()), pose.axes());

    assertThat(found.largestDifference(pose.axes())).isLessThan(1e-6);
  }

  @Property(tries = 300)
  void everySolutionBringsTheFlangeBackWithAStatusOfItsOwn(@ForAll("regularPoses") Pose pose) {
    RobotModel robot = pose.robot();
    Frame flange = robot.forward(pose.axes());

    List<Axes> solutions = robot.inverse(flange);

    assertThat(solutions).extracting(robot::status).isSorted().doesNotHaveDuplicates();
    assertThat(solutions)
        .hasSizeBetween(4, 8)
        .allSatisfy(
            axes -> {
              assertThat(robot.forward(axes).distance(flange)).isLessThan(1e-6);
              assertThat(robot.forward(axes).angle(flange)).isLessThan(1e-6);
              assertThat(DoubleStream.of(axes.toArray()))
                  .allMatch(angle -> angle > -180 && angle <= 180);
            });
  }

  @Property(tries = 300)
  void aSingularPoseHasSolutionsWithinTheToleranceOfTheReference(@ForAll("poses") Pose pose) {
    RobotModel robot = pose.robot();
    Frame flange = robot.forward(pose.axes());

    assertThat(robot.inverse(flange))
        .isNotEmpty()
        .allSatisfy(
            axes -> {
              assertThat(robot.forward(axes).distance(flange)).isLessThan(0.01);
              assertThat(robot.forward(axes).angle(flange)).isLessThan(0.001);
            });
  }

  @Property(tries = 300)
  void theJacobianIsWhatSmallStepsOfTheAxesDo(@ForAll("poses") Pose pose) {
    double[][] jacobian = pose.robot().jacobian(pose.axes());

    for (int axis = 0; axis < 6; axis++) {
      double[] measured = centralDifference(pose, axis);
      for (int row = 0; row < 6; row++) {
        assertThat(Math.abs(jacobian[row][axis] - measured[row])).isLessThan(1e-5);
      }
    }
  }

  /** Gives the column of an axis: mm and degrees by which the flange moves per degree. */
  private static double[] centralDifference(Pose pose, int axis) {
    double step = 0.001;
    double angle = pose.axes().get(axis);
    Transform after = Transform.of(pose.robot().forward(pose.axes().with(axis, angle + step)));
    Transform before = Transform.of(pose.robot().forward(pose.axes().with(axis, angle - step)));
    Vector way = after.position().minus(before.position()).times(0.5 / step);
    Rotation turn = after.rotation().times(before.rotation().inverse());
    double scale = Math.copySign(Math.toDegrees(2) * 0.5 / step, turn.w());
    return new double[] {
      way.x(), way.y(), way.z(), turn.x() * scale, turn.y() * scale, turn.z() * scale
    };
  }

  @Provide
  Arbitrary<Pose> regularPoses() {
    return poses().filter(Pose::isRegular);
  }

  @Provide
  Arbitrary<Pose> poses() {
    return Arbitraries.of(Robots.KR6, Robots.INVENTED)
        .flatMap(
            robot ->
                Combinators.combine(
                        axis(robot, 0),
                        axis(robot, 1),
                        axis(robot, 2),
                        axis(robot, 3),
                        axis(robot, 4),
                        axis(robot, 5))
                    .as(Axes::new)
                    .map(axes -> new Pose(robot, axes)));
  }

  private static Arbitrary<Double> axis(RobotModel robot, int axis) {
    // Within one turn: what Status and Turn can say.
    double minimum = Math.max(-359, robot.minimum(axis));
    double maximum = Math.min(359, robot.maximum(axis));
    return Arbitraries.doubles().between(minimum, maximum);
  }
}
