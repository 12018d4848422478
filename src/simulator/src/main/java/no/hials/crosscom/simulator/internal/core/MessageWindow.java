package no.hials.crosscom.simulator.internal.core;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import no.hials.crosscom.simulator.Message;

/** The message window of the pendant: the last messages, and those that wait to be confirmed. */
final class MessageWindow {
  // the numbers are this simulation's own, as are those of the interpreter and of motions: KSS's
  // are not known

  /** The operating mode was changed while a program ran. */
  static final int MODE_CHANGED = 9104;

  /** The emergency stop was pressed. */
  static final int EMERGENCY_STOP = 9105;

  /** The simulation itself has failed. */
  static final int FAILED = 9107;

  private static final int KEPT = 1000;

  private final Deque<Message> all = new ArrayDeque<>();
  private int unconfirmed;

  void add(Message message) {
    if (all.size() == KEPT) {
      all.removeFirst();
    }
    all.addLast(message);
    if (message.kind() == Message.Kind.ACKNOWLEDGEMENT) {
      unconfirmed++;
    }
  }

  void add(Message.Kind kind, int number, String text, long millis) {
    add(new Message(kind, number, text, Duration.ofMillis(millis)));
  }

  boolean stop() {
    return unconfirmed > 0;
  }

  int confirm() {
    int confirmed = unconfirmed;
    unconfirmed = 0;
    return confirmed;
  }

  List<Message> list() {
    return List.copyOf(all);
  }
}
