package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Reader;
import java.io.StringWriter;
import java.time.Duration;
import java.util.Map;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;

class StatusLineTest {
  private static final String CLEAR = "\r\u001b[K";

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @KukaController(clock = "stepped")
  private MockServer server;

  private StatusLine line(boolean line) {
    Console console = new Console(out, err, Map.of(), Reader.nullReader(), null);
    return new StatusLine(console, server, () -> line);
  }

  private void pressEmergencyStop(int times) {
    for (int i = 0; i < times; i++) {
      server.controller().emergencyStop(true);
      server.controller().emergencyStop(false);
    }
  }

  @Test
  void showsWhatTheControllerDoesAndReturnsToTheBeginningOfTheLine() {
    try (StatusLine line = line(true)) {
      line.show();

      assertThat(out.toString())
          .isEqualTo(
              "\u001b[?7l0.0 s | T1, no program | 0.0 -90.0 90.0 0.0 0.0 0.0 deg"
                  + " | clients 0, requests 0\u001b[K\u001b[?7h\r");
    }
    assertThat(out.toString()).endsWith("\r" + CLEAR);
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void clearsTheLineBeforeAMessage() {
    try (StatusLine line = line(true)) {
      line.show();
      out.getBuffer().setLength(0);
      pressEmergencyStop(1);
      line.show();

      assertThat(out.toString()).startsWith(CLEAR + "\u001b[?7l");
      assertThat(err.toString().lines()).hasSize(1);
    }
  }

  @Test
  void showsAMessageOnce() {
    try (StatusLine line = line(false)) {
      pressEmergencyStop(1);
      line.show();
      line.show();
      assertThat(err.toString().lines()).hasSize(1);
    }
    assertThat(err.toString().lines()).hasSize(1);
  }

  @Test
  void showsNewMessagesAlsoWhenTheControllerHasForgottenOldOnes() {
    try (StatusLine line = line(false)) {
      pressEmergencyStop(1000);
      line.show();
      err.getBuffer().setLength(0);
      server.controller().step(Duration.ofMillis(12));
      pressEmergencyStop(1);
      line.show();

      assertThat(err.toString().lines()).hasSize(1);
    }
  }

  @Test
  void showsTheLastMessagesAtTheEndAndNothingBehindIt() {
    StatusLine line = line(true);
    line.show();
    pressEmergencyStop(1);

    line.close();
    assertThat(err.toString().lines()).hasSize(1);

    out.getBuffer().setLength(0);
    line.show();
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void writesNothingButMessagesWithoutATerminal() {
    try (StatusLine line = line(false)) {
      line.show();
    }
    assertThat(out.toString()).isEmpty();
    assertThat(err.toString()).isEmpty();
  }
}
