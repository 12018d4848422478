package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;

final class KinematicsPropertyTest {

  /** A robot and a position inside its limits. */
  record Pose(RobotModel robot, Axis axes) {

    /** Returns whether all solutions for the flange are away from singularities. */
    boolean isRegular() {
      return robot.inverse(robot.forward(axes)).stream()
          .allMatch(solution -> Math.abs(determinant(robot.jacobian(solution))) > 1);
    }

    /** Reduces the matrix to a triangle; its determinant is the product of the diagonal. */
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

  @Test
  void statusAndTurnLeadBackToTheAxes() {
    Samples.forAll(
        KinematicsPropertyTest::regularPose,
        pose -> {
          RobotModel robot = pose.robot();
          Axis axes = pose.axes();

          Axis found = robot.inverse(robot.forward(axes), robot.status(axes), robot.turn(axes));

          assertThat(found.largestDifference(axes)).isLessThan(1e-6);
        });
  }

  @Test
  void theSolutionNearestToTheAxesIsTheAxes() {
    Samples.forAll(
        KinematicsPropertyTest::regularPose,
        pose -> {
          Axis found = pose.robot().inverse(pose.robot().forward(pose.axes()), pose.axes());

          assertThat(found.largestDifference(pose.axes())).isLessThan(1e-6);
        });
  }

  @Test
  void everySolutionBringsTheFlangeBackWithAStatusOfItsOwn() {
    Samples.forAll(
        KinematicsPropertyTest::regularPose,
        pose -> {
          RobotModel robot = pose.robot();
          Frame flange = robot.forward(pose.axes());

          List<Axis> solutions = robot.inverse(flange);

          assertThat(solutions).extracting(robot::status).isSorted().doesNotHaveDuplicates();
          assertThat(solutions)
              .hasSizeBetween(4, 8)
              .allSatisfy(
                  axes -> {
                    assertThat(robot.forward(axes).distance(flange)).isLessThan(1e-6);
                    assertThat(angle(robot.forward(axes), flange)).isLessThan(1e-6);
                    assertThat(DoubleStream.of(axes.toArray()))
                        .allMatch(angle -> angle > -180 && angle <= 180);
                  });
        });
  }

  @Test
  void aSingularPoseHasSolutionsWithinTheToleranceOfTheReference() {
    Samples.forAll(
        KinematicsPropertyTest::pose,
        pose -> {
          RobotModel robot = pose.robot();
          Frame flange = robot.forward(pose.axes());

          assertThat(robot.inverse(flange))
              .isNotEmpty()
              .allSatisfy(
                  axes -> {
                    assertThat(robot.forward(axes).distance(flange)).isLessThan(0.01);
                    assertThat(angle(robot.forward(axes), flange)).isLessThan(0.001);
                  });
        });
  }

  @Test
  void theJacobianIsWhatSmallStepsOfTheAxesDo() {
    Samples.forAll(
        KinematicsPropertyTest::pose,
        pose -> {
          double[][] jacobian = pose.robot().jacobian(pose.axes());

          for (int axis = 0; axis < 6; axis++) {
            double[] measured = centralDifference(pose, axis);
            for (int row = 0; row < 6; row++) {
              assertThat(Math.abs(jacobian[row][axis] - measured[row])).isLessThan(1e-5);
            }
          }
        });
  }

  /** Returns the column of an axis: the motion of the flange in mm and degrees per degree. */
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

  private static Pose regularPose(Random random) {
    Pose pose = pose(random);
    return pose.isRegular() ? pose : regularPose(random);
  }

  private static Pose pose(Random random) {
    RobotModel robot = random.nextBoolean() ? Robots.KR6 : Robots.INVENTED;
    return new Pose(
        robot,
        new Axis(
            axis(random, robot, 0),
            axis(random, robot, 1),
            axis(random, robot, 2),
            axis(random, robot, 3),
            axis(random, robot, 4),
            axis(random, robot, 5)));
  }

  private static double axis(Random random, RobotModel robot, int axis) {
    // Within one revolution, the range of Status and Turn.
    double minimum = Math.max(-359, robot.minimum(axis));
    double maximum = Math.min(359, robot.maximum(axis));
    return Samples.between(random, minimum, maximum);
  }
}
