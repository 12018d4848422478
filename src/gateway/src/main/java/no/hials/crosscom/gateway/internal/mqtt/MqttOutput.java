package no.hials.crosscom.gateway.internal.mqtt;

import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Output;
import no.hials.crosscom.gateway.internal.broker.BrokerSettings;
import no.hials.crosscom.gateway.internal.broker.CommandQueue;
import no.hials.crosscom.gateway.internal.broker.FolderLock;
import no.hials.crosscom.gateway.internal.broker.Session;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugTraffic;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Publishes the values of robots to an MQTT broker. */
final class MqttOutput implements Output {
  private static final Logger LOG = LoggerFactory.getLogger(MqttOutput.class);

  private final FolderLock lock;
  private final Session session;
  private final PlainTraffic traffic;
  private final @Nullable CommandQueue commands;
  private final @Nullable Sparkplug sparkplug;

  /** The connection for Sparkplug, since a connection has only one will. */
  private record Sparkplug(Session session, SparkplugTraffic traffic) {}

  /**
   * Connects in the background.
   *
   * @param folder the folder of the stores
   * @param lock the lock of the folder, which it releases at the end
   */
  MqttOutput(MqttSettings settings, GatewayContext context, Path folder, FolderLock lock) {
    this.lock = lock;
    BrokerSettings broker = settings.broker();
    if (broker.clientId() == null) {
      broker = broker.withClientId("jopenshowvar-" + UUID.randomUUID().toString().substring(0, 8));
    }
    session = new Session(broker, "plain", folder.resolve("plain"), context.health());
    commands = settings.commands() ? new CommandQueue(context) : null;
    RetainedTopics retained = new RetainedTopics(folder.resolve("retained"), broker.url());
    traffic = plainTraffic(settings, context, retained, commands);
    LOG.info("MQTT: publishes to {}, topics {}/#", broker.url(), settings.topic());
    if (commands != null && broker.version() == 3) {
      LOG.warn("MQTT: with MQTT 3.1.1, a retained command may be executed; MQTT 5 has no such gap");
    }
    SparkplugId id = settings.sparkplug();
    if (id == null) {
      sparkplug = null;
    } else {
      BrokerSettings own = broker.withClientId(broker.clientId() + "-sparkplug");
      Session second = new Session(own, "sparkplug", folder.resolve("sparkplug"), context.health());
      sparkplug =
          new Sparkplug(
              second,
              new SparkplugTraffic(
                  id,
                  second,
                  folder.resolve("bdseq"),
                  commands,
                  robot -> context.plant().robots().containsKey(robot)));
      LOG.info("MQTT: publishes as the Sparkplug node {}/{}", id.group(), id.node());
    }
    try {
      session.start(traffic);
      if (sparkplug != null) {
        sparkplug.session.start(sparkplug.traffic);
      }
    } catch (OutOfMemoryError e) {
      close(); // no thread can be started
      throw e;
    }
  }

  private PlainTraffic plainTraffic(
      MqttSettings settings,
      GatewayContext context,
      RetainedTopics retained,
      @Nullable CommandQueue executor) {
    if (executor == null) {
      return new PlainTraffic(settings, session, context, retained, null);
    }
    TopicCommands topicCommands = new TopicCommands(settings, executor, session::submitAnswer);
    return new PlainTraffic(settings, session, context, retained, topicCommands::receive);
  }

  @Override
  public void added(RobotFeed robot) {
    session.submit(0, () -> traffic.added(robot));
    if (sparkplug != null) {
      sparkplug.session.submit(0, () -> sparkplug.traffic.added(robot));
    }
  }

  @Override
  public void updated(RobotFeed robot, List<Update> updates) {
    session.submit(updates.size(), () -> traffic.updated(robot, updates));
    if (sparkplug != null) {
      sparkplug.session.submit(updates.size(), () -> sparkplug.traffic.updated(robot, updates));
    }
  }

  @Override
  public void removed(RobotFeed robot) {
    session.submit(0, () -> traffic.removed(robot));
    if (sparkplug != null) {
      sparkplug.session.submit(0, () -> sparkplug.traffic.removed(robot));
    }
  }

  @Override
  public void endWrites() {
    if (commands != null) {
      commands.close();
    }
  }

  @Override
  public void close() {
    endWrites();
    if (sparkplug != null) {
      sparkplug.session.beginClose();
    }
    session.close();
    if (sparkplug != null) {
      sparkplug.session.close();
    }
    lock.close();
  }
}
