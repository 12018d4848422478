package no.hials.crosscom.control.input;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.jline.terminal.Attributes;
import org.jline.terminal.Attributes.LocalFlag;
import org.jline.terminal.impl.LineDisciplineTerminal;
import org.jline.utils.NonBlockingReader;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The effect of keys, on a terminal within this process. It is opened once, since opening and
 * closing wait for the release of keys.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(60)
class KeyboardInputTest {
  private static final long HOLD = KeyboardInput.HOLD * 1_000_000L;

  private final AtomicLong clock = new AtomicLong(7);
  private LineDisciplineTerminal terminal;
  private KeyboardInput keyboard;

  @BeforeAll
  void open() throws IOException {
    terminal =
        new LineDisciplineTerminal(
            "test", "xterm", new ByteArrayOutputStream(), StandardCharsets.UTF_8);
    keyboard = KeyboardInput.on(terminal, clock::get);
  }

  @AfterEach
  void release() throws IOException {
    if (keyboard.isEnded()) {
      keyboard.close();
      open();
    }
    press("+".repeat(10) + " ");
    await(input -> !input.deadMan() && keyboard.scale() == 1);
    clock.set(7);
  }

  @AfterAll
  void close() throws IOException {
    keyboard.close();
  }

  private void press(String keys) throws IOException {
    terminal.processInputBytes(keys.getBytes(StandardCharsets.UTF_8));
  }

  private Input await(Predicate<Input> condition) throws IOException {
    Input input = keyboard.read();
    while (!condition.test(input)) {
      Thread.onSpinWait();
      input = keyboard.read();
    }
    return input;
  }

  @ParameterizedTest
  @CsvSource({
    "w, 0, 1",
    "s, 0, -1",
    "a, 1, 1",
    "d, 1, -1",
    "r, 2, 1",
    "f, 2, -1",
    "u, 3, 1",
    "j, 3, -1",
    "i, 4, 1",
    "k, 4, -1",
    "o, 5, 1",
    "L, 5, -1",
    "'\u001b[A', 0, 1",
    "'\u001bOB', 0, -1",
    "'\u001b[D', 1, 1",
    "'\u001b[C', 1, -1",
    "'\u001b[5~', 2, 1",
    "'\u001b[6~', 2, -1"
  })
  void aKeyDeflectsOneAxis(String key, int axis, double deflection) throws IOException {
    assertThat(keyboard.read().deadMan()).isFalse();

    press(key);

    Input input = await(Input::deadMan);
    for (int i = 0; i < 6; i++) {
      assertThat(input.axis(i)).isEqualTo(i == axis ? deflection : 0);
    }
    assertThat(input.nanoTime()).isEqualTo(7);
  }

  @Test
  void aKeyThatIsNotRepeatedIsLetGo() throws IOException {
    press("w");
    await(Input::deadMan);

    clock.addAndGet(HOLD);
    assertThat(keyboard.read().axis(0)).isEqualTo(1);
    clock.addAndGet(1);
    Input input = keyboard.read();
    assertThat(input.deadMan()).isFalse();
    assertThat(input.axis(0)).isZero();

    press("w");
    assertThat(await(Input::deadMan).nanoTime()).isEqualTo(7 + HOLD + 1);
  }

  @Test
  void onlyTheLastKeyCounts() throws IOException {
    press("wr");

    Input input = await(each -> each.axis(2) == 1);

    assertThat(input.axis(0)).isZero();
  }

  @Test
  void spaceLetsGoAtOnce() throws IOException {
    press("w");
    await(Input::deadMan);

    press(" ");

    assertThat(await(each -> !each.deadMan()).axis(0)).isZero();
    assertThat(keyboard.isEnded()).isFalse();
  }

  @Test
  void plusAndMinusChangeTheDeflectionWithinItsRange() throws IOException {
    press("-----w");
    await(each -> each.axis(0) == 0.5);
    assertThat(keyboard.scale()).isEqualTo(0.5);

    press("---------d");
    await(each -> each.axis(1) == -0.1);
    assertThat(keyboard.scale()).isEqualTo(0.1);

    press("++++++++++++++++s");
    await(each -> each.axis(0) == -1);
  }

  @Test
  void afterTheEndNoKeyMovesAnything() throws IOException {
    press("w");
    await(Input::deadMan);

    press("qwz-d");

    await(each -> keyboard.scale() == 0.9);
    assertThat(keyboard.isEnded()).isTrue();
    assertThat(keyboard.read().deadMan()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "xZ5ä\t\r",
        "\u001b[H\u001b[15~\u001b[1;5A\u001bOP",
        "\u001b[?0u\u001b[?62;22c\u001b[?2026;2$y",
        "\u001bP>|wsadrf\u001b\\",
        "\u001b]11;rgb:ffff/aaaa\u0007",
        "\u001bw"
      })
  void otherKeysAndWhatTheTerminalSaysDoNothing(String sent) throws IOException {
    press(sent + "-");

    await(each -> keyboard.scale() == 0.9);
    assertThat(keyboard.read().deadMan()).isFalse();
    assertThat(keyboard.isEnded()).isFalse();
  }

  @Test
  void aTerminalThatIsClosedAsTheJvmEndsMovesNothing() throws IOException {
    press("w");
    await(Input::deadMan);

    terminal.close();

    await(input -> !input.deadMan());
    assertThat(keyboard.isEnded()).isTrue();
  }

  @Test
  void keysThatNobodyReadAreNotLeftToTheShell() throws Exception {
    AtomicInteger left = new AtomicInteger(-1);
    LineDisciplineTerminal shared =
        new LineDisciplineTerminal(
            "test", "xterm", new ByteArrayOutputStream(), StandardCharsets.UTF_8) {
          @Override
          protected void doClose() throws IOException {
            left.set(reader().read(1)); // as the shell would
            super.doClose();
          }
        };
    AtomicBoolean failed = new AtomicBoolean();
    KeyboardInput failing =
        KeyboardInput.on(
            shared,
            () -> {
              failed.set(true);
              throw new IllegalStateException("no more time");
            });
    shared.processInputBytes(new byte[] {'w'}); // ends the thread that reads
    while (!failed.get()) {
      Thread.onSpinWait();
    }

    shared.processInputBytes("rm -r *\n".getBytes(StandardCharsets.UTF_8));
    failing.close();

    assertThat(left).hasValue(NonBlockingReader.READ_EXPIRED);
  }

  @Test
  void keysComeAtOnceAndAreNotShownAndCtrlCStaysASignal() {
    Attributes attributes = terminal.getAttributes();

    assertThat(attributes.getLocalFlag(LocalFlag.ICANON)).isFalse();
    assertThat(attributes.getLocalFlag(LocalFlag.ECHO)).isFalse();
    assertThat(attributes.getLocalFlag(LocalFlag.ISIG)).isTrue();
  }
}
