package no.hials.crosscom.examples;

import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import java.io.IOException;
import java.util.Locale;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.Pos;

/**
 * Computes the pose of the flange and the axis angles for it, and compares the pose with {@code
 * $POS_ACT}. It needs the simulation, since it places the robot.
 */
public final class SolveKinematics {
  private static final Axis AXES = Axis.of(30, -80, 100, 10, 60, -20);
  private static final Frame TOOL = new Frame(0, 0, 120, 0, 0, 0);
  private static final Frame BASE = new Frame(400, 0, 0, 90, 0, 0);

  private SolveKinematics() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed
   * @throws UnreachableException if the robot cannot reach its own position
   */
  public static void main(String[] args) throws IOException, UnreachableException {
    RobotModel model = RobotModel.kr6r900sixx();
    Frame flange = model.forward(AXES);
    System.out.println("computed: " + text(flange));
    for (Axis solution : model.inverse(flange)) {
      String name = "S " + model.status(solution) + ", T " + model.turn(solution);
      boolean possible = model.axesOutsideLimits(solution).isEmpty();
      System.out.println(name + ": " + text(solution) + (possible ? "" : " beyond a limit"));
    }
    int status = model.status(AXES);
    int turn = model.turn(AXES);
    System.out.println("by S and T: " + text(model.inverse(flange, status, turn)));

    System.out.println("with tool and base: " + text(product(inverse(BASE), flange, TOOL)));
    compare(flange);

    try {
      model.inverse(new Frame(1200, 0, 400, 0, 90, 0), AXES);
    } catch (UnreachableException e) {
      System.out.println(e.reason() + ": " + e.getMessage());
    }
  }

  private static void compare(Frame computed) throws IOException {
    try (MockServer robot = MockServer.start();
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      robot.controller().place(AXES);
      Pos position = client.read("$POS_ACT", Pos.class);
      System.out.println("$POS_ACT: " + text(position.frame()));
      System.out.println("S " + position.s() + ", T " + position.t());
      double apart = computed.distance(position.frame());
      System.out.println(apart < 0.001 ? "the same place" : "apart by " + apart + " mm");

      client.write("$TOOL", TOOL);
      client.write("$BASE", BASE);
      Frame seen = client.read("$POS_ACT", Frame.class);
      System.out.println("with $TOOL and $BASE: " + text(seen));
    }
  }

  private static String text(Frame f) {
    return String.format(
        Locale.ROOT,
        "X %.3f, Y %.3f, Z %.3f, A %.4f, B %.4f, C %.4f",
        f.x(),
        f.y(),
        f.z(),
        f.a(),
        f.b(),
        f.c());
  }

  private static String text(Axis axes) {
    StringBuilder text = new StringBuilder();
    for (double angle : axes.toArray()) {
      text.append(String.format(Locale.ROOT, "%.3f ", angle));
    }
    return text.toString().strip();
  }
}
