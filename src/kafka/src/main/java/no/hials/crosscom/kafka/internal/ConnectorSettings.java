package no.hials.crosscom.kafka.internal;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.protocol.value.PrintableText;
import org.apache.kafka.clients.CommonClientConfigs;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.common.config.AbstractConfig;
import org.apache.kafka.common.config.ConfigDef;
import org.apache.kafka.common.config.ConfigDef.Importance;
import org.apache.kafka.common.config.ConfigDef.Range;
import org.apache.kafka.common.config.ConfigException;

/** The properties of the connectors. */
public final class ConnectorSettings extends AbstractConfig {
  /** The file with the robots. */
  public static final String PLANT = "plant";

  /** The pattern of the topics of samples. */
  public static final String TOPIC = "topic";

  /** The topic of the records that renew the lease. */
  public static final String LEASE_TOPIC = "lease.topic";

  /** The length of the lease. */
  public static final String LEASE = "lease.ms";

  /** The wait after a lost lease. */
  public static final String LEASE_RECOVERY = "lease.recovery.ms";

  /** The samples that may wait for Connect. */
  public static final String BUFFER = "buffer.records";

  /** Switches writing on. */
  public static final String WRITES = "writes.enabled";

  /** The age above which a record is not written. */
  public static final String MAX_AGE = "max.age.ms";

  /** The folder of the audit log. */
  public static final String AUDIT = "audit.folder";

  /** The brokers where the claims are verified. */
  public static final String BOOTSTRAP = "bootstrap.servers";

  /** The topic of the records that were not written. */
  public static final String DEAD_LETTERS = "errors.deadletterqueue.topic.name";

  private static final String TOLERANCE = "errors.tolerance";

  /** How long the producer of the dead letters tries; Connect would let it try for weeks. */
  private static final String DELIVERY = "producer.override.delivery.timeout.ms";

  /** The answers of the broker that the producer waits for. */
  private static final String ACKS = "producer.override.acks";

  /** The prefix of further settings of the client that verifies the claims. */
  private static final String ADMIN_PREFIX = "admin.";

  // passed from a connector to its tasks
  private static final String TASK_PLANT = "task.plant";
  private static final String TASK_PLANT_ERROR = "task.plant.error";
  private static final String TASK_ROBOTS = "task.robots";
  private static final String TASK_NUMBER = "task.number";

  /** Replaced by the name of the robot in the pattern of a topic. */
  private static final String ROBOT = "{robot}";

  private static final String TOPIC_RULE =
      "letters, digits, _, - and ., at most 249, and not only dots";

  private static final Pattern TOPIC_NAME = Pattern.compile("(?!\\.{1,2}$)[a-zA-Z0-9._-]{1,249}");

  /** The longest lease, and the longest wait after it, in ms. */
  private static final long LONGEST = 3_600_000;

  /** The longest age, a year, in ms. */
  private static final long OLDEST = 31_536_000_000L;

  /** The properties of the source connector. */
  public static final ConfigDef SOURCE =
      common()
          .define(
              TOPIC,
              ConfigDef.Type.STRING,
              "robots",
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkTopic, () -> TOPIC_RULE),
              Importance.HIGH,
              "The topic of the samples; {robot} in it is replaced by the name of the robot")
          .define(
              LEASE_TOPIC,
              ConfigDef.Type.STRING,
              "robots-leases",
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkName, () -> TOPIC_RULE),
              Importance.MEDIUM,
              "The topic of the records that renew the leases and show the figures of each task")
          .define(
              LEASE_RECOVERY,
              ConfigDef.Type.LONG,
              10_000,
              between(0, LONGEST),
              Importance.MEDIUM,
              "How long a task that has lost its lease waits before it uses robots again, in ms")
          .define(
              BUFFER,
              ConfigDef.Type.INT,
              10_000,
              between(1, 1_000_000),
              Importance.LOW,
              "The number of samples that may wait until Connect takes them; more are counted as"
                  + " lost")
          .define(
              ACKS,
              ConfigDef.Type.STRING,
              null,
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkAnswered, () -> "not 0"),
              Importance.LOW,
              "Must not be 0: only an answer of the broker renews the lease");

  /** The properties of the sink connector. */
  public static final ConfigDef SINK =
      common()
          .define(
              WRITES,
              ConfigDef.Type.BOOLEAN,
              false,
              Importance.HIGH,
              "Must be true: a write can move a machine")
          .define(
              BOOTSTRAP,
              ConfigDef.Type.LIST,
              Importance.HIGH,
              "The brokers, where the connector verifies that an offset was committed before it"
                  + " writes")
          .define(
              AUDIT,
              ConfigDef.Type.STRING,
              ConfigDef.NO_DEFAULT_VALUE,
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkPath, () -> "a path"),
              Importance.HIGH,
              "The folder of audit.jsonl on each worker")
          .define(
              MAX_AGE,
              ConfigDef.Type.LONG,
              10_000,
              between(1, OLDEST),
              Importance.MEDIUM,
              "A record older than this, by its timestamp, is not written, in ms")
          .define(
              DEAD_LETTERS,
              ConfigDef.Type.STRING,
              ConfigDef.NO_DEFAULT_VALUE,
              new ConfigDef.NonEmptyString(),
              Importance.HIGH,
              "The topic of the records that were not written")
          .define(
              TOLERANCE,
              ConfigDef.Type.STRING,
              ConfigDef.NO_DEFAULT_VALUE,
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkTolerance, () -> "all"),
              Importance.HIGH,
              "Must be all: a record that is not written goes to the dead-letter topic")
          .define(
              DELIVERY,
              ConfigDef.Type.INT,
              ConfigDef.NO_DEFAULT_VALUE,
              between(1, 60_000),
              Importance.HIGH,
              "The longest time until a task fails that cannot put a record on the dead-letter"
                  + " topic, in ms")
          .define(
              ACKS,
              ConfigDef.Type.STRING,
              ConfigDef.NO_DEFAULT_VALUE,
              ConfigDef.LambdaValidator.with(ConnectorSettings::checkAllAnswered, () -> "all"),
              Importance.HIGH,
              "Must be all: a record is only done when the dead-letter topic has its dead letter");

  private ConnectorSettings(ConfigDef definition, Map<String, String> properties) {
    super(definition, properties, false);
  }

  /** Returns a rule for numbers. A value that is not a number has its own error already. */
  private static ConfigDef.Validator between(long min, long max) {
    Range range = Range.between(min, max);
    return ConfigDef.LambdaValidator.with(
        (key, value) -> {
          if (value != null) {
            range.ensureValid(key, value);
          }
        },
        range::toString);
  }

  private static void checkTopic(String key, Object value) {
    if (!isTopic(String.valueOf(value).replace(ROBOT, "r"))) {
      throw new ConfigException(key, value, "must be " + TOPIC_RULE);
    }
  }

  private static void checkName(String key, Object value) {
    if (!isTopic(String.valueOf(value))) {
      throw new ConfigException(key, value, "must be " + TOPIC_RULE);
    }
  }

  private static boolean isTopic(String name) {
    return TOPIC_NAME.matcher(name).matches();
  }

  private static void checkTolerance(String key, Object value) {
    if (value != null && !"all".equals(value)) {
      throw new ConfigException(key, value, "must be all");
    }
  }

  private static void checkAnswered(String key, Object value) {
    if ("0".equals(value)) {
      throw new ConfigException(
          key, value, "must not be 0: without an answer of the broker no robot is read");
    }
  }

  private static void checkAllAnswered(String key, Object value) {
    if (value != null && !"all".equals(value) && !"-1".equals(value)) {
      throw new ConfigException(
          key, value, "must be all: with less, dead letters can be lost without notice");
    }
  }

  private static void checkPath(String key, Object value) {
    new ConfigDef.NonEmptyString().ensureValid(key, value);
    try {
      Path unused = Path.of(String.valueOf(value));
    } catch (InvalidPathException e) {
      throw new ConfigException(key, PrintableText.shortened(e.getInput()), e.getReason());
    }
  }

  private static ConfigDef common() {
    return new ConfigDef()
        .define(
            PLANT,
            ConfigDef.Type.STRING,
            ConfigDef.NO_DEFAULT_VALUE,
            ConfigDef.LambdaValidator.with(ConnectorSettings::checkPath, () -> "a path"),
            Importance.HIGH,
            "The TOML file with the robots and their variables, on each worker")
        .define(
            LEASE,
            ConfigDef.Type.LONG,
            3000,
            between(500, LONGEST),
            Importance.MEDIUM,
            "How long a task uses robots after the last proof that it reaches the broker, in ms;"
                + " at most session.timeout.ms - heartbeat.interval.ms - 500");
  }

  /**
   * Reads properties.
   *
   * @param definition {@link #SOURCE} or {@link #SINK}
   * @throws ConfigException if a property is invalid
   */
  public static ConnectorSettings of(ConfigDef definition, Map<String, String> properties) {
    return new ConnectorSettings(definition, properties);
  }

  /** Checks the plant file and returns its text. */
  public static String plantText(String file) throws FileException {
    String text = TomlTable.textOf(Path.of(file));
    Plant unused = PlantText.read(file, text);
    return text;
  }

  /** Returns the topic of the samples of a robot. */
  public String topic(String robot) {
    return getString(TOPIC).replace(ROBOT, robot);
  }

  /**
   * Checks the topics of the samples of robots.
   *
   * @throws ConfigException if one of them is not a valid name
   */
  public void checkTopics(Collection<String> robots) {
    robots.forEach(robot -> checkName(TOPIC, topic(robot)));
  }

  /**
   * Checks the topic of the leases.
   *
   * @throws ConfigException if it is also the topic of the samples of a robot
   */
  public void checkLeaseTopic(Collection<String> robots) {
    String topic = getString(LEASE_TOPIC);
    if (robots.stream().map(this::topic).anyMatch(topic::equals)) {
      throw new ConfigException(LEASE_TOPIC, topic, "must not be the topic of the samples");
    }
  }

  /** Returns a client of the brokers of the sink connector. */
  public Admin admin() {
    Map<String, Object> properties = originalsWithPrefix(ADMIN_PREFIX);
    properties.put(
        CommonClientConfigs.BOOTSTRAP_SERVERS_CONFIG, String.join(",", getList(BOOTSTRAP)));
    return Admin.create(properties);
  }

  /** Returns the duration that a property sets in ms. */
  public Duration time(String key) {
    return Duration.ofMillis(getLong(key));
  }

  /** Returns the properties of tasks. */
  public List<Map<String, String>> tasks(String plantText, List<List<String>> robots) {
    return tasks(TASK_PLANT, plantText, robots);
  }

  /**
   * Returns the properties of tasks that fail when they start.
   *
   * @param error why the plant cannot be read
   */
  public List<Map<String, String>> tasksWithoutPlant(String error, List<List<String>> robots) {
    return tasks(TASK_PLANT_ERROR, error, robots);
  }

  private List<Map<String, String>> tasks(String key, String value, List<List<String>> robots) {
    List<Map<String, String>> tasks = new ArrayList<>();
    for (List<String> some : robots) {
      Map<String, String> task = new HashMap<>(originalsStrings());
      task.put(key, value);
      task.put(TASK_ROBOTS, String.join(",", some));
      task.put(TASK_NUMBER, String.valueOf(tasks.size()));
      tasks.add(task);
    }
    return tasks;
  }

  /** Returns the plant of a task. */
  public TaskPlant taskPlant() throws FileException {
    String error = originalsStrings().get(TASK_PLANT_ERROR);
    if (error != null) {
      throw new FileException(error);
    }
    return new TaskPlant(getString(PLANT), own(TASK_PLANT));
  }

  /** Returns the names of the robots of a task. */
  public List<String> taskRobots() {
    return List.of(own(TASK_ROBOTS).split(","));
  }

  /** Returns the number of a task, from 0. */
  public String taskNumber() {
    return own(TASK_NUMBER);
  }

  private String own(String key) {
    return Objects.requireNonNull(originalsStrings().get(key), key);
  }

  /** Returns the name of the connector. */
  public String connector() {
    return own("name");
  }
}
