package no.hials.crosscom.examples;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import org.jspecify.annotations.Nullable;

/**
 * Connects an example that moves a robot to the controller on its command line, or to a simulated
 * controller that runs programs of {@code krl}.
 */
final class Cell implements Closeable {
  /**
   * The start position of the simulated robot. It is not the home position, from where a straight
   * path passes a singularity.
   */
  static final Axis START = Axis.of(0, -90, 90, 0, 45, 0);

  private final @Nullable MockServer mock;
  private final CrossComClient client;

  private Cell(@Nullable MockServer mock, String host, int port) throws IOException {
    this.mock = mock;
    this.client = new CrossComClient(host, port);
  }

  /**
   * Connects. The simulated controller runs in AUT, with the watchdog as submit program.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @param program the program of {@code krl} that moves the robot; on a real controller it must
   *     already run
   * @param ready the variable that the program changes when it is ready
   */
  static Cell of(String[] args, String program, String ready) throws IOException, KrlFileException {
    if (Arguments.nameAController(args)) {
      return new Cell(null, args[0], Integer.parseInt(args[1]));
    }
    MockServer mock = MockServer.start();
    Controller controller = mock.controller();
    controller.load(KrlFolder.file("config.dat"));
    controller.setMode(OperatingMode.AUT);
    controller.place(START);
    controller.submit().select(controller.load(KrlFolder.file("jov_sps.sub")));
    controller.submit().start();
    Cell cell = new Cell(mock, mock.host(), mock.port());
    String before = cell.client.readText(ready);
    controller.robot().select(controller.load(KrlFolder.file(program)));
    controller.runProgram();
    cell.awaitOther(ready, before);
    return cell;
  }

  private void awaitOther(String name, String before) throws IOException {
    long end = System.nanoTime() + Duration.ofSeconds(10).toNanos();
    while (client.readText(name).equals(before)) {
      if (System.nanoTime() > end) {
        throw new IOException("the program must change " + name + ", which is still " + before);
      }
    }
  }

  CrossComClient client() {
    return client;
  }

  /**
   * Changes the default limits for a simulated robot: it is in AUT, and a busy computer must not
   * stop it. A real robot keeps the defaults, including T1.
   */
  void limit(Safety.Builder safety) {
    if (mock != null) {
      safety
          .modes(OperatingMode.AUT)
          .path(100, 20, 50)
          .axes(30, 10, 15)
          .maxFeedbackAge(Duration.ofSeconds(2))
          .maxStall(Duration.ofSeconds(2))
          .watchdog(Duration.ofSeconds(5));
    }
  }

  @Override
  public void close() throws IOException {
    client.close();
    if (mock != null) {
      mock.close();
    }
  }
}
