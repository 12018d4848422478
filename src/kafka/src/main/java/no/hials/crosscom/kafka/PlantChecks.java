package no.hials.crosscom.kafka;

import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.kafka.internal.ConnectorSettings;
import org.apache.kafka.common.config.Config;
import org.apache.kafka.common.config.ConfigValue;

/** Checks the file of a plant when a connector is created or changed. */
final class PlantChecks {
  private PlantChecks() {}

  /** Adds the errors in the plant file to its property. */
  static Config check(Config config) {
    for (ConfigValue value : config.configValues()) {
      if (value.name().equals(ConnectorSettings.PLANT)
          && value.errorMessages().isEmpty()
          && value.value() instanceof String file) {
        try {
          String unused = ConnectorSettings.plantText(file);
        } catch (FileException e) {
          value.addErrorMessage(e.getMessage());
        }
      }
    }
    return config;
  }
}
