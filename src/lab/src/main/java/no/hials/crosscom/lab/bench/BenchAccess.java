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
import no.hials.crosscom.protocol.value.KrlVisitor;

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
      return KrlValue.parse(value).accept(new TypeName());
    } catch (KrlSyntaxException e) {
      return "text";
    }
  }

  /** Returns the name of a value's type. */
  private static final class TypeName implements KrlVisitor<String> {
    @Override
    public String visit(KrlInt number) {
      return "INT";
    }

    @Override
    public String visit(KrlReal number) {
      return "REAL";
    }

    @Override
    public String visit(KrlBool bool) {
      return "BOOL";
    }

    @Override
    public String visit(KrlEnum constant) {
      return "ENUM";
    }

    @Override
    public String visit(KrlArray array) {
      return array.elements().get(0).accept(this) + "[" + array.elements().size() + "]";
    }

    @Override
    public String visit(KrlStruct struct) {
      String name = struct.typeName();
      return name == null ? "STRUC" : name;
    }

    @Override
    public String visit(KrlString string) {
      return "CHAR[]";
    }
  }
}
