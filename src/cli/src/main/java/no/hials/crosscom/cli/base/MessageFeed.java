package no.hials.crosscom.cli.base;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.Message;
import org.jspecify.annotations.Nullable;

/** Returns the messages of a simulated controller, each once. Not thread-safe. */
public final class MessageFeed {
  private final Controller controller;
  private @Nullable Message lastShown;
  private List<Message> shownStates = List.of();

  public MessageFeed(Controller controller) {
    this.controller = controller;
  }

  /** Returns the messages since the last call; after them the states that are new. */
  public List<Message> poll() {
    List<Message> all = controller.messages();
    List<Message> states = all.stream().filter(MessageFeed::isState).toList();
    List<Message> messages = all.stream().filter(message -> !isState(message)).toList();
    // the controller keeps only the last messages; if the shown ones are gone, all are new
    int from = lastShown == null ? 0 : messages.lastIndexOf(lastShown) + 1;
    List<Message> fresh = new ArrayList<>(messages.subList(from, messages.size()));
    lastShown = messages.isEmpty() ? lastShown : messages.get(messages.size() - 1);
    List<Message> freshStates = new ArrayList<>(states);
    freshStates.removeAll(shownStates);
    shownStates = states;
    fresh.addAll(freshStates);
    return fresh;
  }

  private static boolean isState(Message message) {
    return message.kind() == Message.Kind.STATUS;
  }

  /** Returns a message with its keys. */
  public static String text(Message message) {
    List<String> keys = new ArrayList<>();
    for (int i = 0; i < message.keys().size(); i++) {
      if (!message.keys().get(i).isEmpty()) {
        keys.add((i + 1) + " " + message.keys().get(i));
      }
    }
    return message + (keys.isEmpty() ? "" : " [" + String.join(", ", keys) + "]");
  }
}
