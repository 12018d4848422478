package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.Arrays;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.protocol.value.E6Axis;
import no.hials.crosscom.protocol.value.Load;

/** Reads variables of every type. */
public final class ReadVariables {
  private ReadVariables() {}

  private enum Mode {
    T1,
    T2,
    AUT,
    EX
  }

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
    System.out.println("program override: " + client.readInt("$OV_PRO") + " %");
    System.out.println("operating mode: " + client.readEnum("$MODE_OP", Mode.class));
    System.out.println("input 1025: " + client.readBool("$IN[1025]"));
    System.out.println("model: " + client.readString("$MODEL_NAME[]"));

    E6Axis axes = client.read("$AXIS_ACT", E6Axis.class);
    System.out.println("A1 to A6: " + Arrays.toString(axes.axis().toArray()));

    double[] torques = client.readRealArray("$TORQUE_AXIS_ACT[]");
    System.out.println("torques: " + Arrays.toString(torques));

    Load load = client.read("$LOAD", Load.class);
    System.out.println("load: " + load.m() + " kg");
    System.out.println("any type: " + client.readValue("$LOAD"));
  }
}
