package no.hials.crosscom.bench;

import java.util.concurrent.TimeUnit;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlValue;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures parsing and printing an E6AXIS, without any exchange. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class TextBenchmark {
  private final AnswerFrame answer = new AnswerFrame();
  private final KrlScanner scanner = new KrlScanner();
  private final double[] numbers = new double[12];
  private final KRLE6Axis axes = new KRLE6Axis("$AXIS_ACT");
  private final KRLE6Axis read = new KRLE6Axis("$AXIS_ACT");
  private final KrlValue tree = KrlValue.parse(Operation.AXES_READ);

  /** Creates the benchmark; {@link #open} sets it up. */
  public TextBenchmark() {}

  /**
   * Creates the answer and the variables.
   *
   * @throws MalformedFrameException never
   */
  @Setup
  public void open() throws MalformedFrameException {
    byte[] frame = Operation.READ_E6AXIS.answer();
    answer.wrap(frame, frame.length);
    answer.openValue();
    answer.scan(scanner);
    VariableAccess.get().scan(axes, scanner, false);
  }

  /**
   * Scans an answer into an array.
   *
   * @return the array
   */
  @Benchmark
  public double[] scanIntoArray() {
    answer.scan(scanner);
    scanner.openStruct();
    int i = 0;
    while (scanner.nextField()) {
      numbers[i] = scanner.readReal();
      i++;
    }
    scanner.expectEnd();
    return numbers;
  }

  /**
   * Scans an answer into a typed variable, as the client does.
   *
   * @return the variable
   */
  @Benchmark
  public KRLE6Axis scanIntoE6Axis() {
    answer.scan(scanner);
    VariableAccess.get().scan(read, scanner, false);
    return read;
  }

  /**
   * Parses a text into a tree of values.
   *
   * @return the tree
   */
  @Benchmark
  public KrlValue parseTree() {
    return KrlValue.parse(Operation.AXES_READ);
  }

  /**
   * Prints a tree like a KR C4.
   *
   * @return the text
   */
  @Benchmark
  public String printTreeAsKrc4() {
    return tree.print();
  }

  /**
   * Prints a tree with the fewest digits.
   *
   * @return the text
   */
  @Benchmark
  public String printTreeShortest() {
    return tree.printShort();
  }

  /**
   * Prints a typed variable, as for a write.
   *
   * @return the text
   */
  @Benchmark
  public String printE6Axis() {
    return axes.getStringValue();
  }
}
