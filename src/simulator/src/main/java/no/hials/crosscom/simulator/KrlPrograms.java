package no.hials.crosscom.simulator;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;

/** Prepares a simulated controller to follow a client, as a person would prepare a real one. */
public final class KrlPrograms {
  /** A5 is not 0, because there the tool cannot move straight in every direction. */
  public static final Axis START = Axis.of(0, -90, 90, 0, 45, 0);

  private static final String FOLDER = "client/";

  private KrlPrograms() {}

  /**
   * Loads and starts programs of {@code krl}, which the build puts into the jar: the one that moves
   * the robot, and the watchdog.
   *
   * @param controller the simulated controller, which is switched to mode AUT
   * @param start the initial position of its axes
   * @param program the program's file without its ending, such as {@code actuator}
   * @throws IOException if a file cannot be read
   */
  public static void start(Controller controller, Axis start, String program) throws IOException {
    controller.place(start);
    try {
      load(controller, "config.dat");
      load(controller, program + ".dat");
      String robot = load(controller, program + ".src");
      String submit = load(controller, "jov_sps.sub");
      controller.setMode(OperatingMode.AUT);
      controller.submit().select(submit);
      controller.robot().select(robot);
    } catch (KrlFileException e) {
      throw new IllegalStateException("the programs of this build have errors", e);
    }
    controller.submit().start();
    controller.runProgram();
  }

  private static String load(Controller controller, String name)
      throws IOException, KrlFileException {
    try (InputStream file = KrlPrograms.class.getResourceAsStream(FOLDER + name)) {
      if (file == null) {
        throw new IOException("there is no " + name + " in this build");
      }
      return controller.load(name, new String(file.readAllBytes(), StandardCharsets.ISO_8859_1));
    }
  }
}
