package no.hials.crosscom.cell.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;
import org.junit.jupiter.api.Test;

class OutputExceptionTest {
  @Test
  void saysWhyAndNotTheNameOfTheFileAgain() {
    assertThat(new OutputException("a.png", new AccessDeniedException("a.png")))
        .hasMessage("could not write a.png: access is denied");
  }

  @Test
  void aFileThatCannotBeCreatedIsNotCalledMissing() {
    assertThat(new OutputException("a.png", new NoSuchFileException("a.png")))
        .hasMessage("could not write a.png: no such folder, or it does not take this file");
  }
}
