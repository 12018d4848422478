package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLRealArray;

/** Reads a whole array in one access, an array element by element, and a single element. */
public final class ReadArrays {
  private ReadArrays() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if reading failed
   */
  public static void main(String[] args) throws IOException {
    try (ExampleConnection connection = ExampleConnection.of(args)) {
      read(connection.client());
    }
  }

  private static void read(CrossComClient client) throws IOException {
    double[] lower = client.readRealArray("$SOFTN_END[]"); // empty brackets: the whole array
    System.out.println("lower limits of A1 to A6 in degrees: " + first(lower, 6));

    boolean[] inputs = client.readBoolArray("$IN[]"); // 4096 elements, still one access
    System.out.println("inputs that are on: " + on(inputs));

    // An array that the controller cannot send whole is read element by element, given its length.
    // With one access per element, it is useful to see the progress.
    KRLRealArray torques = new KRLRealArray("$TORQUE_AXIS_ACT[]", 6);
    client.readVariable(
        torques, (done, total) -> System.out.println("torque " + done + " of " + total));
    System.out.println(
        "torques of A1 to A6 in Nm: "
            + first(Objects.requireNonNull(torques.getValue(), "it has been read"), 6));

    double upper = client.readReal("$SOFTP_END[1]"); // KRL indices start at 1
    System.out.println("upper limit of A1 in degrees: " + upper);
  }

  /** Returns indices as in KRL, starting at 1. */
  private static List<Integer> on(boolean[] values) {
    List<Integer> numbers = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      if (values[i]) {
        numbers.add(i + 1);
      }
    }
    return numbers;
  }

  private static String first(double[] values, int count) {
    return Arrays.toString(Arrays.copyOf(values, count)); // the arrays have 12, for external axes
  }
}
