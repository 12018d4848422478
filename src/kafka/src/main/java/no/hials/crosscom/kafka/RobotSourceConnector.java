package no.hials.crosscom.kafka;

import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.kafka.internal.ConnectorSettings;
import no.hials.crosscom.kafka.internal.ConnectorVersion;
import no.hials.crosscom.kafka.internal.PlantText;
import no.hials.crosscom.kafka.internal.PlantWatch;
import org.apache.kafka.common.config.Config;
import org.apache.kafka.common.config.ConfigDef;
import org.apache.kafka.common.config.ConfigException;
import org.apache.kafka.connect.connector.Task;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.source.ExactlyOnceSupport;
import org.apache.kafka.connect.source.SourceConnector;
import org.apache.kafka.connect.util.ConnectorUtils;
import org.jspecify.annotations.Nullable;

/** Reads the robots of a plant into topics. The robots are spread over its tasks. */
public final class RobotSourceConnector extends SourceConnector {
  private @Nullable ConnectorSettings settings;
  private @Nullable PlantWatch plant;

  /** Creates a connector that Connect starts. */
  public RobotSourceConnector() {}

  @Override
  public String version() {
    return ConnectorVersion.own();
  }

  @Override
  public ConfigDef config() {
    return ConnectorSettings.SOURCE;
  }

  @Override
  public Config validate(Map<String, String> properties) {
    Config config = PlantChecks.check(super.validate(properties));
    if (config.configValues().stream().allMatch(value -> value.errorMessages().isEmpty())) {
      ConnectorSettings read = ConnectorSettings.of(ConnectorSettings.SOURCE, properties);
      String file = read.getString(ConnectorSettings.PLANT);
      try {
        List<String> robots = robots(file, ConnectorSettings.plantText(file));
        check(config, ConnectorSettings.TOPIC, () -> read.checkTopics(robots));
        check(config, ConnectorSettings.LEASE_TOPIC, () -> read.checkLeaseTopic(robots));
      } catch (FileException e) {
        addError(config, ConnectorSettings.PLANT, e);
      }
    }
    return config;
  }

  private static void check(Config config, String key, Runnable check) {
    try {
      check.run();
    } catch (ConfigException e) {
      addError(config, key, e);
    }
  }

  private static void addError(Config config, String key, Exception error) {
    config.configValues().stream()
        .filter(value -> value.name().equals(key))
        .forEach(value -> value.addErrorMessage(String.valueOf(error.getMessage())));
  }

  private static List<String> robots(String file, String text) throws FileException {
    return PlantText.read(file, text).robots().keySet().stream().sorted().toList();
  }

  @Override
  public ExactlyOnceSupport exactlyOnceSupport(Map<String, String> properties) {
    return ExactlyOnceSupport.SUPPORTED;
  }

  @Override
  public Class<? extends Task> taskClass() {
    return RobotSourceTask.class;
  }

  @Override
  public void start(Map<String, String> properties) {
    ConnectorSettings read = ConnectorSettings.of(ConnectorSettings.SOURCE, properties);
    settings = read;
    plant =
        new PlantWatch(
            read.getString(ConnectorSettings.PLANT), () -> context().requestTaskReconfiguration());
  }

  @Override
  public List<Map<String, String>> taskConfigs(int maxTasks) {
    if (settings == null || plant == null) {
      throw new IllegalStateException("not started");
    }
    try {
      String text = plant.text();
      List<String> robots = robots(settings.getString(ConnectorSettings.PLANT), text);
      // a robot may have come with a change of the file
      settings.checkTopics(robots);
      settings.checkLeaseTopic(robots);
      int groups = Math.min(maxTasks, robots.size());
      return settings.tasks(text, ConnectorUtils.groupPartitions(robots, groups));
    } catch (FileException | ConfigException e) {
      // the tasks go on with the plant they have, as after a change to an invalid file
      throw new ConnectException("the tasks stay as they are: " + e.getMessage(), e);
    }
  }

  @Override
  public void stop() {
    if (plant != null) {
      plant.close();
    }
  }
}
