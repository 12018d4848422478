package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

class ExitCodeTest {
  @KukaController private MockServer server;

  @Test
  void eachExceptionOfTheClientHasAnExitCode() {
    assertThat(ExitCode.OF_EXCEPTIONS)
        .containsKeys(CrossComException.class.getPermittedSubclasses());
  }

  @Test
  void anUnreadableAnswerToAWriteIsNotWrongUsageButAValueThatIsNotSentIs() throws Exception {
    try (CrossComClient client = new CrossComClient(server.host(), server.port())) {
      server.enqueue(Fault.answer("??", Tail.SUCCESS));
      KRLInt number = new KRLInt("MYINT");
      number.setValue(3);

      assertThat(ExitCode.of(failure(() -> client.writeVariable(number)))).isEqualTo(ExitCode.LOST);
      assertThat(ExitCode.of(failure(() -> client.writeText("MYFRAME", "{" + " ".repeat(255)))))
          .isEqualTo(ExitCode.USAGE);
    }
  }

  @Test
  void aProcessThatASignalHasEndedIsStoppedAndOtherCodesAreErrors() {
    assertThat(ExitCode.of(74)).isEqualTo(ExitCode.OUTPUT_LOST);
    assertThat(ExitCode.of(143)).isEqualTo(ExitCode.STOPPED);
    assertThat(ExitCode.of(99)).isEqualTo(ExitCode.INTERNAL_ERROR);
  }

  private static CrossComValueException failure(ThrowingCallable access) {
    return catchThrowableOfType(CrossComValueException.class, access);
  }
}
