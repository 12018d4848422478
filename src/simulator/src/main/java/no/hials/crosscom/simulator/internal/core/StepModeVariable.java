package no.hials.crosscom.simulator.internal.core;

import no.hials.crosscom.protocol.value.KrlEnum;

/** Keeps {@code $PRO_MODE}, which is that of the robot interpreter, equal to {@code $PRO_MODE1}. */
final class StepModeVariable {
  private static final String SHOWN = "$PRO_MODE";
  private static final String OF_ROBOT = "$PRO_MODE1";
  private static final String RUN = "GO";

  private final SystemVariableAccess access;
  private String value = RUN;

  StepModeVariable(SystemVariableAccess access) {
    this.access = access;
  }

  /** Returns the constant, without {@code #}. */
  String value() {
    return value;
  }

  /** Reads both variables, of which a client or a program may have written one. */
  void cycle() {
    String ofRobot = access.constant(OF_ROBOT, RUN);
    String shown = access.constant(SHOWN, ofRobot);
    String next = ofRobot.equals(value) ? shown : ofRobot;
    value = next;
    set(OF_ROBOT, ofRobot);
    set(SHOWN, shown);
  }

  private void set(String name, String present) {
    if (!present.equals(value)) {
      access.write(name, new KrlEnum(value));
    }
  }
}
