package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import no.hials.crosscom.cell.Moment;
import org.junit.jupiter.api.Test;

/** When robots may be used. */
class LeaseTest {
  private static final Duration HOUR = Duration.ofHours(1);
  private static final Moment NOW = Moment.now();

  private final Lease lease = new Lease(HOUR);

  private static Moment before(Duration nanos, Duration millis) {
    return new Moment(NOW.nanos() - nanos.toNanos(), NOW.millis() - millis.toMillis());
  }

  @Test
  void isNotHeldBeforeTheFirstAnswerOfTheBroker() {
    assertThat(lease.isHeld()).isFalse();
    lease.renew(NOW);
    assertThat(lease.isHeld()).isTrue();
  }

  @Test
  void anAnswerToAnOldRequestDoesNotRenewIt() {
    lease.renew(before(HOUR, HOUR));
    assertThat(lease.isHeld()).isFalse();
  }

  @Test
  void anAnswerThatComesLateDoesNotShortenIt() {
    lease.renew(NOW);
    lease.renew(before(HOUR, HOUR));
    assertThat(lease.isHeld()).isTrue();
  }

  @Test
  void endsIfOneOfTheClocksSaysSo() {
    lease.renew(before(Duration.ZERO, HOUR));
    assertThat(lease.isHeld()).isFalse();
    Lease other = new Lease(HOUR);
    other.renew(before(HOUR, Duration.ZERO));
    assertThat(other.isHeld()).isFalse();
  }

  @Test
  void aClockThatIsSetBackDoesNotExtendIt() {
    lease.renew(before(HOUR, HOUR.negated()));
    assertThat(lease.isHeld()).isFalse();
  }

  @Test
  void isNeverHeldAfterItsEnd() {
    lease.renew(NOW);
    lease.end();
    lease.renew(Moment.now());
    assertThat(lease.isHeld()).isFalse();
  }
}
