package no.hials.crosscom.simulator.internal.data;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The data lists in the jar that describe the simulated controller. */
public final class BuiltInDataLists {
  /** The names, in an order in which each list follows those it needs. */
  public static final List<String> NAMES =
      List.of("$TYPES.DAT", "$OPERATE.DAT", "$MACHINE.DAT", "$CONFIG.DAT");

  private static final String FOLDER = "/no/hials/crosscom/simulator/";

  private BuiltInDataLists() {}

  public static String text(String name) throws IOException {
    try (InputStream in = BuiltInDataLists.class.getResourceAsStream(FOLDER + name)) {
      if (in == null) {
        throw new FileNotFoundException("resource " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }
}
