package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.SplineSegment.Shape;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines and splines in any order, whose corners are cut, planned at any time. */
class ChainTest {
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = Ride.ROBOT.forward(START);

  @ParameterizedTest
  @ValueSource(longs = {3, 9, 65, 99, 145, 168, 263, 296})
  void keepsTheLimitsOfTheAxesAndEndsAtItsTarget(long seed) throws MotionRefusedException {
    Random random = new Random(seed);
    Ride ride = new Ride(START);
    Frame last = FROM;
    int left = 8;
    do {
      if (left > 0 && ride.system.planned() < 3 && random.nextInt(4) > 0) {
        left--;
        last = add(ride, random);
      }
      ride.cycle();
    } while (left > 0 || !ride.system.finished());

    assertThat(ride.events).hasSize(16);
    assertThat(ride.system.flange().distance(last)).isCloseTo(0, within(1e-6));
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(Ride.ROBOT.maxSpeed(axis) * 1.001);
      // the bends between two computed points are estimated
      assertThat(ride.peakAcceleration(axis)).isLessThan(Ride.ROBOT.maxAcceleration(axis) * 1.3);
    }
  }

  private static Frame add(Ride ride, Random random) throws MotionRefusedException {
    PathRates rates = new PathRates(Math.pow(10, random.nextDouble() * 1.5 - 1.2), 2.3, 200, 100);
    Distance zone = new Distance(Math.pow(10, random.nextDouble() * 2.5 - 0.3));
    if (random.nextBoolean()) {
      Frame target = point(random);
      ride.lin(target, Frame.IDENTITY, rates, OrientationControl.VAR, zone);
      return target;
    }
    List<SplineSegment> segments = new ArrayList<>();
    int count = 1 + random.nextInt(5);
    for (int i = 0; i < count; i++) {
      segments.add(
          new SplineSegment(
              random.nextBoolean() ? Shape.THROUGH : Shape.LINE,
              null,
              point(random),
              OptionalDouble.empty(),
              rates,
              OrientationControl.VAR,
              ExternalTarget.of(Axis.ZERO)));
    }
    ride.spline(segments, zone);
    return segments.get(count - 1).target();
  }

  private static Frame point(Random random) {
    Frame moved =
        new Frame(
            FROM.x() + random.nextInt(160) - 80,
            FROM.y() + random.nextInt(300) - 150,
            FROM.z() + random.nextInt(160) - 80,
            FROM.a(),
            FROM.b(),
            FROM.c());
    Frame turn =
        new Frame(
            0, 0, 0, random.nextInt(30) - 15, random.nextInt(30) - 15, random.nextInt(30) - 15);
    return product(moved, turn);
  }
}
