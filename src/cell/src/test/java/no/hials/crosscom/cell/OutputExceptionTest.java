package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.AccessDeniedException;
import org.junit.jupiter.api.Test;

class OutputExceptionTest {
  @Test
  void saysWhyAndNotTheNameOfTheFileAgain() {
    assertThat(new OutputException("a.png", new AccessDeniedException("a.png")))
        .hasMessage("could not write a.png: access is denied");
  }
}
