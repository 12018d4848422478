package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/**
 * The fixture of the tests: a simulated robot that runs the programs of {@code krl}, and a client.
 */
abstract class ControlTest {
  static final Path KRL = Path.of("..", "..", "krl");
  static final Duration PERIOD = Duration.ofMillis(12);
  static final Duration LIMIT = Duration.ofMinutes(1);

  /** With A5 not at 0, where a straight path would pass a singularity. */
  static final Axis START = Axis.of(0, -90, 90, 0, 45, 0);

  static final Axis TURNING = Axis.ZERO.with(0, 10); // degrees/s

  MockServer server;
  Controller controller;
  CrossComClient client;
  SimulatedTime time;

  @BeforeEach
  void startRobot() throws Exception {
    server = MockServer.start(this::configure);
    controller = server.controller();
    controller.load(KRL.resolve("config.dat"));
    controller.setMode(OperatingMode.AUT);
    controller.place(START);
    client = new CrossComClient(ClientConfig.create(server.host(), cfg -> cfg.port(server.port())));
    time = new SimulatedTime(controller);
    runSubmit();
  }

  void configure(MockServerConfig.Builder cfg) {
    cfg.clock(SimulationClock.stepped()).bco(false);
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

  /** Starts a program of the robot interpreter and runs it up to its loop. */
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

  static LoopConfig safe(Consumer<Safety.Builder> changes) {
    return config(cfg -> cfg.safety(s -> changes.accept(inAutomatic(s))));
  }

  /** An event during a loop. */
  interface Event {
    void happen() throws Exception;
  }

  /** Returns a law that turns A1; after one second the event happens in each period. */
  static Law afterOneSecond(Event event) {
    return Law.jointVelocity(
        s -> {
          if (s.time() > 1) {
            event.happen();
          }
          return TURNING;
        });
  }

  /** Runs a program and a loop that stops at a limit. */
  StopReason runToStop(String program, Law law) throws Exception {
    return runToStop(program, config(cfg -> {}), law);
  }

  /** Runs a program and a loop that stops at a limit. */
  StopReason runToStop(String program, LoopConfig config, Law law) throws Exception {
    run(program);
    return runToStop(config, law);
  }

  /** Runs a loop that stops at a limit, and checks that the robot stands still. */
  StopReason runToStop(LoopConfig config, Law law) throws Exception {
    StopReason reason;
    try (ControlLoop loop = start(config, law)) {
      reason = loop.await();
      assertThat(loop.toldToStand()).isTrue();
      assertThat(loop.status()).isEqualTo(ControlLoop.Status.STOPPED);
      assertThat(loop.stopReason()).contains(reason);
    }
    assertThat(reason.isPlanned()).isFalse();
    assertStandsForGood();
    return reason;
  }

  static void assertReason(StopReason reason, StopReason.StopKind kind, String message) {
    assertThat(reason.message()).isEqualTo(message);
    assertThat(reason.kind()).isEqualTo(kind);
  }

  /** Checks that the robot stops, stays there, and that nothing is written any more. */
  void assertStandsForGood() {
    long requests = server.requestCount();
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    Axis stoodAt = controller.axes();
    controller.step(Duration.ofSeconds(2));
    assertThat(controller.axes().largestDifference(stoodAt)).isLessThan(1e-9);
    assertThat(server.requestCount()).isEqualTo(requests);
  }

  List<String> writesTo(String name) {
    return server.requests().stream()
        .map(RecordedRequest::request)
        .filter(r -> r instanceof WriteRequest write && write.name().equals(name))
        .map(r -> ((WriteRequest) r).value())
        .toList();
  }

  Frame position() throws IOException {
    Channel channel = new Channel(client);
    channel.read(channel.position);
    return channel.frame();
  }
}
