package no.hials.crosscom.gateway.internal.mqtt;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.internal.broker.Publication;
import no.hials.crosscom.gateway.internal.broker.Received;
import no.hials.crosscom.gateway.internal.broker.Session;
import no.hials.crosscom.gateway.internal.broker.StoredMessage;
import no.hials.crosscom.gateway.internal.broker.Traffic;
import org.jspecify.annotations.Nullable;

/**
 * Publishes each variable on a topic of its own. Current values are retained; stored ones are not,
 * so that an older value never replaces a retained one. Used by the thread of the session.
 */
final class PlainTraffic implements Traffic {
  private static final byte[] NOTHING = {};

  private final Topics topics;
  private final int qos;
  private final Session session;
  private final GatewayContext context;
  private final @Nullable Consumer<Received> commands;
  private final RetainedTopics retained;
  private final ValueJson json = new ValueJson();

  /** The last message of each topic of a robot. */
  private final Map<String, byte[]> current = new HashMap<>();

  /** The robots, and whether their status topics show that they are connected. */
  private final Map<RobotFeed, Boolean> robots = new LinkedHashMap<>();

  /** The retained messages that wait for room, by topic; each is the last one of its topic. */
  private final Map<String, byte[]> due = new LinkedHashMap<>();

  /** The configuration of the topics in use; null at the start. */
  private @Nullable Plant plant;

  /** The topics in use. */
  private final Set<String> used = new HashSet<>();

  /** Whether robots were removed since {@link #deleteUnused}. */
  private boolean mayHaveUnused;

  /** Topics on which an older value was published after the last one. */
  private final Set<String> behind = new LinkedHashSet<>();

  /**
   * Creates the traffic.
   *
   * @param retained the topics of earlier runs
   * @param commands executes the commands; null if there are none
   */
  PlainTraffic(
      MqttSettings settings,
      Session session,
      GatewayContext context,
      RetainedTopics retained,
      @Nullable Consumer<Received> commands) {
    this.topics = new Topics(settings.topic());
    this.qos = settings.qos();
    this.session = session;
    this.context = context;
    this.retained = retained;
    this.commands = commands;
  }

  @Override
  public Publication will() {
    takePlant();
    return status("offline");
  }

  private Publication status(String text) {
    return new Publication(topics.gateway(), text.getBytes(UTF_8), 1, true);
  }

  @Override
  public List<TopicFilter> subscriptions() {
    return commands == null ? List.of() : List.of(new TopicFilter(topics.commands(), 0, commands));
  }

  @Override
  public void connected() {
    behind.clear();
    due.put(topics.gateway(), "online".getBytes(UTF_8));
    due.putAll(current);
    deleteUnused();
  }

  private void retain(String topic, byte[] payload) {
    retained.add(topic);
    current.put(topic, payload);
    due.put(topic, payload);
    publishDue();
  }

  /** Deletes the retained values of robots and variables that are not configured. */
  private void deleteUnused() {
    mayHaveUnused = false;
    takePlant();
    current.keySet().retainAll(used);
    retained.without(used).forEach(topic -> due.put(topic, NOTHING));
    publishDue();
  }

  /** Keeps the topics of the current configuration in the file, before they are published. */
  private void takePlant() {
    Plant configured = context.plant();
    if (configured.equals(plant)) {
      return;
    }
    plant = configured;
    used.clear();
    used.add(topics.gateway());
    for (PollPlan plan : configured.plans()) {
      String robot = plan.robot().name();
      used.add(topics.robot(robot));
      plan.variables().keySet().forEach(key -> used.add(topics.variable(robot, key)));
    }
    used.forEach(retained::add);
    retained.save();
  }

  /** Publishes the retained messages that wait, as far as there is room for them. */
  private void publishDue() {
    Iterator<Map.Entry<String, byte[]>> waiting = due.entrySet().iterator();
    while (waiting.hasNext() && session.hasRoom()) {
      Map.Entry<String, byte[]> next = waiting.next();
      if (session.hasRoom(next.getKey())) {
        waiting.remove();
        publishRetained(next.getKey(), next.getValue());
      }
    }
  }

  private void publishRetained(String topic, byte[] payload) {
    session.publish(new Publication(topic, payload, qos, true), null);
  }

  @Override
  public void tick() {
    for (Map.Entry<RobotFeed, Boolean> robot : robots.entrySet()) {
      boolean now = robot.getKey().isConnected();
      if (now != robot.getValue()) {
        robot.setValue(now);
        publishStatus(robot.getKey(), now);
      }
    }
    if (mayHaveUnused) {
      deleteUnused();
    }
    publishDue();
    retained.save();
  }

  private void publishStatus(RobotFeed robot, boolean connected) {
    retain(
        topics.robot(robot.name()),
        ValueJson.object(
            fields -> {
              fields.writeStringField("time", ValueJson.time(Instant.now()));
              fields.writeStringField("state", connected ? "connected" : "disconnected");
            }));
  }

  /** Adds a robot. */
  void added(RobotFeed robot) {
    takePlant();
    robots.put(robot, robot.isConnected());
    publishStatus(robot, robot.isConnected());
  }

  /** Publishes the values of a robot. */
  void updated(RobotFeed robot, List<Update> updates) {
    for (Update update : updates) {
      String topic = topics.variable(robot.name(), update.variable().key());
      byte[] payload = json.of(update);
      retained.add(topic);
      current.put(topic, payload);
      boolean live =
          session.publish(
              new Publication(topic, payload, qos, true), () -> new StoredMessage(topic, payload));
      if (live) {
        behind.remove(topic);
        due.remove(topic);
      } else if (session.isConnected()) {
        due.put(topic, payload); // the current value does not wait for those that are stored
      }
    }
  }

  /** Removes a robot. */
  void removed(RobotFeed robot) {
    robots.remove(robot);
    publishStatus(robot, false);
    mayHaveUnused = true;
  }

  @Override
  public boolean forward(StoredMessage message) {
    publishDue();
    if (!due.isEmpty() || !session.hasRoom(message.topic())) {
      return false; // current values first, and they may have taken the room
    }
    behind.add(message.topic());
    session.publishStored(
        new Publication(message.topic(), message.payload(), qos, false, null), message);
    return true;
  }

  @Override
  public void confirmed(Publication message) {
    boolean deletes = message.retained() && !message.payload().hasRemaining();
    if (deletes && !current.containsKey(message.topic())) {
      retained.remove(message.topic());
    }
  }

  @Override
  public void forwarded() {
    current.forEach(
        (topic, payload) -> {
          if (behind.contains(topic)) {
            due.put(topic, payload);
          }
        });
    behind.clear();
    publishDue();
  }

  @Override
  public void closing() {
    due.remove(topics.gateway());
    if (session.isConnected()) {
      session.publishNow(status("offline"), false);
    }
    // there is no later time, so the broker gets what it can in the last two seconds
    due.forEach(this::publishRetained);
    due.clear();
    retained.save();
  }
}
