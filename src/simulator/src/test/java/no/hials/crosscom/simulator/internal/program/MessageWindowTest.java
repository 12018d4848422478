package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import no.hials.crosscom.protocol.code.Interpreter;
import org.junit.jupiter.api.Test;

class MessageWindowTest {
  private final MessageWindow window = new MessageWindow((message, handle) -> {});

  private int answeredDialogue(Interpreter owner) {
    int handle =
        window.show(
            owner,
            new ProgramMessage(
                ProgramMessage.Type.DIALOGUE,
                5,
                "Cell",
                "go on?",
                List.of("no", "yes"),
                true,
                true));
    assertThat(window.answer(window.dialogue().orElseThrow().getKey(), 2)).isTrue();
    return handle;
  }

  @Test
  void keepsTheAnswerForAProgramWhenTheOtherOneIsReset() {
    int ofRobot = answeredDialogue(Interpreter.ROBOT);
    int ofSubmit = answeredDialogue(Interpreter.SUBMIT);

    window.forget(Interpreter.SUBMIT);

    assertThat(window.takeAnswer(ofRobot)).isEqualTo(2);
    assertThat(window.takeAnswer(ofSubmit)).isZero();
  }
}
