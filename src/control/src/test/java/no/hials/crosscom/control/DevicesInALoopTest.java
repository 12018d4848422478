package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.input.CsvReplay;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.control.input.Replays;
import no.hials.crosscom.control.input.UdpJsonInput;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Moves the simulated robot with input devices. */
@Timeout(120)
class DevicesInALoopTest extends ControlTest {
  private static final double SPEED = 20; // mm/s

  private static LoopConfig with(InputDevice device, Consumer<LoopConfig.Builder> changes) {
    return config(
        cfg -> {
          cfg.input(device);
          changes.accept(cfg);
        });
  }

  private static Law alongX() {
    return Law.cartesianVelocity(s -> Twist.linear(SPEED * s.input().axis(0), 0, 0));
  }

  /** Returns a line every 50 ms with a deflection, between two times. */
  private static String lines(double from, double to, String values) {
    StringBuilder lines = new StringBuilder();
    for (int i = (int) Math.round(from * 20); i < Math.round(to * 20); i++) {
      lines.append(String.format(Locale.ROOT, "%.2f,%s%n", i / 20.0, values));
    }
    return lines.toString();
  }

  private List<Trace.Cycle> replay(String csv, double seconds) throws Exception {
    run("actuator.src");
    CsvReplay device = Replays.of("time,axis1,dead_man\n" + csv, time::nanoTime);
    LoopConfig config =
        with(device, cfg -> cfg.duration(java.time.Duration.ofMillis((long) (seconds * 1000))));
    try (ControlLoop loop = start(config, alongX())) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      return loop.trace().cycles();
    }
  }

  private static double xAt(List<Trace.Cycle> cycles, double time) {
    return cycles.stream()
        .filter(cycle -> cycle.time() >= time)
        .findFirst()
        .orElseThrow()
        .actual()
        .get(0);
  }

  @Test
  void aReplayMovesTheRobotForthAndBack() throws Exception {
    List<Trace.Cycle> cycles =
        replay(lines(0, 1, "1,1") + lines(1, 2, "-1,1") + lines(2, 3, "0,0"), 3);

    double start = xAt(cycles, 0);
    // it needs some cycles to start, and as many to turn back
    assertThat(xAt(cycles, 1) - start).isBetween(0.6 * SPEED, 1.05 * SPEED);
    assertThat(xAt(cycles, 2.9)).isCloseTo(start, within(0.3 * SPEED));
    assertThat(xAt(cycles, 2.9)).isEqualTo(xAt(cycles, 2.5));
  }

  @Test
  void theRobotStandsInAGapOfAReplayAndGoesOnAfterIt() throws Exception {
    List<Trace.Cycle> cycles = replay(lines(0, 1, "1,1") + lines(2, 3, "1,1"), 3.8);

    assertThat(xAt(cycles, 1.9)).isEqualTo(xAt(cycles, 1.6));
    assertThat(xAt(cycles, 2.9)).isGreaterThan(xAt(cycles, 1.9) + 0.7 * SPEED);
    assertThat(xAt(cycles, 3.7)).isEqualTo(xAt(cycles, 3.6));
  }

  @Test
  void theRobotStandsWhileTheReplayDoesNotHoldTheDeadMan() throws Exception {
    List<Trace.Cycle> cycles = replay(lines(0, 1, "1,0"), 1);

    assertThat(cycles).isNotEmpty().noneMatch(Trace.Cycle::moving);
    assertThat(xAt(cycles, 0.9)).isEqualTo(xAt(cycles, 0));
  }

  @Test
  void aDeviceThatFailsInTheMiddleStopsTheRobot() throws Exception {
    run("actuator.src");
    CsvReplay replay = Replays.of("time,axis1,dead_man\n" + lines(0, 5, "1,1"), time::nanoTime);
    InputDevice device =
        () -> {
          if (time.nanoTime() > 1_000_000_000) {
            throw new IOException("the gamepad was unplugged");
          }
          return replay.read();
        };
    Frame start = position();

    StopReason reason = runLoop(with(device, cfg -> {}), alongX());

    assertThat(reason.kind()).isEqualTo(StopKind.INPUT);
    assertThat(reason.message()).contains("the gamepad was unplugged");
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    assertThat(position().x()).isBetween(start.x() + 0.5 * SPEED, start.x() + 1.5 * SPEED);
  }

  private static void send(int port, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
    }
  }

  /** Returns the input of a device with its age in simulated time. */
  private InputDevice inSimulatedTime(InputDevice device) {
    return new InputDevice() {
      private Input last = Input.NONE;
      private long seen;

      @Override
      public Input read() throws IOException {
        Input input = device.read();
        seen = input.nanoTime() == last.nanoTime() ? seen : time.nanoTime();
        last = input;
        return new Input(input.axes(), input.buttons(), input.deadMan(), seen);
      }
    };
  }

  private static void sendUntil(UdpJsonInput device, ControlLoop loop, double x)
      throws IOException {
    while (loop.trace().last().map(cycle -> cycle.actual().get(0)).orElse(-1e9) < x) {
      assertThat(loop.stopReason()).isEmpty();
      send(device.port(), "{\"axes\": [1], \"deadMan\": true}");
    }
  }

  @Test
  void datagramsMoveTheRobotAndItStandsWhenTheyStop() throws Exception {
    run("actuator.src");
    Frame start = position();
    try (UdpJsonInput device = UdpJsonInput.listen(0);
        ControlLoop loop = start(with(inSimulatedTime(device), cfg -> {}), alongX())) {
      sendUntil(device, loop, start.x() + 5);
      // invalid input does not keep it moving
      while (device.refusedDatagrams() == 0 || loop.status() != ControlLoop.Status.HOLDING) {
        send(device.port(), "{\"axes\": [1], \"deadMan\": tru");
      }
      sendUntil(device, loop, start.x() + 10);
      assertThat(device.refusedDatagrams()).isPositive();
    }
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
  }

  @Test
  void aReceiverThatIsClosedInTheMiddleMovesNothingAnyMore() throws Exception {
    run("actuator.src");
    Frame start = position();
    UdpJsonInput device = UdpJsonInput.listen(0);
    try (ControlLoop loop = start(with(inSimulatedTime(device), cfg -> {}), alongX())) {
      sendUntil(device, loop, start.x() + 2);

      device.close();

      while (loop.status() != ControlLoop.Status.HOLDING) {
        Thread.onSpinWait();
      }
      assertThat(loop.stopReason()).isEmpty();
    }
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
  }
}
