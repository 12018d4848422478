package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.ProgramState;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** Has a simulated robot that runs the programs of {@code krl}, and a client. */
abstract class ControlTest {
  static final Path KRL = Path.of("..", "..", "krl");
  static final Duration PERIOD = Duration.ofMillis(12);
  static final Duration LIMIT = Duration.ofMinutes(1);

  /** Not with A5 at 0, where a straight path would lead through a singularity. */
  static final Axes START = Axes.of(0, -90, 90, 0, 45, 0);

  MockServer server;
  Controller controller;
  CrossComClient client;
  SimulatedTime time;

  @BeforeEach
  void startRobot() throws Exception {
    server = MockServer.start(this::configure);
    controller = server.controller();
    controller.load(KRL.resolve("config.dat"));
    controller.setMode(no.hials.crosscom.simulator.OperatingMode.AUT);
    controller.place(START);
    client = new CrossComClient(ClientConfig.create(server.host(), cfg -> cfg.port(server.port())));
    time = new SimulatedTime(controller);
    runSubmit();
  }

  void configure(MockServerConfig.Builder cfg) {
    cfg.clock(SimulationClock.stepped());
  }

  @AfterEach
  void stopRobot() throws IOException {
    client.close();
    server.close();
  }

  private void runSubmit() throws Exception {
    controller.submit().select(controller.load(KRL.resolve("jov_sps.sub")));
    controller.submit().start();
    controller.step(Duration.ofMillis(24));
    assertThat(controller.submit().state()).isEqualTo(ProgramState.ACTIVE);
  }

  /** Runs a program of the robot interpreter, until it is in its loop. */
  void run(String file) throws Exception {
    controller.robot().select(controller.load(KRL.resolve(file)));
    controller.robot().start();
    controller.step(Duration.ofMillis(240));
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
  }

  static Safety.Builder inAutomatic(Safety.Builder safety) {
    return safety.modes(OperatingMode.AUT);
  }

  static LoopConfig config(Consumer<LoopConfig.Builder> changes) {
    return LoopConfig.create(
        cfg -> {
          cfg.period(PERIOD).noInput().safety(ControlTest::inAutomatic);
          changes.accept(cfg);
        });
  }

  ControlLoop start(LoopConfig config, Law law) throws ControlRefusedException {
    return ControlLoop.start(client, config, law, time);
  }

  /** Runs a loop to its end. */
  StopReason runLoop(LoopConfig config, Law law) throws Exception {
    try (ControlLoop loop = start(config, law)) {
      return loop.await();
    }
  }

  Frame position() throws IOException {
    Channel channel = new Channel(client);
    channel.read(channel.position);
    return channel.frame();
  }
}
