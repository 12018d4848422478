package no.hials.crosscom.kafka.internal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;

/** Reads the configuration of a plant, which a connector passes to its tasks as text. */
public final class PlantText {
  /** The tables of the gateway, ignored here so that it can use the same file. */
  private static final List<String> GATEWAY_TABLES = List.of("mqtt", "opcua", "prometheus");

  private PlantText() {}

  /**
   * Reads a plant.
   *
   * @param file the name of the file, for errors
   * @throws FileException if something is wrong, with its line and the rule
   */
  public static Plant read(String file, String text) throws FileException {
    TomlTable root = TomlTable.parse(Path.of(file), text);
    List<String> tables = new ArrayList<>(PlantFile.TABLES);
    tables.addAll(GATEWAY_TABLES);
    root.allow(tables.toArray(String[]::new));
    Plant plant = PlantFile.read(root, Map.of());
    for (Robot robot : plant.robots().values()) {
      if (robot.host() == null) {
        throw new FileException(
            file + ": " + robot.name() + " needs a host: Kafka Connect simulates no robots");
      }
    }
    plant.checkLoad();
    return plant;
  }
}
