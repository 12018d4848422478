package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.web.Role;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The commands of pages by their names. Handlers are added before the first socket is open.
 *
 * <p>Each answer contains the time of the server. A command that changes something contains the
 * latest time that its page received, and does not run if that time is too old: a command that was
 * delayed by the network or by a frozen server must not run after its page has given up.
 */
public final class Commands {
  private static final Logger LOG = LoggerFactory.getLogger(Commands.class);

  private final Map<String, Entry> entries = new ConcurrentHashMap<>();

  /**
   * A command and its requirements.
   *
   * @param role the role that may call it
   * @param urgency when it runs, and in which thread
   */
  private record Entry(Role role, Urgency urgency, Command command) {}

  /** When a command runs. */
  enum Urgency {
    /** After the earlier commands of its viewer. */
    IN_ORDER,
    /** At once, in its own thread. */
    OVERTAKING,
    /** At once, in the thread of the socket. */
    QUICK
  }

  /**
   * Adds a command that may wait for a robot or a file. One viewer's commands run in order. A
   * command for a higher role than {@link Role#VIEW} changes something, and needs a recent time.
   */
  public void add(String name, Role role, Command command) {
    put(name, new Entry(role, Urgency.IN_ORDER, command));
  }

  /**
   * Adds a command that never waits. It runs at once, even while other commands of the viewer wait,
   * and however old it is.
   */
  public void addQuick(String name, Role role, Command command) {
    put(name, new Entry(role, Urgency.QUICK, command));
  }

  /**
   * Adds a command that may wait for a robot or a file, but not for earlier commands of the viewer,
   * such as one that stops something. It runs however old it is.
   */
  public void addOvertaking(String name, Role role, Command command) {
    put(name, new Entry(role, Urgency.OVERTAKING, command));
  }

  private void put(String name, Entry entry) {
    if (entries.put(name, entry) != null) {
      throw new IllegalArgumentException("there are two commands " + name);
    }
  }

  /** Returns when the command of a message runs; one that does not exist is answered at once. */
  Urgency urgency(JsonNode message) {
    Entry entry = entry(message);
    return entry == null ? Urgency.QUICK : entry.urgency;
  }

  private @Nullable Entry entry(JsonNode message) {
    JsonNode name = message.get("do");
    return name == null || !name.isTextual() ? null : entries.get(name.textValue());
  }

  /** Runs the command of a message and returns the answer. */
  ObjectNode answer(Viewer viewer, JsonNode message) {
    ObjectNode answer = run(viewer, message);
    // the time of the end: a page that sends its next command has seen what happened before
    return answer.put("clock", Call.now());
  }

  private ObjectNode run(Viewer viewer, JsonNode message) {
    ObjectNode answer = Json.object();
    answer.set("id", message.path("id").isIntegralNumber() ? message.get("id") : Json.NULL);
    Entry entry = entry(message);
    if (entry == null) {
      return answer.put("error", "there is no such command");
    }
    if (!viewer.role().includes(entry.role)) {
      return answer.put(
          "error",
          "this needs the role " + entry.role + "; this browser may only " + viewer.role());
    }
    ObjectNode result = Json.object();
    Call call = new Call(viewer, message);
    try {
      if (entry.urgency == Urgency.IN_ORDER && entry.role != Role.VIEW) {
        call.checkAge();
      }
      entry.command.run(call, result);
      answer.set("ok", result);
    } catch (IOException | IllegalArgumentException e) {
      answer.put("error", String.valueOf(e.getMessage()));
    } catch (RuntimeException e) {
      LOG.warn("a command of the page failed: {}", message.get("do"), e);
      answer.put("error", "internal error: " + e);
    }
    return answer;
  }
}
