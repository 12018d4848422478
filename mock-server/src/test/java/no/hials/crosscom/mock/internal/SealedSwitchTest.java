package no.hials.crosscom.mock.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import no.hials.crosscom.mock.Fault;
import org.junit.jupiter.api.Test;

class SealedSwitchTest {

  @Test
  void reportsAClassWithoutACase() {
    SealedSwitch<Fault, String> incomplete =
        SealedSwitch.<Fault, String>over(Fault.class).on(Fault.Simple.class, Fault.Simple::name);
    assertThatIllegalStateException()
        .isThrownBy(incomplete::complete)
        .withMessageStartingWith("no case for no.hials.crosscom.mock.Fault$");
  }

  @Test
  void aLaterCaseReplacesThatOfAFamily() {
    SealedSwitch<Fault, String> complete =
        SealedSwitch.<Fault, String>over(Fault.class)
            .on(Fault.class, fault -> "other")
            .on(Fault.Truncate.class, fault -> "truncate")
            .complete();
    assertThat(complete.apply(Fault.truncate(1))).isEqualTo("truncate");
    assertThat(complete.apply(Fault.none())).isEqualTo("other");
  }
}
