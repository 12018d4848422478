package no.hials.crosscom.web.internal.robot;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Viewer;

/** The robots of the page, and the commands that every view needs. */
public final class RobotSessions implements AutoCloseable {
  private static final int MAX_NAMES = 500;
  private static final int MAX_LISTS = 50;

  private final Map<String, RobotSession> sessions = new LinkedHashMap<>();
  private final Map<Viewer, Lists> lists = new ConcurrentHashMap<>();
  private final AuditLog audit;

  private RobotSessions(AuditLog audit) {
    this.audit = audit;
  }

  /** Connects to all robots. */
  public static RobotSessions open(WebConfig config, AuditLog audit) throws IOException {
    RobotSessions all = new RobotSessions(audit);
    try {
      for (Robot robot : config.robots()) {
        RobotSession session = RobotSession.open(robot, config.opener(), config.readOnly(), audit);
        all.sessions.put(session.name(), session);
        audit.addListener(line -> session.header().send()); // whether it could be written
      }
      return all;
    } catch (IOException | RuntimeException e) {
      all.close();
      throw e;
    }
  }

  /** Returns all robots. */
  public Collection<RobotSession> all() {
    return sessions.values();
  }

  /** Returns the robot that the field {@code robot} of a message names. */
  public RobotSession of(Call call) throws CommandException {
    RobotSession session = sessions.get(call.text("robot"));
    if (session == null) {
      throw new CommandException("the page has no such robot");
    }
    return session;
  }

  /** The lists that one viewer watches, by the robot and the name that the viewer gave the list. */
  private static final class Lists {
    private final Map<String, Hub.Subscription> subscriptions = new HashMap<>();
    private boolean hidden;
    private boolean closed;

    synchronized void put(String key, RobotSession robot, Call call) throws CommandException {
      List<String> names = call.texts("names", MAX_NAMES);
      Duration period = Duration.ofMillis(call.millis("period", 10, 60_000));
      String list = call.text("list");
      remove(key);
      if (subscriptions.size() >= MAX_LISTS) {
        throw new CommandException("a page can have at most " + MAX_LISTS + " lists");
      }
      String head = head(robot, list);
      Viewer viewer = call.viewer();
      Map<String, ReadOutcome> refused = refused(names);
      if (!refused.isEmpty()) {
        Readings none = new Readings(Instant.now(), Duration.ZERO, refused);
        viewer.sendText(key + refused.keySet(), head + none.json() + "}");
      }
      List<String> good = names.stream().filter(it -> !refused.containsKey(Hub.key(it))).toList();
      if (good.isEmpty() || closed) {
        return;
      }
      Hub.Subscription added =
          robot
              .hub()
              .subscribe(
                  good,
                  period,
                  readings ->
                      // readings of other periods have other variables: they do not replace these
                      viewer.sendText(
                          key + readings.values().keySet(), head + readings.json() + "}"));
      if (hidden) {
        added.pause(true);
      }
      subscriptions.put(key, added);
    }

    /**
     * Returns the names that cannot be those of variables, each with the reason in place of a
     * value, so that the page shows the reason there and reads the others.
     */
    private static Map<String, ReadOutcome> refused(List<String> names) {
      Map<String, ReadOutcome> refused = new TreeMap<>();
      for (String name : names) {
        try {
          Hub.checkName(name);
        } catch (IllegalArgumentException e) {
          String reason = String.valueOf(e.getMessage());
          refused.put(Hub.key(name), new ReadOutcome(null, reason, false));
        }
      }
      return refused;
    }

    /** Returns the beginning of an event, up to its readings. */
    private static String head(RobotSession robot, String list) {
      String event = Json.event("samples").put("robot", robot.name()).put("list", list).toString();
      return event.substring(0, event.length() - 1) + ",";
    }

    synchronized void remove(String key) {
      Hub.Subscription old = subscriptions.remove(key);
      if (old != null) {
        old.close();
      }
    }

    synchronized void hide(boolean value) {
      hidden = value;
      subscriptions.values().forEach(one -> one.pause(value));
    }

    synchronized void close() {
      closed = true;
      subscriptions.values().forEach(Hub.Subscription::close);
      subscriptions.clear();
    }
  }

  /** Shows the headers of all robots to a viewer. */
  public void show(Viewer viewer) {
    Lists own = new Lists();
    lists.put(viewer, own);
    viewer.atClose(
        () -> {
          lists.remove(viewer);
          own.close();
          sessions.values().forEach(robot -> robot.lock().cancelRefused());
        });
    sessions.values().forEach(robot -> robot.header().show(viewer));
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.addQuick("ping", Role.VIEW, (call, answer) -> {});
    commands.addQuick(
        "who",
        Role.VIEW,
        (call, answer) -> {
          answer.put("id", call.viewer().id());
          answer.put("name", call.viewer().name()).put("role", call.viewer().role().name());
          sessions.keySet().forEach(answer.putArray("robots")::add);
        });
    commands.addQuick("watch", Role.VIEW, (call, answer) -> watch(call));
    commands.addQuick("unwatch", Role.VIEW, (call, answer) -> lists(call).remove(key(call)));
    commands.addQuick("visible", Role.VIEW, (call, answer) -> setVisible(call));
    commands.addQuick("withdraw", Role.OPERATE, (call, answer) -> withdraw(call));
    commands.addQuick("lock", Role.OPERATE, (call, answer) -> setLock(call));
  }

  private Lists lists(Call call) throws CommandException {
    Lists own = lists.get(call.viewer());
    if (own == null) {
      throw new CommandException("the socket is closed");
    }
    return own;
  }

  private static String key(Call call) throws CommandException {
    return "samples/" + call.text("robot") + "/" + call.text("list");
  }

  private void watch(Call call) throws CommandException {
    lists(call).put(key(call), of(call), call);
  }

  private void setVisible(Call call) throws CommandException {
    boolean hidden = !call.flag("visible");
    lists(call).hide(hidden);
    sessions.values().forEach(robot -> robot.header().pause(call.viewer(), hidden));
  }

  /** Cancels the changes that the page has sent and that still wait. */
  private void withdraw(Call call) {
    call.viewer().withdraw();
    sessions.values().forEach(robot -> robot.lock().cancelRefused());
  }

  private void setLock(Call call) throws IOException {
    RobotSession robot = of(call);
    boolean locked = call.flag("locked");
    String who = call.viewer().name();
    if (locked) {
      robot.lock().close();
    } else {
      call.checkAge();
      robot.lock().open(who);
    }
    audit.add(
        new AuditLog.Entry(who, robot.name(), locked ? "lock" : "unlock", "", "", "", "done"));
    robot.header().send();
  }

  @Override
  public void close() throws IOException {
    IOException failure = null;
    for (RobotSession robot : sessions.values()) {
      try {
        robot.close();
      } catch (IOException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
