package no.hials.crosscom.simulator.internal.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class ProfileTest {
  @Test
  void hasTheRampsOfATrapezoid() {
    Profile profile = Trapezoid.of(10, 2, 4);

    assertThat(profile.duration()).isCloseTo(5.5, within(1e-12));
    assertThat(profile.rampUp()).isEqualTo(0.5);
    assertThat(profile.position(0.5)).isCloseTo(0.5, within(1e-12));
    assertThat(profile.position(2.75)).isCloseTo(5, within(1e-12));
    assertThat(profile.position(5.25)).isCloseTo(10 - 0.125, within(1e-12));
    assertThat(profile.position(6)).isEqualTo(10);
  }

  @Test
  void hasNoRampShorterThanTheShortest() {
    Profile profile = Trapezoid.of(1e-6, 1000, 1000);

    assertThat(profile.duration()).isCloseTo(2 * Trapezoid.SHORTEST_RAMP, within(1e-12));
    assertThat(profile.position(Trapezoid.SHORTEST_RAMP)).isCloseTo(5e-7, within(1e-15));
  }

  @Test
  void slowsDownBeforeASlowPointAndSpeedsUpAfterIt() {
    double[] positions = {0, 1, 2, 3, 4, 5, 6};
    double[] speeds = {9, 9, 9, 0.5, 9, 9, 9};
    double[] accelerations = {1, 1, 1, 1, 1, 1, 1};
    Profile profile = SampledProfile.of(new PathLimits(positions, speeds, accelerations));

    // From 0 to 0.5 over 3: up to a middle speed, and down.
    double middle = Math.sqrt((2 * 3 + 0.25) / 2);
    double ideal = 2 * (2 * middle - 0.5);
    assertThat(profile.duration()).isCloseTo(ideal, within(1e-9));
    assertThat(profile.position(profile.duration() / 2)).isCloseTo(3, within(1e-9));
    assertThat(profile.rampUp()).isCloseTo(middle, within(1e-9));
    assertThat(profile.rampDown()).isCloseTo(profile.rampUp(), within(1e-9));
    double before = 0;
    for (double time = 0; time < profile.duration(); time += 0.01) {
      double speed = (profile.position(time + 0.01) - profile.position(time)) / 0.01;
      assertThat(Math.abs(speed - before)).isLessThan(0.0101);
      before = speed;
    }
  }

  @Test
  void stretchesLimitedProfilesToTheShortestRamps() {
    double[] limits = {1e6, 1e6, 1e6};
    Profile profile = SampledProfile.of(new PathLimits(new double[] {0, 0.5, 1}, limits, limits));

    assertThat(profile.duration()).isCloseTo(2 * Trapezoid.SHORTEST_RAMP, within(1e-12));
    assertThat(profile.position(Trapezoid.SHORTEST_RAMP)).isCloseTo(0.5, within(1e-9));
    assertThat(profile.position(1)).isEqualTo(1);
  }

  @Test
  void returnsTheTimeOfEachPositionEvenWhereItStops() {
    double[] positions = {0, 1, 2, 3, 4};
    double[] speeds = {2, 2, 0.5, 2, 2};
    double[] accelerations = {1, 1, 1, 1, 1};
    PathLimits limits = new PathLimits(positions, speeds, accelerations).withStop(2.5);
    for (Profile profile : List.of(SampledProfile.of(limits), Trapezoid.of(4, 1, 2))) {
      for (double time = 0; time <= profile.duration(); time += 0.01) {
        double position = profile.position(time);
        assertThat(profile.position(profile.time(position))).isCloseTo(position, within(1e-9));
        double ahead = (profile.position(time + 1e-6) - position) / 1e-6;
        assertThat(profile.speed(time)).isCloseTo(ahead, within(1e-3));
      }
    }
    Profile stopping = SampledProfile.of(limits);
    assertThat(stopping.speed(stopping.time(2.5))).isCloseTo(0, within(1e-9));
  }
}
