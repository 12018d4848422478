package no.hials.crosscom.lab.bench;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.CrossComException;
import org.junit.jupiter.api.Test;

class BenchTallyTest {
  @Test
  void eachExceptionOfTheClientIsAKindOfFailure() {
    assertThat(BenchTally.KINDS).containsKeys(CrossComException.class.getPermittedSubclasses());
  }
}
