package no.hials.crosscom.web.internal.robot;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Server;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A robot of the page, with the only connection to its controller.
 *
 * <p>It reconnects automatically. {@link #simulation} has the functions of a simulated controller,
 * and is empty for other controllers.
 */
public final class RobotSession implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RobotSession.class);
  private static final String DEFAULT_NAME = "robot";

  private final String name;
  private final RobotConnection connection;
  private final Hub hub;
  private final Lock lock;
  private final Header header;
  private final List<Sampling> samplings = new CopyOnWriteArrayList<>();
  private volatile @Nullable Server server;

  /** Receives events from the first attempt to connect, before the session exists. */
  private static final class Events {
    private @Nullable RobotSession session;

    synchronized void changed(ConnectionEvent event) {
      if (session != null) {
        session.connectionChanged(event);
      }
    }

    synchronized void to(RobotSession one) {
      session = one;
    }
  }

  private RobotSession(Robot robot, RobotConnection connection, boolean readOnly, AuditLog audit) {
    this.name = robot.name().isEmpty() ? DEFAULT_NAME : robot.name();
    this.connection = connection;
    hub = new Hub(connection.client());
    lock = new Lock(connection.robot(), readOnly);
    header = new Header(this, audit);
  }

  /**
   * Connects to a robot.
   *
   * @param readOnly whether nothing may be changed
   */
  static RobotSession open(
      Robot robot, RobotConnection.Opener opener, boolean readOnly, AuditLog audit)
      throws IOException {
    Events events = new Events();
    RobotConnection connection =
        opener.open(robot, Robot.LASTING.andThen(cfg -> cfg.listener(events::changed)));
    RobotSession session = new RobotSession(robot, connection, readOnly, audit);
    events.to(session);
    return session;
  }

  /** Returns its name on the page. */
  public String name() {
    return name;
  }

  /** Returns the client, which the whole page uses. */
  public CrossComClient client() {
    return connection.client();
  }

  private void connectionChanged(ConnectionEvent event) {
    server = null; // it may be another one now
    header.connectionChanged(event);
    samplings.forEach(sampling -> sampling.connectionChanged(event));
  }

  /**
   * Samples variables over the connection, independently of what viewers watch, until {@link
   * #endSampling}.
   */
  public Sampling sample(Sampling.SamplingPlan plan) {
    Sampling sampling = Sampling.through(connection, plan);
    samplings.add(sampling);
    return sampling;
  }

  /** Ends a sampling that {@link #sample} started; the connection stays open. */
  public void endSampling(Sampling sampling) throws IOException {
    samplings.remove(sampling);
    sampling.close();
  }

  /** Returns the readings of all viewers. */
  public Hub hub() {
    return hub;
  }

  /** Returns the permission to change something. */
  public Lock lock() {
    return lock;
  }

  Header header() {
    return header;
  }

  /** Returns the simulated controller; empty if the robot is not simulated by this process. */
  public Optional<MockServer> simulation() {
    return connection.simulation(MockServer.class);
  }

  /**
   * Returns whether the server is C3 Bridge, which has files and programs. Asks it if necessary.
   */
  public boolean isBridge() throws IOException {
    return client().getServer().type() == ServerType.C3_BRIDGE;
  }

  /** Asks the server for its type and version, unless it has answered before. */
  void findServer() {
    if (server == null) {
      try {
        server = client().getServer();
      } catch (IOException e) {
        LOG.debug("no server yet", e);
      }
    }
  }

  /** Returns the type and version of the server for people; empty until there is a connection. */
  String server() {
    Server known = server;
    if (known == null) {
      return "";
    }
    String type = known.type() == ServerType.C3_BRIDGE ? "C3 Bridge" : "KUKAVARPROXY";
    return known.version() == null ? type : type + " " + known.version();
  }

  @Override
  public void close() throws IOException {
    hub.close();
    connection.close();
  }
}
