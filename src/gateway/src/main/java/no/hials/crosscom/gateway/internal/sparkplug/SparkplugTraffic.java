package no.hials.crosscom.gateway.internal.sparkplug;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import java.util.function.Supplier;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.internal.broker.CommandQueue;
import no.hials.crosscom.gateway.internal.broker.Publication;
import no.hials.crosscom.gateway.internal.broker.Received;
import no.hials.crosscom.gateway.internal.broker.Session;
import no.hials.crosscom.gateway.internal.broker.StoredMessage;
import no.hials.crosscom.gateway.internal.broker.Traffic;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Publishes robots as devices of an edge node of Sparkplug B. Stored values are sent as historical
 * ones after the births. Used by the thread of the session.
 *
 * <p>As the standard demands, all its messages have quality of service 0 and are not retained; the
 * will has 1.
 */
public final class SparkplugTraffic implements Traffic {
  private static final Logger LOG = LoggerFactory.getLogger(SparkplugTraffic.class);
  private static final String REBIRTH = "Node Control/Rebirth";
  private static final int NUMBERS = 256;
  private static final int LARGEST_COMMAND = 10_000;

  private final SparkplugId id;
  private final Session session;
  private final @Nullable CommandQueue commands;
  private final Predicate<String> isConfigured;
  private final BirthNumber connection;
  private final Map<String, Device> devices = new LinkedHashMap<>();
  private final AtomicBoolean rebirthWaits = new AtomicBoolean();
  private long lastAlias;
  private int seq;

  /** Whether the broker was sent the birth of the node. */
  private boolean born;

  /**
   * Creates the traffic.
   *
   * @param file keeps the number of the last connection
   * @param commands executes commands; null if there are none
   * @param isConfigured whether the configuration has a robot, by its name
   */
  public SparkplugTraffic(
      SparkplugId id,
      Session session,
      Path file,
      @Nullable CommandQueue commands,
      Predicate<String> isConfigured) {
    this.id = id;
    this.isConfigured = isConfigured;
    this.session = session;
    this.commands = commands;
    this.connection = new BirthNumber(file);
  }

  @Override
  public Publication will() {
    connection.next();
    return new Publication(id.topic("NDEATH"), Payloads.encode(null, List.of(bdSeq())), 1, false);
  }

  private Metric bdSeq() {
    return Payloads.metric(
        new Metric.MetricBuilder("bdSeq", MetricDataType.Int64, (long) connection.current()));
  }

  @Override
  public List<TopicFilter> subscriptions() {
    List<TopicFilter> all = new ArrayList<>();
    all.add(new TopicFilter(id.topic("NCMD"), 1, this::nodeCommand));
    if (commands != null) {
      // quality 0, so that none is received twice
      all.add(new TopicFilter(id.topic("DCMD") + "/+", 0, this::deviceCommand));
    }
    return all;
  }

  @Override
  public void connected() {
    seq = 0;
    Metric rebirth =
        Payloads.metric(new Metric.MetricBuilder(REBIRTH, MetricDataType.Boolean, false));
    born = publishNow(message("NBIRTH", "", List.of(bdSeq(), rebirth)));
    devices.values().forEach(Device::unborn);
    publishBirths();
  }

  /** Publishes the births that are due, as far as there is room for them. */
  private void publishBirths() {
    for (Device device : devices.values()) {
      if (device.isBirthDue() && hasRoom("DBIRTH", device)) {
        birth(device);
      }
    }
  }

  /**
   * Returns whether a message about a device can be published now. A device is not born while its
   * values are held back.
   */
  private boolean hasRoom(String type, Device device) {
    return born && session.hasRoom(topic(type, device.name())) && !isHeldBack(device);
  }

  private boolean isHeldBack(Device device) {
    return session.isHeldBack(topic("DDATA", device.name()));
  }

  private String topic(String type, String device) {
    return id.topic(type) + (device.isEmpty() ? "" : "/" + device);
  }

  private Publication message(String type, String device, List<Metric> metrics) {
    return new Publication(topic(type, device), Payloads.encode(seq, metrics), 0, false);
  }

  /**
   * Publishes a message with the next number. A refused message leaves the number to the next one.
   *
   * @return whether it was not refused
   */
  private boolean publish(Publication message, @Nullable Supplier<StoredMessage> spare) {
    boolean accepted = session.accepts(message);
    if (accepted) {
      boolean unused = session.publish(message, spare);
    }
    return count(accepted);
  }

  /** Publishes a message without which others are not valid, with the next number. */
  private boolean publishNow(Publication message) {
    return count(session.publishNow(message, false));
  }

  /** Counts a message that was not refused. Returns whether it was not. */
  private boolean count(boolean accepted) {
    seq = accepted ? (seq + 1) % NUMBERS : seq;
    return accepted;
  }

  private void birth(Device device) {
    boolean again = device.isBorn();
    List<DeviceMetric> unsent = device.takeUnsent();
    if (!publish(device, "DBIRTH", device.birth(), unsent)) {
      device.unborn();
      if (again) {
        // its last birth is not valid any more
        boolean unused = publishNow(message("DDEATH", device.name(), List.of()));
      }
    }
  }

  /**
   * Publishes values of a device.
   *
   * @param unsent those that are stored if the broker does not get them
   * @return whether they were not refused
   */
  private boolean publish(
      Device device, String type, List<Metric> metrics, List<DeviceMetric> unsent) {
    // copied now, because the metrics may change before the message is stored
    List<Metric> spare = unsent.stream().map(DeviceMetric::stored).toList();
    return publish(
        message(type, device.name(), metrics),
        spare.isEmpty() ? null : () -> stored(device, spare));
  }

  private void death(Device device) {
    if (session.isConnected() && device.isBorn()) {
      boolean unused = publishNow(message("DDEATH", device.name(), List.of()));
    }
    device.unborn();
  }

  /** Adds a robot. */
  public void added(RobotFeed robot) {
    devices.put(robot.name(), new Device(robot, () -> ++lastAlias));
  }

  /** Removes a robot. */
  public void removed(RobotFeed robot) {
    Device device = devices.remove(robot.name());
    if (device != null) {
      death(device);
    }
  }

  /** Publishes or stores the values of a robot. */
  public void updated(RobotFeed robot, List<Update> updates) {
    Device device = devices.get(robot.name());
    if (device == null) {
      return;
    }
    if (!robot.isConnected()) {
      store(device); // what was read before, and was to come with its birth
    }
    device.take(updates);
    if (!session.isConnected()) {
      store(device);
    } else if (robot.isConnected()) {
      publishNew(device);
    } else if (updates.stream().anyMatch(it -> it.quality() == Quality.GOOD)) {
      store(device); // read before the connection to the robot ended
    }
    if (!robot.isConnected()) {
      var unused = device.takeUnsent(); // its death tells that they are stale
      device.lost();
      death(device);
    }
  }

  /** Publishes or stores new values; those of a robot without a birth wait for the birth. */
  private void publishNew(Device device) {
    boolean due = device.isBirthDue();
    if ((due || device.isBorn()) && !hasRoom(due ? "DBIRTH" : "DDATA", device)) {
      boolean refused = false;
      if (isHeldBack(device)) {
        death(device); // otherwise its last values would seem to be the current ones
        refused = !session.accepts(message("DDATA", device.name(), List.of()));
      }
      if (refused) {
        var unused = device.takeUnsent();
      } else {
        store(device);
      }
    } else if (due) {
      birth(device);
    } else if (device.isBorn()) {
      List<DeviceMetric> unsent = device.takeUnsent();
      if (!unsent.isEmpty()) {
        boolean unused =
            publish(device, "DDATA", unsent.stream().map(DeviceMetric::data).toList(), unsent);
      }
    }
  }

  private void store(Device device) {
    List<Metric> metrics = device.takeUnsent().stream().map(DeviceMetric::stored).toList();
    if (!metrics.isEmpty()) {
      session.store(stored(device, metrics));
    }
  }

  private static StoredMessage stored(Device device, List<Metric> metrics) {
    return new StoredMessage(device.name(), Payloads.encode(null, metrics));
  }

  @Override
  public void tick() {
    for (Device device : devices.values()) {
      if (!device.robot().isConnected() && device.isBorn() && !session.isForwarding()) {
        device.lost();
        death(device);
      }
    }
    if (!born && session.isConnected()) {
      connected();
    }
    publishBirths();
  }

  @Override
  public boolean forward(StoredMessage message) {
    if (!born) {
      return false;
    }
    Device device = devices.get(message.topic());
    if (device == null && isConfigured.test(message.topic())) {
      return false; // the gateway is starting the robot
    }
    List<Metric> metrics = new ArrayList<>();
    int otherTypes = 0;
    if (device != null) {
      for (Metric old : Payloads.decode(message.payload())) {
        DeviceMetric known = device.fromStore(old.getName(), old.getDataType());
        if (known.type().equals(old.getDataType())) {
          metrics.add(
              Payloads.metric(
                  new Metric.MetricBuilder(
                          Long.valueOf(known.alias()), old.getDataType(), old.getValue())
                      .timestamp(old.getTimestamp())
                      .isHistorical(true)
                      .properties(old.getProperties())));
        } else {
          otherTypes++;
        }
      }
    }
    if (device == null || metrics.isEmpty()) {
      session.lost("type", otherTypes);
      session.lost("unknown", otherTypes > 0 ? 0 : 1);
      session.skipStored(message);
      return true;
    }
    boolean accepted = session.accepts(message("DDATA", device.name(), metrics));
    if (accepted && (!device.isBorn() || device.isChanged())) {
      if (!hasRoom("DBIRTH", device)) {
        return false;
      }
      birth(device);
      if (!device.isBorn()) {
        session.lost("refused", 1);
        accepted = false;
      }
    }
    if (accepted && !hasRoom("DDATA", device)) {
      return false; // perhaps after the birth
    }
    session.lost("type", otherTypes);
    if (accepted) {
      boolean unused =
          count(session.publishStored(message("DDATA", device.name(), metrics), message));
    } else {
      session.skipStored(message);
    }
    return true;
  }

  @Override
  public void forwarded() {
    tick();
  }

  @Override
  public void closing() {
    devices.values().forEach(this::store);
    if (session.isConnected()) {
      session.publishNow(
          new Publication(id.topic("NDEATH"), Payloads.encode(null, List.of(bdSeq())), 0, false),
          false);
    }
  }

  private static List<Command> wishes(Received message) {
    try {
      return message.payload().remaining() > LARGEST_COMMAND
          ? List.of()
          : Command.decode(message.payload());
    } catch (IllegalArgumentException e) {
      LOG.warn("{}: {}", message.topic(), e.getMessage());
      return List.of();
    }
  }

  private void nodeCommand(Received message) {
    boolean rebirth =
        !message.retained()
            && wishes(message).stream().anyMatch(it -> REBIRTH.equals(it.name()) && it.isTrue());
    // several requests that wait are answered by the same births
    if (rebirth && rebirthWaits.compareAndSet(false, true)) {
      session.submit(
          0,
          () -> {
            rebirthWaits.set(false);
            if (session.isConnected()) {
              LOG.info("Sparkplug: births are published again on request");
              connected();
            }
          });
    }
  }

  private void deviceCommand(Received message) {
    String robot = message.topic().substring(message.topic().lastIndexOf('/') + 1);
    List<Command> wishes = wishes(message);
    session.run(() -> execute(message, robot, wishes));
  }

  private void execute(Received message, String robot, List<Command> wishes) {
    CommandQueue executor = commands;
    if (executor == null) {
      return;
    }
    String who = "mqtt:" + (message.sender().isEmpty() ? "unknown" : message.sender());
    Device device = devices.get(robot);
    for (Command wish : wishes) {
      DeviceMetric metric = device == null ? null : device.find(wish.alias(), wish.name());
      if (message.retained() || device == null || metric == null) {
        String unused =
            executor.refused(
                who,
                robot,
                metric == null ? String.valueOf(wish.name()) : metric.name(),
                message.retained()
                    ? "a retained command is not executed: nobody knows how old it is"
                    : "the device has no such metric");
        continue;
      }
      String text;
      try {
        wish.check(metric.name());
        text = wish.text(metric.type());
      } catch (IllegalArgumentException e) {
        String unused =
            executor.refuse(
                who,
                device.robot(),
                metric.name(),
                wish.sent(),
                "%s: %s was not written: %s".formatted(robot, metric.name(), e.getMessage()));
        continue;
      }
      executor.execute(who, robot, metric.name(), text, message.expiry(), result -> {});
    }
  }
}
