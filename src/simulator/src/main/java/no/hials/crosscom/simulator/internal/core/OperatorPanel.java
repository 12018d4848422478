package no.hials.crosscom.simulator.internal.core;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/** The key switch, the emergency stop and the message window of the pendant. */
final class OperatorPanel {
  private static final VariablePath OV_PRO = SystemVariableAccess.path("$OV_PRO");
  private static final VariablePath T2_OV_REDUCE = SystemVariableAccess.path("$T2_OV_REDUCE");

  /** The override after a change to T2 (docs/reference/system-variables.md#override-and-speed). */
  private static final int OVERRIDE_IN_T2 = 10;

  private final SystemVariableAccess access;
  private final LongSupplier time;
  private final MessageWindow messages = new MessageWindow();
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
          MessageWindow.MODE_CHANGED,
          "the operating mode was changed from " + mode + " to " + newMode);
    }
    mode = newMode;
    if (mode == OperatingMode.T2 && access.bool(T2_OV_REDUCE, false)) {
      access.write(OV_PRO, new KrlInt((int) Math.min(OVERRIDE_IN_T2, access.number(OV_PRO, 100))));
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
      show(Message.Kind.ACKNOWLEDGEMENT, MessageWindow.EMERGENCY_STOP, "emergency stop");
    }
    emergency = pressed;
  }

  void show(Message.Kind kind, int number, String text) {
    messages.add(kind, number, text, time.getAsLong());
  }

  boolean stopMessage() {
    return messages.stop();
  }

  List<Message> messages() {
    return messages.list();
  }

  int confirmAll() {
    return messages.confirm();
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
    if (messages.stop()) {
      throw new IllegalStateException(action + ": a message has to be confirmed first");
    }
  }
}
