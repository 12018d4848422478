package no.hials.crosscom.cli.shell;

import java.io.IOException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.protocol.value.PrintableText;

/** The text before a typed line: the robot, whether it is read-only, and its mode unless T1. */
final class ShellPrompt {
  private static final String MODE = "$MODE_OP";
  private static final String SAFE_MODE = "#T1";

  private final RobotConnection controller;
  private final String name;
  private boolean connected = true;

  ShellPrompt(RobotConnection controller, boolean readOnly) {
    this.controller = controller;
    Robot target = controller.robot();
    String host = target.host();
    String robot = !target.name().isEmpty() ? target.name() : host == null ? "mock" : host;
    name = readOnly ? robot + " (read-only)" : robot;
  }

  /** Notes how a line ended: if the connection was lost, the next line connects again. */
  void ended(ExitCode code) {
    connected = code != ExitCode.LOST && code != ExitCode.NOT_CONNECTED;
  }

  String name() {
    return name;
  }

  /** Returns the mode, empty for T1 and if it is not known. */
  String mode() {
    if (!connected) {
      return "";
    }
    try {
      String mode = controller.client().readText(MODE);
      return mode.equalsIgnoreCase(SAFE_MODE) ? "" : PrintableText.of(mode);
    } catch (IOException e) {
      return "";
    }
  }
}
