package no.hials.crosscom.simulator.internal.core;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.internal.program.MessageWindow;
import no.hials.crosscom.simulator.internal.program.ProgramMessage;

/** The key switch, the emergency stop and the message window of the pendant. */
final class OperatorPanel {
  // numbers below 9000 are those of KSS (docs/reference/simulated-controller.md#messages)

  /** The operating mode was changed while a program ran. */
  static final int MODE_CHANGED = 1362;

  /** The state message while the emergency stop is pressed. */
  static final int EMERGENCY_STOP = 1;

  /** The message to confirm after an emergency stop. */
  static final int EMERGENCY_STOPPED = 1200;

  /** The machine data describe no robot that can be simulated. */
  static final int OTHER_ROBOT = 9108;

  /** The higher-level controller could not start the program. */
  static final int NOT_STARTED = 9109;

  private static final int KEPT_MESSAGES = 1000;

  /** The override after a change to T2 (docs/reference/system-variables.md#override-and-speed). */
  private static final int OVERRIDE_IN_T2 = 10;

  private final SystemVariableAccess access;
  private final LongSupplier time;
  private final Deque<Message> messages = new ArrayDeque<>();
  private final MessageWindow programs = new MessageWindow(this::show);
  private final Map<Integer, Message> states = new LinkedHashMap<>();
  private int unconfirmed;
  private OperatingMode mode = OperatingMode.T1;
  private boolean emergency;

  OperatorPanel(SystemVariableAccess access, LongSupplier time) {
    this.access = access;
    this.time = time;
  }

  OperatingMode mode() {
    return mode;
  }

  /**
   * Turns the key switch.
   *
   * @param stopRobot stops the robot; returns whether a program was running
   */
  void setMode(OperatingMode newMode, BooleanSupplier stopRobot) {
    if (newMode == mode) {
      return;
    }
    if (stopRobot.getAsBoolean()) {
      show(
          Message.Kind.NOTIFICATION,
          MODE_CHANGED,
          "the operating mode was changed from " + mode + " to " + newMode);
    }
    mode = newMode;
    if (mode == OperatingMode.T2 && access.bool("$T2_OV_REDUCE", false)) {
      access.write(
          "$OV_PRO", new KrlInt((int) Math.min(OVERRIDE_IN_T2, access.number("$OV_PRO", 100))));
    }
  }

  boolean emergency() {
    return emergency;
  }

  /**
   * Presses or releases the emergency stop.
   *
   * @param stopRobot stops the robot; returns whether a program was running
   */
  void emergencyStop(boolean pressed, BooleanSupplier stopRobot) {
    if (pressed && !emergency) {
      boolean unused = stopRobot.getAsBoolean();
      show(Message.Kind.ACKNOWLEDGEMENT, EMERGENCY_STOPPED, "emergency stop");
    }
    if (pressed != emergency) {
      state(pressed, EMERGENCY_STOP, "the emergency stop is pressed");
    }
    emergency = pressed;
  }

  void show(Message.Kind kind, int number, String text) {
    show(kind, number, text, List.of(), 0);
    unconfirmed += kind == Message.Kind.ACKNOWLEDGEMENT ? 1 : 0;
  }

  private void show(ProgramMessage message, int handle) {
    Message.Kind kind =
        switch (message.type()) {
          case NOTIFY -> Message.Kind.NOTIFICATION;
          case STATE, WAITING -> Message.Kind.STATUS;
          case QUIT -> Message.Kind.ACKNOWLEDGEMENT;
          case DIALOGUE -> Message.Kind.DIALOGUE;
        };
    show(kind, message.number(), message.fullText(), message.keys(), handle);
  }

  private void show(Message.Kind kind, int number, String text, List<String> keys, int handle) {
    if (messages.size() == KEPT_MESSAGES) {
      messages.removeFirst();
    }
    messages.addLast(
        new Message(kind, number, text, Duration.ofMillis(time.getAsLong()), keys, handle));
  }

  /** Returns the messages of programs. */
  MessageWindow programs() {
    return programs;
  }

  /** Returns the oldest dialogue that is shown, unless its message is no longer kept. */
  Optional<Message> dialogue() {
    return programs
        .dialogue()
        .flatMap(
            shown -> messages.stream().filter(it -> it.handle() == shown.getKey()).findFirst());
  }

  /**
   * Presses a key of a dialogue, if it is the oldest.
   *
   * @param key its number, from 1
   */
  void answer(Message dialogue, int key) {
    if (programs.dialogue().filter(it -> it.getKey() == dialogue.handle()).isEmpty()) {
      throw new IllegalStateException("answer: this dialogue is no longer shown");
    }
    answer(key);
  }

  /**
   * Presses a key of the oldest dialogue.
   *
   * @param key its number, from 1
   */
  void answer(int key) {
    Map.Entry<Integer, ProgramMessage> shown =
        programs
            .dialogue()
            .orElseThrow(() -> new IllegalStateException("answer: no dialogue is shown"));
    if (!programs.answer(shown.getKey(), key)) {
      throw new IllegalArgumentException(
          "answer: the dialogue has the keys "
              + shown.getValue().keys()
              + ", was given number "
              + key);
    }
  }

  /** Shows a state message, or removes it when its state has ended. */
  void state(boolean present, int number, String text) {
    if (present) {
      Duration now = Duration.ofMillis(time.getAsLong());
      states.put(number, new Message(Message.Kind.STATUS, number, text, now, List.of(), 0));
    } else {
      states.remove(number);
    }
  }

  /** Returns whether a message has to be confirmed. */
  boolean stopMessage() {
    return unconfirmed + programs.unconfirmed() > 0;
  }

  List<Message> messages() {
    List<Message> all = new ArrayList<>(messages);
    all.addAll(states.values());
    return List.copyOf(all);
  }

  int confirmAll() {
    int confirmed = unconfirmed + programs.unconfirmed();
    unconfirmed = 0;
    programs.confirmAll();
    return confirmed;
  }

  /** Checks that the start key, or else the higher-level controller, works in this mode. */
  void requireStart(boolean external) {
    if (external != (mode == OperatingMode.EXT)) {
      throw new IllegalStateException(
          external
              ? "start: the external start works in EXT only, the mode is " + mode
              : "start: in EXT only the external start works");
    }
  }

  /** Checks that neither the emergency stop nor a message stops the robot. */
  void requireReleased(String action) {
    if (emergency) {
      throw new IllegalStateException(action + ": the emergency stop is pressed");
    }
    if (stopMessage()) {
      throw new IllegalStateException(action + ": a message has to be confirmed first");
    }
  }
}
