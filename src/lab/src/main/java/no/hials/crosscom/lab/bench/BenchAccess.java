package no.hials.crosscom.lab.bench;

import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * An access that {@code bench} measures.
 *
 * @param write whether the access is a write
 * @param name the variable
 * @param type the type of its value, as far as the value shows it, such as {@code REAL[12]}
 * @param bytes the length of the value's text
 */
public record BenchAccess(boolean write, String name, String type, int bytes) {

  /** Creates an access; the current value of the variable sets type and length. */
  public static BenchAccess of(boolean write, String name, String value) {
    return new BenchAccess(write, name, type(value), value.length());
  }

  public String verb() {
    return write ? "write" : "read";
  }

  public String label() {
    return verb() + " " + name;
  }

  private static String type(String value) {
    try {
      return type(KrlValue.parse(value));
    } catch (KrlSyntaxException e) {
      return "text";
    }
  }

  private static String type(KrlValue value) {
    if (value instanceof KrlInt) {
      return "INT";
    } else if (value instanceof KrlReal) {
      return "REAL";
    } else if (value instanceof KrlBool) {
      return "BOOL";
    } else if (value instanceof KrlEnum) {
      return "ENUM";
    } else if (value instanceof KrlArray array) {
      return type(array.elements().get(0)) + "[" + array.elements().size() + "]";
    } else if (value instanceof KrlStruct struct) {
      String name = struct.typeName();
      return name == null ? "STRUC" : name;
    } else if (value instanceof KrlString) {
      return "CHAR[]";
    }
    throw new AssertionError(value);
  }
}
