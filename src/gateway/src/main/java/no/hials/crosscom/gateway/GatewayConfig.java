package no.hials.crosscom.gateway;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;

/**
 * A configuration of the gateway.
 *
 * @param plant the robots and the variables to read
 * @param folder the folder for the files of outputs
 * @param outputs the settings of the outputs, by the names of their tables
 */
public record GatewayConfig(Plant plant, Path folder, Map<String, Object> outputs) {
  /** Copies the map. */
  public GatewayConfig {
    outputs = Map.copyOf(outputs);
  }

  /**
   * Reads a configuration.
   *
   * @param root the file
   * @param more robots that are not in the file
   * @param kinds the available kinds of outputs
   * @throws FileException if the configuration has an error; the message has its line and the rule
   */
  public static GatewayConfig read(
      TomlTable root, Path folder, Map<String, Robot> more, List<OutputKind<?>> kinds)
      throws FileException {
    List<String> tables = new ArrayList<>(PlantFile.TABLES);
    kinds.forEach(kind -> tables.add(kind.table()));
    root.allow(tables.toArray(String[]::new));
    Map<String, Object> outputs = new LinkedHashMap<>();
    for (OutputKind<?> kind : kinds) {
      if (root.has(kind.table())) {
        outputs.put(kind.table(), kind.read(root.table(kind.table())));
      }
    }
    GatewayConfig config = new GatewayConfig(PlantFile.read(root, more), folder, outputs);
    try {
      config.plant.checkLoad();
    } catch (FileException e) {
      String table = root.has("groups") ? "groups" : "robots";
      throw new FileException(root.place(table) + ": " + e.getMessage(), e);
    }
    return config;
  }
}
