package no.hials.crosscom.simulator.internal.core;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.motion.SpeedLimit;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import org.junit.jupiter.api.Test;

class AdvanceRunTest {
  private static final int ADVANCE = 3;

  private int started;
  private final AdvanceRun run =
      new AdvanceRun(
          new SystemVariableAccess(new Scope()),
          RobotModel.kr6r900sixx(),
          new Triggers(trigger -> {}),
          new PathStops(stop -> false),
          new CountsMotions());

  /** Executes motions for a time, and never lets the robot run out of them. */
  private void moveForCycles(int cycles) throws Exception {
    for (int cycle = 0; cycle < cycles; cycle++) {
      run.settle(true);
      while (run.ahead() < ADVANCE) {
        run.move(turn(cycle % 2 == 0 ? "{A1 1}" : "{A1 -1}"));
      }
      run.cycle(cycle * (long) ControllerCore.CYCLE_MILLIS, 1, true, SpeedLimit.NONE);
    }
  }

  private static MotionOrder turn(String increment) {
    return new MotionOrder(
        MotionKind.PTP_REL,
        null,
        (KrlStruct) KrlValue.parse(increment),
        OptionalDouble.empty(),
        Set.of(Approximation.C_PTP),
        null,
        "",
        "TEST",
        new Position("test.src", 1, 1),
        List.of());
  }

  @Test
  void keepsNothingOfMotionsThatHaveEnded() throws Exception {
    moveForCycles(1000);

    assertThat(started).isGreaterThan(20);
    assertThat(run.plans()).isLessThanOrEqualTo(ADVANCE + 2);
  }

  @Test
  void keepsNothingOfMotionsThatAreDiscarded() throws Exception {
    for (int i = 0; i < 20; i++) {
      moveForCycles(30);
      run.discard(0);
    }

    assertThat(started).isGreaterThanOrEqualTo(20);
    assertThat(run.plans()).isLessThanOrEqualTo(ADVANCE + 2);
  }

  private final class CountsMotions implements AdvanceRun.Listener {
    @Override
    public void failed(int number, String text) {
      throw new AssertionError(number + " " + text);
    }

    @Override
    public void noticed(int number, String text) {}

    @Override
    public void started(List<Joints> points, Frame base, Frame tool) {
      started++;
    }

    @Override
    public void current(Joints from, Joints to, Frame base, Frame tool) {}

    @Override
    public void leftPath(Joints axes) {}
  }
}
