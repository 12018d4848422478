package no.hials.crosscom.control;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.VariableResult;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes the variables of a loop. Several variables are one message to C3 Bridge and one
 * message each to KUKAVARPROXY.
 */
final class Channel {
  private static final String MODE = "$MODE_OP";
  private static final String PROGRAM = "$PRO_STATE1";
  private static final String RUNNING = "#P_ACTIVE";

  final KRLE6Pos position = new KRLE6Pos("$POS_ACT");
  final KRLE6Axis axes = KRLVariable.AXIS_ACT();
  final KRLEnum mode = new KRLEnum(MODE);
  final KRLEnum program = new KRLEnum(PROGRAM);
  final KRLInt override = new KRLInt("$OV_PRO");
  private final CrossComClient client;
  private final BooleanSupplier writeIf;

  Channel(CrossComClient client) {
    this(client, () -> true);
  }

  /**
   * @param writeIf whether the next write is allowed, unless it ends the loop
   */
  Channel(CrossComClient client, BooleanSupplier writeIf) {
    this.client = client;
    this.writeIf = writeIf;
  }

  void read(KRLVariable variable) throws ControlRefusedException {
    try {
      client.readVariable(variable);
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** Reads variables. */
  void read(List<KRLVariable> variables) throws ControlRefusedException {
    if (variables.size() == 1) {
      read(variables.get(0));
    } else {
      require(client.readVariables(variables));
    }
  }

  /** Returns whether the server reads several variables in one message. */
  boolean readsTogether() throws ControlRefusedException {
    try {
      return client.getServer().knows(MessageType.READ_MULTIPLE);
    } catch (IOException e) {
      throw failed(e);
    }
  }

  void write(KRLVariable variable) throws ControlRefusedException {
    checkWrite();
    writeLast(variable);
  }

  private void checkWrite() throws ControlRefusedException {
    if (!writeIf.getAsBoolean()) {
      throw new ControlRefusedException(StopKind.ASKED, "the loop was not allowed to write");
    }
  }

  /** Writes a variable at the end of a loop, which is always allowed. */
  void writeLast(KRLVariable variable) throws ControlRefusedException {
    try {
      client.writeVariable(variable);
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** Writes one or two variables, in this order. */
  void write(KRLVariable variable, @Nullable KRLVariable other) throws ControlRefusedException {
    if (other == null) {
      write(variable);
    } else {
      checkWrite();
      require(client.writeVariables(List.of(variable, other)));
    }
  }

  private static void require(List<VariableResult> results) throws ControlRefusedException {
    for (VariableResult result : results) {
      if (result.failure() != null) {
        throw failed(result.failure());
      }
    }
  }

  private static ControlRefusedException failed(Exception e) {
    return new ControlRefusedException(
        new StopReason(StopKind.ACCESS, Objects.requireNonNull(e.getMessage()), e));
  }

  int readInt(String name) throws ControlRefusedException {
    KRLInt variable = new KRLInt(name);
    read(variable);
    return variable.intValue();
  }

  void writeInt(String name, int value) throws ControlRefusedException {
    KRLInt variable = new KRLInt(name);
    variable.setValue(value);
    write(variable);
  }

  /** Returns the last position read. */
  Frame frame() throws ControlRefusedException {
    try {
      return position.toFrame();
    } catch (IllegalStateException e) {
      throw failed(e);
    }
  }

  /** Returns the last axis positions read. */
  Axis joints() throws ControlRefusedException {
    try {
      return axes.toAxis();
    } catch (IllegalStateException e) {
      throw failed(e);
    }
  }

  /**
   * Returns the factor of increments for the last override read, 0 to 1. The simulated robot is
   * nearly as fast with the square root as without a factor, and stands much sooner; with the
   * override itself it is four times slower at 10 %.
   */
  double incrementFactor() {
    return Math.sqrt(Math.max(0, Math.min(100, override.intValue())) / 100.0);
  }

  /** Reads the software limits of the controller's axes. */
  AxisLimits readAxisLimits() throws ControlRefusedException {
    Axis minimum = readSix("$SOFTN_END[]");
    Axis maximum = readSix("$SOFTP_END[]");
    try {
      return new AxisLimits(minimum, maximum);
    } catch (IllegalArgumentException e) {
      throw new ControlRefusedException(
          StopKind.ACCESS, "$SOFTN_END and $SOFTP_END: " + e.getMessage());
    }
  }

  private Axis readSix(String name) throws ControlRefusedException {
    KRLRealArray array = new KRLRealArray(name);
    read(array);
    double[] values = array.getValue();
    if (values == null || values.length < 6) {
      throw new ControlRefusedException(
          StopKind.ACCESS,
          name + " must have at least 6 elements, has " + (values == null ? 0 : values.length));
    }
    return new Axis(values[0], values[1], values[2], values[3], values[4], values[5]);
  }

  /** Checks that the last mode read is allowed. */
  void checkMode(Safety safety) throws ControlRefusedException {
    String found = mode.stringValue();
    for (OperatingMode allowed : safety.modes()) {
      if (found.substring(1).toUpperCase(Locale.ROOT).equals(allowed.constant())) {
        return;
      }
    }
    throw new ControlRefusedException(
        StopKind.MODE,
        MODE + " must be one of " + safety.modes().stream().sorted().toList() + ", is " + found);
  }

  /** Checks that the robot program was running when last read. */
  void checkProgram() throws ControlRefusedException {
    String found = program.stringValue();
    if (!found.equalsIgnoreCase(RUNNING)) {
      throw new ControlRefusedException(
          StopKind.PROGRAM, PROGRAM + " must be " + RUNNING + ", is " + found);
    }
  }
}
