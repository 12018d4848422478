package no.hials.crosscom.gateway.internal.opcua;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.KrlVisitor;
import org.eclipse.milo.opcua.sdk.core.CefactEngineeringUnits;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UNumber;
import org.eclipse.milo.opcua.stack.core.types.structured.EUInformation;
import org.jspecify.annotations.Nullable;

/** Converts values of KRL to those of OPC UA and back. */
final class UaValues {
  /** The codes of UNECE recommendation 20 for units that have one meaning. */
  private static final Map<String, String> CODES =
      Map.of(
          "mm", "MMT", "°", "DD", "%", "P1", "K", "KEL", "ms", "C26", "s", "SEC", "kg", "KGM",
          "m/s", "MTS");

  private UaValues() {}

  /** Returns a number, truth value or text; structures and arrays as KRL writes them. */
  static Object toUa(KrlValue value) {
    return value.accept(ToUa.INSTANCE);
  }

  private static final class ToUa implements KrlVisitor<Object> {
    private static final ToUa INSTANCE = new ToUa();

    @Override
    public Object visit(KrlInt number) {
      return number.value();
    }

    @Override
    public Object visit(KrlReal number) {
      return number.asDouble();
    }

    @Override
    public Object visit(KrlBool bool) {
      return bool.value();
    }

    @Override
    public Object visit(KrlEnum constant) {
      return constant.print();
    }

    @Override
    public Object visit(KrlString string) {
      return string.text();
    }

    @Override
    public Object visit(KrlStruct struct) {
      return struct.print();
    }

    @Override
    public Object visit(KrlArray array) {
      return array.print();
    }
  }

  /** Returns the data type of a value. */
  static NodeId dataType(KrlValue value) {
    if (value instanceof KrlInt) {
      return NodeIds.Int32;
    }
    if (value instanceof KrlReal) {
      return NodeIds.Double;
    }
    return value instanceof KrlBool ? NodeIds.Boolean : NodeIds.String;
  }

  /**
   * Returns a value as KRL writes it.
   *
   * @param now the current value of the variable, which has its type
   * @return the text; null if the variable has another type
   */
  static @Nullable String toKrl(@Nullable Object value, KrlValue now) {
    if (now instanceof KrlInt || now instanceof KrlReal) {
      return number(value, now instanceof KrlReal);
    }
    if (now instanceof KrlBool) {
      return value instanceof Boolean bool ? new KrlBool(bool).print() : null;
    }
    if (now instanceof KrlEnum) {
      return value instanceof String text && text.startsWith("#") ? text : null;
    }
    return now instanceof KrlString && value instanceof String text
        ? new KrlString(text).print()
        : null;
  }

  private static @Nullable String number(@Nullable Object value, boolean real) {
    if (!(value instanceof Number number)) {
      return null;
    }
    boolean whole = !(number instanceof Double || number instanceof Float);
    if (real) {
      return KrlReal.of(
              number instanceof Float
                  ? Double.parseDouble(number.toString())
                  : number.doubleValue())
          .print();
    }
    long exact = number instanceof UNumber unsigned ? unsigned.longValue() : number.longValue();
    return whole && exact == (int) exact ? Long.toString(exact) : null;
  }

  /** Returns the description of a unit; null if it has no code. */
  static @Nullable EUInformation unit(String unit) {
    String code = CODES.get(unit);
    if (code == null) {
      return null;
    }
    int id = 0;
    for (byte character : code.getBytes(StandardCharsets.US_ASCII)) {
      id = id << 8 | character;
    }
    return CefactEngineeringUnits.getByUnitId(id);
  }
}
