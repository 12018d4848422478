package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/** Measures the speed of the simulation on this machine. It needs the simulation. */
public final class MeasureTheSimulation {
  private static final double CYCLE_SECONDS = 0.012;

  private static final String POINT_TO_POINT =
      """
      DEF PROGRAM ( )
        BAS(#INITMOV,0)
        LOOP
          PTP {A1 20} C_PTP
          PTP {A1 -20} C_PTP
        ENDLOOP
      END
      """;

  private static final String SQUARE =
      """
      DEF PROGRAM ( )
        BAS(#INITMOV,0)
        PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
        LOOP
          LIN_REL {X -100} C_DIS
          LIN_REL {Y 100} C_DIS
          LIN_REL {X 100} C_DIS
          LIN_REL {Y -100} C_DIS
        ENDLOOP
      END
      """;

  private static final String SMALL_STEPS =
      """
      DEF PROGRAM ( )
        BAS(#INITMOV,0)
        $ADVANCE=1
        LOOP
          PTP_REL {A1 0.01} C_PTP
          PTP_REL {A1 -0.01} C_PTP
        ENDLOOP
      END
      """;

  private static final String NO_MOTION =
      """
      DEF PROGRAM ( )
        LOOP
          $FLAG[1]=NOT $FLAG[1]
        ENDLOOP
      END
      """;

  private MeasureTheSimulation() {}

  /**
   * Runs the example.
   *
   * @param args the number of minutes to simulate, by default 10
   * @throws IOException if the server could not be started
   * @throws KrlFileException if a program has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    Duration time = Duration.ofMinutes(args.length == 0 ? 10 : Integer.parseInt(args[0]));
    measure("PTP with C_PTP", POINT_TO_POINT, time);
    measure("LIN with C_DIS", SQUARE, time);
    measure("the smallest PTP_REL", SMALL_STEPS, time);
    measure("LOOP without motion", NO_MOTION, time);
  }

  private static void measure(String what, String program, Duration time)
      throws IOException, KrlFileException {
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()))) {
      Controller controller = robot.controller();
      controller.setMode(OperatingMode.AUT);
      controller.robot().select(controller.load("program.src", program));
      controller.runProgram();
      long begin = System.nanoTime();
      controller.step(time);
      double seconds = (System.nanoTime() - begin) / 1e9;
      if (controller.robot().state() != ProgramState.ACTIVE) {
        throw new IllegalStateException("the program has stopped: " + controller.messages());
      }
      System.out.printf(
          "%s: %d s in %.1f s, %.0f cycles a second%n",
          what, time.toSeconds(), seconds, time.toSeconds() / CYCLE_SECONDS / seconds);
    }
  }
}
