package no.hials.crosscom.control.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Input values and devices. */
class InputTest {
  private static final long MILLI = 1_000_000;

  private static Input of(double... axes) {
    List<Double> list = java.util.Arrays.stream(axes).boxed().toList();
    return new Input(list, List.of(true, false), true, 7);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0.1, 0", "-0.1, 0", "0.55, 0.25", "-0.55, -0.25", "1, 0.5", "-1, -0.5"})
  void aShapedAxisRisesFromTheEdgeOfTheDeadZoneToTheScale(double raw, double shaped)
      throws IOException {
    InputDevice device = () -> of(raw);

    Input input = device.shaped(0.1, 0.5).read();

    assertThat(input.axis(0)).isCloseTo(shaped, within(1e-12));
    assertThat(input.buttons()).containsExactly(true, false);
    assertThat(input.deadMan()).isTrue();
    assertThat(input.nanoTime()).isEqualTo(7);
  }

  @Test
  void aShapeOutOfRangeIsRefused() {
    InputDevice device = () -> Input.NONE;
    assertThatIllegalArgumentException().isThrownBy(() -> device.shaped(1, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> device.shaped(0.1, 1.1));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.01, -1.01, Double.NaN})
  void anAxisOutOfRangeIsRefused(double axis) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> of(axis))
        .withMessage("an axis must be -1 to 1, is " + axis);
  }

  @Test
  void whatADeviceHasNotIsAtRest() {
    assertThat(of(0.5).axis(1)).isZero();
    assertThat(of(0.5).button(2)).isFalse();
    assertThat(Input.NONE.deadMan()).isFalse();
  }

  @Test
  void aReplayGivesEachLineFromItsTimeOn() throws IOException {
    AtomicLong clock = new AtomicLong(1000);
    CsvReplay replay =
        CsvReplay.load(
            new StringReader(
                """
                # recorded
                time,axis2,button1,dead_man

                0.1,0.5,0,1
                0.2,-1,1,0
                """),
            "test",
            clock::get);

    assertThat(replay.read()).isEqualTo(Input.NONE);
    clock.set(1000 + 150 * MILLI);
    assertThat(replay.read())
        .isEqualTo(new Input(List.of(0.0, 0.5), List.of(false), true, 1000 + 100 * MILLI));
    assertThat(replay.isOver()).isFalse();
    clock.set(1000 + 900 * MILLI);
    assertThat(replay.read())
        .isEqualTo(new Input(List.of(0.0, -1.0), List.of(true), false, 1000 + 200 * MILLI));
    assertThat(replay.isOver()).isTrue();
  }

  @Test
  void aByteOrderMarkIsPassedOver() throws IOException {
    CsvReplay replay = Replays.of("\uFEFFtime,dead_man\n0,1\n", () -> 5);

    assertThat(replay.read()).isEqualTo(new Input(List.of(), List.of(), true, 5));
  }

  @Test
  void anApostropheBeforeACellIsPassedOver() throws IOException {
    CsvReplay replay = Replays.of("time,axis1,dead_man\n0,'-0.5,1\n", () -> 5);

    assertThat(replay.read()).isEqualTo(new Input(List.of(-0.5), List.of(), true, 5));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "time,axis1|0,2; t, line 2: an axis must be -1 to 1, is 2.0",
        "time,axis1|1,0|1,0; t, line 3: time must be more than before, 0 or more and less than"
            + " 1000000 s, is 1.0",
        "time,axis1|1; t, line 2: expected 2 values, found 1",
        "time,dead_man|1,yes; t, line 2: dead_man must be 0 or 1, is 'yes'",
        "time,x|1,1; t, line 1: a column must be time, axis1 to axis99, button1 to button99 or"
            + " dead_man, is 'x'",
        "axis1|1; t, line 1: there must be a column time and no column twice, are [axis1]",
        "time; t: expected a line of names and a line of values, found none"
      })
  void aWrongLineOfAReplayIsNamed(String lines, String message) {
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> CsvReplay.load(new StringReader(lines.replace('|', '\n')), "t"))
        .withMessage(message);
  }

  private static void send(int port, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
    }
  }

  private static Input await(UdpJsonInput device, double firstAxis) throws IOException {
    Input input = device.read();
    while (input.axis(0) != firstAxis) {
      Thread.onSpinWait();
      input = device.read();
    }
    return input;
  }

  @Test
  void aDatagramIsTheInputUntilTheNextOne() throws IOException {
    try (UdpJsonInput device = UdpJsonInput.listen(0)) {
      assertThat(device.read()).isEqualTo(Input.NONE);
      long before = System.nanoTime();

      send(
          device.port(),
          """
          {"axes": [0.5, -1, 0], "name": {"a": [1]}, "buttons": [true, false], "deadMan": true}
          """);

      Input input = await(device, 0.5);
      assertThat(input.axes()).containsExactly(0.5, -1.0, 0.0);
      assertThat(input.buttons()).containsExactly(true, false);
      assertThat(input.deadMan()).isTrue();
      assertThat(input.nanoTime() - before).isNotNegative();

      send(device.port(), "{\"axes\": [0.25]}");
      assertThat(await(device, 0.25).deadMan()).isFalse();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "[]",
        "{\"axes\": [2]}",
        "{\"axes\": [NaN]}",
        "{\"axes\": 1}",
        "{\"axes\": [true]}",
        "{\"deadMan\": 1}",
        "{\"deadMan\": true",
        "{\"deadMan\": true} {}",
        "{\"deadMan\": false, \"deadMan\": true}",
        "{\"buttons\": [1]}"
      })
  void aWrongDatagramChangesNothingAndIsCounted(String text) throws IOException {
    try (UdpJsonInput device = UdpJsonInput.listen(0)) {
      send(device.port(), text);
      while (device.refusedDatagrams() == 0) {
        Thread.onSpinWait();
      }
      assertThat(device.read()).isEqualTo(Input.NONE);

      send(device.port(), "{\"axes\": [1]}");
      assertThat(await(device, 1).deadMan()).isFalse();
      assertThat(device.refusedDatagrams()).isEqualTo(1);
    }
  }
}
