package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
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
    // the least object has 16 bytes; a class that is loaded late, or a wait for the lock, is less
    return (THREADS.getThreadAllocatedBytes(Thread.currentThread().getId()) - before) / ROUNDS;
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
}
