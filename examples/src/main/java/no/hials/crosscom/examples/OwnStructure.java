package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.mock.MockServer;

/** Reads and writes a STRUC that the user's {@code $CONFIG.DAT} declares. */
public final class OwnStructure {
  private OwnStructure() {}

  /** Holds {@code STRUC WELD REAL SPEED, INT SEAM}. */
  private static final class Weld extends KRLStruct {
    private final LinkedHashMap<String, Object> fields = new LinkedHashMap<>();

    Weld(String name) {
      super(name, new String[] {"SPEED", "SEAM"});
    }

    @Override
    public HashMap<String, Object> getValue() {
      return new LinkedHashMap<>(fields);
    }

    @Override
    public void setValue(String field, String text) {
      if (field.equals("SEAM")) {
        fields.put(field, Integer.valueOf(text));
      } else {
        fields.put(field, Double.valueOf(text));
      }
    }
  }

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start()) {
      robot.variables().declareStruc("STRUC WELD REAL SPEED, INT SEAM");
      robot.variables().declare("MYWELD", "WELD", "{SPEED 0.5,SEAM 1}");
      try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
        Weld weld = new Weld("MYWELD");
        client.readVariable(weld);
        weld.setValue("SEAM", "7");
        client.writeVariable(weld);
        System.out.println(client.readText("MYWELD"));
      }
    }
  }
}
