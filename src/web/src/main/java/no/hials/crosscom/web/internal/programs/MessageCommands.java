package no.hials.crosscom.web.internal.programs;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Changes;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;

/**
 * Shows and confirms messages. Only simulated robots send the texts of messages and accept answers
 * to dialogues; no server does.
 */
public final class MessageCommands {
  private static final int MAX_MESSAGES = 50;
  private static final int MAX_KEYS = 16;

  private final RobotSessions robots;
  private final Changes changes;

  public MessageCommands(RobotSessions robots, AuditLog audit) {
    this.robots = robots;
    this.changes = new Changes(audit);
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("messages", Role.VIEW, this::show);
    commands.add("confirm", Role.OPERATE, (call, answer) -> confirm(call));
    commands.add("answer", Role.OPERATE, (call, answer) -> answer(call));
  }

  /** Answers with the last messages, the newest first, and the open dialogue. */
  private void show(Call call, ObjectNode answer) throws CommandException {
    Optional<Controller> simulated = robots.of(call).simulation().map(MockServer::controller);
    answer.put("known", simulated.isPresent());
    if (simulated.isPresent()) {
      Controller controller = simulated.get();
      ArrayNode list = answer.putArray("messages");
      List<Message> all = controller.messages();
      for (int i = all.size() - 1; i >= Math.max(0, all.size() - MAX_MESSAGES); i--) {
        write(all.get(i), list.addObject());
      }
      controller.dialogue().ifPresent(it -> write(it, answer.putObject("dialogue")));
    }
  }

  private static void write(Message message, ObjectNode json) {
    json.put("kind", message.kind().name().toLowerCase(Locale.ROOT));
    json.put("number", message.number());
    json.put("text", message.text());
    json.put("seconds", message.time().toMillis() / 1000.0);
    json.put("handle", message.handle());
    message.keys().forEach(json.putArray("keys")::add);
  }

  private void confirm(Call call) throws IOException {
    RobotSession robot = robots.of(call);
    changes.make(
        call,
        robot,
        "confirm",
        "all messages",
        "",
        () -> {
          robot.lock().check(call, "confirm all messages");
          Optional<MockServer> simulated = robot.simulation();
          if (simulated.isPresent() && !robot.isBridge()) {
            int unused = simulated.get().controller().confirmAll();
          } else {
            robot
                .lock()
                .send(
                    call,
                    "confirm all messages",
                    sendIf ->
                        robot
                            .client()
                            .asyncRun(client -> client.information().confirmAll(), sendIf));
          }
        });
  }

  private void answer(Call call) throws IOException {
    RobotSession robot = robots.of(call);
    int handle = (int) call.number("dialogue", 1, Integer.MAX_VALUE);
    int key = (int) call.number("key", 1, MAX_KEYS);
    Optional<Controller> simulated = robot.simulation().map(MockServer::controller);
    Optional<Message> dialogue =
        simulated.flatMap(Controller::dialogue).filter(it -> it.handle() == handle);
    changes.make(
        call,
        robot,
        "answer",
        dialogue.map(Message::text).orElse("a dialogue"),
        dialogue
            .map(Message::keys)
            .filter(keys -> key <= keys.size())
            .map(keys -> key + " " + keys.get(key - 1))
            .orElse(Integer.toString(key)),
        () -> {
          robot.lock().check(call, "answer the dialogue");
          if (simulated.isEmpty()) {
            throw new CommandException(
                "no server takes answers to dialogues: answer on the pendant");
          }
          if (dialogue.isEmpty()) { // answered meanwhile
            throw new CommandException("this dialogue is no longer shown");
          }
          simulated.get().answer(dialogue.get(), key);
        });
  }
}
