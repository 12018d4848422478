package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;

/** Accesses variables repeatedly. */
class HandleTest extends RobotTest {
  private static final int THREADS = 8;
  private static final int ROUNDS = 200;

  private static Frame all(double value) {
    return new Frame(value, value, value, value, value, value);
  }

  @Test
  void eachThreadSendsItsOwnValuesAndReadsWholeOnes() throws Exception {
    Handle<Frame> frame = client.handle("$BASE", Frame.class);
    Handle.OfInt number = client.intHandle("MYINT");
    frame.write(all(1));
    ExecutorService pool = Executors.newFixedThreadPool(THREADS);
    try {
      List<Future<?>> work = new ArrayList<>();
      for (int t = 1; t <= THREADS; t++) {
        int own = t;
        work.add(
            pool.submit(
                () -> {
                  for (int n = 0; n < ROUNDS; n++) {
                    number.write(own);
                    frame.write(all(own));
                    Frame read = frame.read();
                    assertThat(read).isEqualTo(all(read.x()));
                    assertThat(number.readAsInt()).isBetween(1, THREADS);
                  }
                  return null;
                }));
      }
      for (Future<?> each : work) {
        each.get();
      }
    } finally {
      pool.shutdownNow();
    }
    for (int own = 1; own <= THREADS; own++) {
      String value = String.valueOf(own);
      assertThat(robot.requests())
          .filteredOn(r -> r.isWrite() && r.name().equals("MYINT") && value.equals(r.value()))
          .hasSize(ROUNDS);
    }
  }

  @Test
  void aHandleCanBeUsedAfterAFailure() throws Exception {
    Handle.OfInt number = client.intHandle("MYINT");
    number.write(5);
    assertThat(number.readAsInt()).isEqualTo(5);

    robot.enqueue(Fault.answer("TRUE", Tail.SUCCESS));
    assertThatExceptionOfType(CrossComValueException.class).isThrownBy(number::readAsInt);
    robot.enqueue(Fault.answer("", Tail.SUCCESS));
    assertThatExceptionOfType(CrossComAccessException.class).isThrownBy(number::read);

    assertThat(number.read()).isEqualTo(5);
  }

  @Test
  void aHandleSurvivesAReconnect() throws Exception {
    try (CrossComClient steady = client(cfg -> cfg.reconnect(true))) {
      Handle<Frame> base = steady.handle("$BASE", Frame.class);
      Frame before = base.read();
      robot.enqueue(Fault.closeBefore());

      assertThat(base.read()).isEqualTo(before);
    }
  }

  @Test
  void aHandleHasItsNameAndType() {
    Handle<Frame> base = client.handle("$BASE", Frame.class);

    assertThat(base.name()).isEqualTo("$BASE");
    assertThat(base.type()).isEqualTo(Frame.class);
    assertThat(base).hasToString("Handle{$BASE, Frame}");
  }

  @Test
  void handlesOfOneClientNameAndTypeAreEqualAndFindTheResults() throws Exception {
    ReadResults results = client.read(client.intHandle("MYINT"));

    assertThat(results.get(client.handle("MYINT", Integer.class))).isZero();
    assertThat(results).hasToString("ReadResults{Handle{MYINT, Integer}=0}");
    try (CrossComClient other = client(LONG)) {
      assertThatIllegalArgumentException().isThrownBy(() -> results.get(other.intHandle("MYINT")));
    }
  }
}
