package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.program.Builtin.Call;
import no.hials.crosscom.simulator.internal.program.Builtin.Kind;
import org.jspecify.annotations.Nullable;

/** The routines that show messages (docs/reference/krl-language.md#messages). */
final class MessageBuiltins {
  private static final String MESSAGE = "SET_KRLMSG";
  private static final String DIALOGUE = "SET_KRLDLG";

  /** The argument with a KRLMSGOPT_T. */
  private static final int OPTIONS = 3;

  private static final int PARAMETERS = 3;
  private static final int KEYS = 7;
  private static final KrlInt FAILED = new KrlInt(-1);

  /** All of them. */
  static final List<Builtin> ALL =
      List.of(
          new Builtin(
              MESSAGE,
              true,
              List.of(Kind.VALUE, Kind.VALUE, Kind.OUT, Kind.VALUE),
              2,
              MessageBuiltins::message),
          new Builtin(
              DIALOGUE,
              true,
              List.of(Kind.VALUE, Kind.OUT, Kind.OUT, Kind.VALUE),
              1,
              MessageBuiltins::dialogue),
          new Builtin(
              "EXISTS_KRLMSG",
              true,
              List.of(Kind.VALUE),
              0,
              call -> new KrlBool(window(call).exists(number(call, 0)))),
          new Builtin(
              "EXISTS_KRLDLG",
              true,
              List.of(Kind.VALUE, Kind.OUT),
              0,
              MessageBuiltins::existsDialogue),
          new Builtin(
              "CLEAR_KRLMSG",
              true,
              List.of(Kind.VALUE),
              0,
              call -> new KrlBool(window(call).clear(number(call, 0)))),
          new Builtin(
              "SET_KRLDLGANSWER",
              true,
              List.of(Kind.VALUE, Kind.VALUE),
              0,
              call -> new KrlBool(window(call).answer(number(call, 0), number(call, 1)))),
          // for the built-in MsgLoop
          new Builtin(
              "KSS_LOOP_MESSAGE",
              true,
              List.of(Kind.VALUE),
              0,
              call -> new KrlInt(window(call).exchangeLoop(number(call, 0)))),
          new Builtin("GET_MSGBUFFER", true, List.of(Kind.OUT), 0, MessageBuiltins::buffer));

  private MessageBuiltins() {}

  private static MessageWindow window(Call call) {
    return call.machine().environment().messages();
  }

  private static int number(Call call, int at) throws KrlExecutionException {
    return Operators.intOf(call.value(at));
  }

  private static KrlValue message(Call call) throws KrlExecutionException {
    if (!(call.value(0) instanceof KrlEnum constant)) {
      throw Operators.wrongType("a type of message", call.value(0));
    }
    ProgramMessage.Type type;
    try {
      type = ProgramMessage.Type.valueOf(constant.name().toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw Operators.wrongType("#NOTIFY, #STATE, #QUIT or #WAITING", constant);
    }
    return show(call, type, call.value(1), List.of());
  }

  private static KrlValue dialogue(Call call) throws KrlExecutionException {
    List<String> keys = new ArrayList<>();
    for (int i = 1; i <= KEYS; i++) {
      KrlStruct key = element(call, 2, i);
      keys.add(key == null || isEmpty(key, "SK_TYPE") ? "" : text(key, "SK_TXT"));
    }
    while (!keys.isEmpty() && keys.get(keys.size() - 1).isEmpty()) {
      keys.remove(keys.size() - 1);
    }
    if (keys.isEmpty()) {
      return FAILED; // nobody could answer it
    }
    return show(call, ProgramMessage.Type.DIALOGUE, call.value(0), keys);
  }

  private static KrlValue show(
      Call call, ProgramMessage.Type type, KrlValue message, List<String> keys)
      throws KrlExecutionException {
    int parametersAt = type == ProgramMessage.Type.DIALOGUE ? 1 : 2;
    if (!(message instanceof KrlStruct struct)) {
      throw Operators.wrongType("a KRLMSG_T", message);
    }
    String text = text(struct, "MSG_TXT");
    for (int i = 1; i <= PARAMETERS; i++) {
      KrlStruct parameter = element(call, parametersAt, i);
      text = text.replace("%" + i, parameter == null ? "" : shown(parameter));
    }
    KrlValue number = struct.get("NR").orElse(new KrlInt(0));
    return new KrlInt(
        window(call)
            .show(
                call.machine().kind(),
                new ProgramMessage(
                    type,
                    Operators.intOf(number),
                    text(struct, "MODUL").strip(),
                    text,
                    keys,
                    option(call.arguments().get(OPTIONS), "CLEAR_P_RESET", true),
                    option(call.arguments().get(OPTIONS), "CLEAR_P_SAW", false))));
  }

  /** Shows a notification of the controller. */
  static void notify(Call call, String text) {
    window(call)
        .show(
            call.machine().kind(),
            new ProgramMessage(ProgramMessage.Type.NOTIFY, 0, "", text, List.of(), true, false));
  }

  /** Returns whether a call shows a message; its options are then the last argument. */
  static boolean shows(Builtin builtin) {
    return builtin.name().equals(MESSAGE) || builtin.name().equals(DIALOGUE);
  }

  /** Waits for the end of the motions if the options, last on the stack, say so. */
  static void await(KrlVirtualMachine machine) {
    if (option(machine.peek(), "VL_STOP", false)) {
      machine.awaitMotion();
    }
  }

  /** Returns a component of a KRLMSGOPT_T; the values of omitted ones are assumed. */
  private static boolean option(@Nullable Object options, String name, boolean omitted) {
    if (options instanceof KrlStruct struct
        && struct.get(name).orElse(null) instanceof KrlBool given) {
      return given.value();
    }
    return omitted;
  }

  /** Returns an element of an array argument; null if it is omitted or has no value. */
  private static @Nullable KrlStruct element(Call call, int at, int index) {
    if (!(call.arguments().get(at) instanceof Reference reference)) {
      return null;
    }
    try {
      return reference.whole().value(VariablePath.element("VALUE", index)) instanceof KrlStruct it
          ? it
          : null;
    } catch (RefusedException e) {
      return null;
    }
  }

  private static boolean isEmpty(KrlStruct struct, String type) {
    return struct.get(type).orElse(null) instanceof KrlEnum constant
        && constant.name().equalsIgnoreCase("EMPTY");
  }

  private static String text(KrlStruct struct, String field) {
    return struct.get(field + "[]").orElse(null) instanceof KrlString string ? string.text() : "";
  }

  /** The last component with a value: a text, a number or a truth value. */
  private static String shown(KrlStruct parameter) {
    if (isEmpty(parameter, "PAR_TYPE")) {
      return "";
    }
    List<KrlStruct.Field> fields = new ArrayList<>(parameter.fields());
    Collections.reverse(fields);
    for (KrlStruct.Field field : fields) {
      if (!field.name().equalsIgnoreCase("PAR_TYPE")) {
        return field.value() instanceof KrlString string
            ? string.text()
            : field.value().printShort();
      }
    }
    return "";
  }

  private static KrlValue existsDialogue(Call call) throws KrlExecutionException {
    int handle = number(call, 0);
    int answer = window(call).takeAnswer(handle);
    if (answer > 0) {
      call.reference(1).write(new KrlInt(answer));
    }
    return new KrlBool(window(call).exists(handle));
  }

  /** Fills an array of MSGBUF_T with the messages that are shown; returns their number. */
  private static KrlValue buffer(Call call) throws KrlExecutionException {
    int count = 0;
    for (Map.Entry<Integer, ProgramMessage> entry : window(call).shown().entrySet()) {
      ProgramMessage message = entry.getValue();
      KrlStruct struct =
          new KrlStruct(
              null,
              List.of(
                  new KrlStruct.Field("TYPE", new KrlEnum(bufferType(message.type()))),
                  new KrlStruct.Field("NR", new KrlInt(message.number())),
                  new KrlStruct.Field("MODUL[]", new KrlString(message.module())),
                  new KrlStruct.Field("MSG_TXT[]", new KrlString(message.text())),
                  new KrlStruct.Field("HANDLE", new KrlInt(entry.getKey()))));
      try {
        call.reference(0).whole().store(VariablePath.element("VALUE", count + 1), struct);
      } catch (RefusedException e) {
        break; // the array is full
      }
      count++;
    }
    return new KrlInt(count);
  }

  private static String bufferType(ProgramMessage.Type type) {
    return switch (type) {
      case QUIT -> "USR_QUIT";
      case WAITING -> "USR_WAIT";
      case DIALOGUE -> "USR_DLG";
      case STATE, NOTIFY -> "USR_STATE";
    };
  }
}
