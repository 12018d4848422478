package no.hials.crosscom.simulator.internal.program;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.ObjIntConsumer;
import no.hials.crosscom.protocol.code.Interpreter;

/**
 * The messages of programs that are shown now, by the handles that programs have
 * (docs/reference/krl-language.md#messages). Not thread-safe.
 */
public final class MessageWindow {
  /** The maximum number of messages at a time, so that a loop cannot fill the memory (assumed). */
  private static final int MAX_SHOWN = 100;

  private record Shown(Interpreter owner, ProgramMessage message) {}

  private record Answer(Interpreter owner, int key) {}

  private final ObjIntConsumer<ProgramMessage> shownListener;
  private final Map<Integer, Shown> open = new LinkedHashMap<>();

  /** The answers that no program has read yet, by handle. */
  private final Map<Integer, Answer> answers = new HashMap<>();

  private int last;

  /** The handle of the message of MsgLoop; 0 without one. */
  private int loop;

  /**
   * @param shownListener called for each new message, with its handle
   */
  public MessageWindow(ObjIntConsumer<ProgramMessage> shownListener) {
    this.shownListener = shownListener;
  }

  /** Shows a message; returns its handle, or -1 if there are too many. */
  int show(Interpreter owner, ProgramMessage message) {
    boolean stays = message.type() != ProgramMessage.Type.NOTIFY;
    if (stays && open.size() >= MAX_SHOWN) {
      return -1;
    }
    last++;
    if (stays) {
      open.put(last, new Shown(owner, message));
    }
    shownListener.accept(message, last);
    return last;
  }

  /** Sets the handle of the message of MsgLoop; returns the old one. */
  int exchangeLoop(int handle) {
    int old = loop;
    loop = handle;
    return old;
  }

  boolean exists(int handle) {
    return open.containsKey(handle);
  }

  /** Removes a message; returns false if it is not shown. */
  boolean clear(int handle) {
    return open.remove(handle) != null;
  }

  /** Returns the answer to a dialogue, from 1, once; 0 without one. */
  int takeAnswer(int handle) {
    Answer answer = answers.remove(handle);
    return answer == null ? 0 : answer.key();
  }

  /** Answers a dialogue; returns false if it is not shown or has no such key. */
  public boolean answer(int handle, int key) {
    Shown shown = open.get(handle);
    if (shown == null
        || key < 1
        || key > shown.message().keys().size()
        || shown.message().keys().get(key - 1).isEmpty()) {
      return false;
    }
    open.remove(handle);
    answers.put(handle, new Answer(shown.owner(), key));
    return true;
  }

  /** Returns the handles and messages that are shown, the oldest first. */
  Map<Integer, ProgramMessage> shown() {
    Map<Integer, ProgramMessage> all = new LinkedHashMap<>();
    open.forEach((handle, shown) -> all.put(handle, shown.message()));
    return all;
  }

  /** Removes the messages and answers of a program that is reset or deselected. */
  void forget(Interpreter owner) {
    open.values().removeIf(shown -> shown.owner() == owner && shown.message().clearedByReset());
    answers.values().removeIf(answer -> answer.owner() == owner);
  }

  /** Removes the messages of a program that continues at another line. */
  void lineSelected(Interpreter owner) {
    open.values()
        .removeIf(shown -> shown.owner() == owner && shown.message().clearedByBlockSelection());
  }

  /** Confirms the messages with a number, or the one with a handle; 0 for all (assumed). */
  void confirm(int number) {
    open.entrySet()
        .removeIf(
            entry ->
                entry.getValue().message().type() == ProgramMessage.Type.QUIT
                    && (number == 0
                        || entry.getKey() == number
                        || entry.getValue().message().number() == number));
  }

  // for the operator

  /** Confirms all messages that can be confirmed. */
  public void confirmAll() {
    confirm(0);
  }

  /** Returns the number of messages that have to be confirmed. */
  public int unconfirmed() {
    return (int)
        open.values().stream()
            .filter(shown -> shown.message().type() == ProgramMessage.Type.QUIT)
            .count();
  }

  /** Returns the handle and the message of the oldest dialogue that is shown. */
  public Optional<Map.Entry<Integer, ProgramMessage>> dialogue() {
    return shown().entrySet().stream()
        .filter(entry -> entry.getValue().type() == ProgramMessage.Type.DIALOGUE)
        .findFirst();
  }
}
