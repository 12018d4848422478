package no.hials.crosscom.bench;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.VariableTable;

/** The measured operations: the same access as bytes and through the client. */
enum Operation {
  /** Reads {@code $OV_PRO} into an int. */
  READ_INT(false, "$OV_PRO", "50"),
  /** Reads {@code $AXIS_ACT} into numbers. */
  READ_E6AXIS(false, "$AXIS_ACT", Operation.AXES_READ),
  /** Writes {@code $OV_PRO} and reads the value from the answer. */
  WRITE_INT(true, "$OV_PRO", "50"),
  /** Writes an E6AXIS and reads the numbers from the answer. */
  WRITE_E6AXIS(true, Operation.WRITTEN_AXES, Operation.AXES_WRITTEN);

  /** As printed by a KR C4: nine digits where six do not identify the float. */
  static final String AXES_READ =
      "{E6AXIS: A1 5.12345695, A2 -90.1234589, A3 91.2345657, A4 0.00512345601, A5 -45.6789436,"
          + " A6 123.456787, E1 1250.50, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}";

  /** As written by the client. */
  static final String AXES_WRITTEN =
      "{A1 5.123457,A2 -90.12346,A3 91.234566,A4 0.005123456,A5 -45.678944,A6 123.45679,E1 1250.5,"
          + "E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}";

  private static final String WRITTEN_AXES = "BENCH_AXES";

  private final boolean write;
  private final String variable;
  private final String value;

  Operation(boolean write, String variable, String value) {
    this.write = write;
    this.variable = variable;
    this.value = value;
  }

  /** Sets the variables of a mock server to the values in these requests and answers. */
  static void declare(VariableTable variables) {
    variables.set("$OV_PRO", "50");
    variables.set("$AXIS_ACT", AXES_WRITTEN);
    variables.declare(WRITTEN_AXES, "E6AXIS", AXES_WRITTEN);
  }

  /** Returns the bytes of the request, with id 1. */
  byte[] request() {
    return Codec.encode(
        write ? new WriteRequest(1, variable, value) : new ReadRequest(1, variable));
  }

  /** Returns the bytes of the answer, with id 1. */
  byte[] answer() {
    return Codec.encode(
        write
            ? new ValueResponse(1, MessageType.WRITE, value, Tail.SUCCESS)
            : new ValueResponse(1, MessageType.READ, value, Tail.SUCCESS));
  }

  /** Returns the expected result of {@link #through}. */
  double expected() {
    return this == READ_INT || this == WRITE_INT ? 50 : 5.123457;
  }

  /** Returns the access through the client; its result is the number, or the first axis. */
  Exchange through(CrossComClient client) {
    return switch (this) {
      case READ_INT -> {
        KRLInt override = new KRLInt(variable);
        yield () -> {
          client.readVariable(override);
          return override.intValue();
        };
      }
      case READ_E6AXIS -> {
        KRLE6Axis axes = new KRLE6Axis(variable);
        yield () -> {
          client.readVariable(axes);
          return axes.getA1();
        };
      }
      case WRITE_INT -> {
        KRLInt override = new KRLInt(variable);
        yield () -> {
          override.setValue(50);
          client.writeVariable(override);
          return override.intValue();
        };
      }
      case WRITE_E6AXIS -> {
        KRLE6Axis axes = new KRLE6Axis(variable);
        axes.setA1ToA6(5.123457, -90.12346, 91.234566, 0.005123456, -45.678944, 123.45679);
        axes.setE1(1250.5);
        yield () -> {
          client.writeVariable(axes);
          return axes.getA1();
        };
      }
    };
  }
}
