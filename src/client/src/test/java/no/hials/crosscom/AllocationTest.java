package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Counts the heap that the calling thread takes. The server runs in other threads, which do not
 * count.
 */
class AllocationTest extends RobotTest {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private static final int ROUNDS = 1000;

  private final KRLInt number = new KRLInt("MYINT");
  private final KRLReal real = new KRLReal("MYREAL");
  private final KRLE6Axis axes = new KRLE6Axis("MYAXES");

  /** Some accesses of one kind. */
  @FunctionalInterface
  private interface Access {
    void run(int round) throws IOException;
  }

  @BeforeEach
  void declareTheAxes() {
    robot.variables().declare("MYAXES", "E6AXIS", "{A1 1.5,A2 -90.12346,A3 91.234566,E1 1250.5}");
  }

  /** Returns the bytes that an access takes on the average. */
  private static long allocated(Access access) throws IOException {
    run(access);
    long before = THREADS.getThreadAllocatedBytes(Thread.currentThread().getId());
    run(access);
    long bytes = THREADS.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
    // the sizes of objects are multiples of 8; a class that is loaded late, or a wait for the lock,
    // is less for each access
    return bytes / ROUNDS / 8 * 8;
  }

  private static void run(Access access) throws IOException {
    for (int i = 0; i < ROUNDS; i++) {
      access.run(i);
    }
  }

  @Test
  void theMeasurementSeesATextThatIsRead() throws IOException {
    assertThat(allocated(i -> client.readText("MYINT"))).isPositive();
  }

  @Test
  void readingAnIntCreatesNoObjects() throws IOException {
    assertThat(allocated(i -> client.readVariable(number))).isZero();
  }

  @Test
  void readingARealCreatesNoObjects() throws IOException {
    assertThat(allocated(i -> client.readVariable(real))).isZero();
  }

  @Test
  void readingAnE6AxisCreatesNoObjects() throws IOException {
    assertThat(allocated(i -> client.readVariable(axes))).isZero();
  }

  @Test
  void readingAnIntCreatesNoObjectsWhileAnotherClientIsWatched() throws Exception {
    try (CrossComClient other = client(cfg -> {});
        Watch watch = other.watch(Duration.ofMillis(1), sample -> {}, "MYINT")) {
      assertThat(allocated(i -> client.readVariable(number))).isZero();
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void writingAnIntCreatesNoObjects() throws IOException {
    long bytes =
        allocated(
            i -> {
              number.setValue(i);
              client.writeVariable(number);
            });

    assertThat(bytes).isZero();
    assertThat(robot.variables().get("MYINT")).isEqualTo(String.valueOf(ROUNDS - 1));
  }

  @Test
  void writingARealCreatesNoObjects() throws IOException {
    client.readVariable(real);

    assertThat(allocated(i -> client.writeVariable(real))).isZero();
  }

  @Test
  void writingAnE6AxisCreatesNoObjects() throws IOException {
    axes.setA1ToA6(5.123457, -90.12346, 91.234566, 0.005123456, -45.678944, 123.45679);
    axes.setE1(1250.5);

    assertThat(allocated(i -> client.writeVariable(axes))).isZero();
  }

  @Test
  void readingANumberByItsHandleCreatesNoObjects() throws IOException {
    Handle.OfInt ints = client.intHandle("MYINT");
    Handle.OfReal reals = client.realHandle("MYREAL");
    Handle<Boolean> bools = client.handle("MYBOOL", Boolean.class);

    assertThat(allocated(i -> ints.readAsInt())).isZero();
    assertThat(allocated(i -> reals.readAsDouble())).isZero();
    assertThat(allocated(i -> bools.read())).isZero();
  }

  @Test
  void writingANumberByItsHandleCreatesNoObjects() throws IOException {
    Handle.OfInt ints = client.intHandle("MYINT");
    Handle.OfReal reals = client.realHandle("MYREAL");

    assertThat(allocated(ints::write)).isZero();
    assertThat(allocated(i -> reals.write(i / 8.0))).isZero();
  }

  @Test
  void readingAPositionByItsHandleCreatesItsRecordOnly() throws IOException {
    Handle<Axis> axis = client.handle("MYAXES", Axis.class);
    robot.variables().set("MYAXES", "{A4 1,A5 2,A6 3}");
    Handle<E6Pos> position = client.handle("$POS_ACT", E6Pos.class);

    assertThat(allocated(i -> axis.read())).isEqualTo(bytes(6 * Double.BYTES));
    assertThat(allocated(i -> position.read()))
        .isEqualTo(bytes(12 * Double.BYTES + 2 * Integer.BYTES));
  }

  @Test
  void writingAPositionByItsHandleCreatesNoObjects() throws IOException {
    Handle<Frame> base = client.handle("$BASE", Frame.class);
    Frame frame = new Frame(5.123457, -90.12346, 91.234566, 0.005123456, -45.678944, 123.45679);

    assertThat(allocated(i -> base.write(frame))).isZero();
  }

  /** Returns the size of an object with fields of that size. */
  private static long bytes(int fields) {
    long header = 12;
    return (header + fields + 7) / 8 * 8;
  }
}
