package no.hials.crosscom.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.mock.Controller;
import no.hials.crosscom.mock.KrlFileException;
import no.hials.crosscom.mock.OperatingMode;

/** Makes a simulated controller ready to be driven, as a person would a real one. */
final class DriveSimulation {
  /** Not with A5 at 0, from where the tool cannot move straight in every direction. */
  private static final Axes START = Axes.of(0, -90, 90, 0, 45, 0);

  private DriveSimulation() {}

  /**
   * Loads and starts the programs of {@code krl}: the one that moves the robot and the watchdog.
   */
  static void start(Controller controller, DriveSpace space) {
    controller.place(START);
    load(controller, "config.dat");
    load(controller, space.program + ".dat");
    String program = load(controller, space.program + ".src");
    String submit = load(controller, "jov_sps.sub");
    controller.setMode(OperatingMode.AUT);
    try {
      controller.submit().select(submit);
      controller.robot().select(program);
    } catch (KrlFileException e) {
      throw new IllegalStateException(e);
    }
    controller.submit().start();
    controller.start();
  }

  private static String load(Controller controller, String name) {
    try (InputStream file = DriveSimulation.class.getResourceAsStream("krl/" + name)) {
      if (file == null) {
        throw new IllegalStateException("the program has no " + name);
      }
      return controller.load(name, new String(file.readAllBytes(), StandardCharsets.ISO_8859_1));
    } catch (KrlFileException e) {
      throw new IllegalStateException(e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
