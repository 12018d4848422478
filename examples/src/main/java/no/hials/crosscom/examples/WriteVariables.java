package no.hials.crosscom.examples;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLPos;

/** Writes a number, a text, a structure, and two fields of a structure. */
public final class WriteVariables {
  private WriteVariables() {}

  /**
   * Runs the example. On a real robot it changes the override and {@code MYPOS}.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if writing failed
   */
  public static void main(String[] args) throws IOException {
    try (ExampleConnection connection = ExampleConnection.of(args)) {
      write(connection.client());
    }
  }

  private static void write(CrossComClient client) throws IOException {
    client.writeInt("$OV_PRO", 50);
    client.writeString("MYSTRING[]", "weld 12, left");

    KRLPos pos = new KRLPos("MYPOS").setX(2).setY(1);
    client.writeVariable(pos); // all eight fields; unset fields are 0.0

    pos.setZ(30.5);
    client.writeFields(pos, "Z"); // only Z; the other fields stay unchanged

    System.out.println("$OV_PRO = " + client.readText("$OV_PRO"));
    System.out.println("MYSTRING[] = " + client.readText("MYSTRING[]"));
    System.out.println("MYPOS = " + client.readText("MYPOS"));
  }
}
