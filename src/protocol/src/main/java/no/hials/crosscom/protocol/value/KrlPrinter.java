package no.hials.crosscom.protocol.value;

/** Prints KRL values. The only code that does. */
public final class KrlPrinter {
  private KrlPrinter() {}

  static String print(KrlValue value, RealStyle style) {
    StringBuilder out = new StringBuilder();
    append(out, value, style);
    return out.toString();
  }

  /**
   * Appends the text of a value.
   *
   * @param out where to
   * @param value the value
   * @param style how to print REALs; with {@link RealStyle#SHORTEST} aggregates are printed as in a
   *     data list, without type name and without blanks after commas
   */
  public static void append(StringBuilder out, KrlValue value, RealStyle style) {
    if (value instanceof KrlArray array) {
      // the trailing blank is the controller's own (krl.md 1.4)
      appendElements(out, array, style);
      out.append(' ');
    } else {
      appendPart(out, value, style);
    }
  }

  private static void appendPart(StringBuilder out, KrlValue value, RealStyle style) {
    if (value instanceof KrlInt number) {
      out.append(number.value());
    } else if (value instanceof KrlReal number) {
      appendReal(out, number.value(), style);
    } else if (value instanceof KrlBool bool) {
      appendBool(out, bool.value());
    } else if (value instanceof KrlString string) {
      out.append('"').append(string.text()).append('"');
    } else if (value instanceof KrlEnum constant) {
      out.append('#').append(constant.name());
    } else if (value instanceof KrlStruct struct) {
      appendStruct(out, struct, style);
    } else if (value instanceof KrlArray array) {
      appendElements(out, array, style);
    }
  }

  private static void appendElements(StringBuilder out, KrlArray array, RealStyle style) {
    String separator = "";
    for (KrlValue element : array.elements()) {
      out.append(separator);
      appendPart(out, element, style);
      separator = " ";
    }
  }

  private static void appendStruct(StringBuilder out, KrlStruct struct, RealStyle style) {
    boolean compact = style == RealStyle.SHORTEST;
    openStruct(out);
    if (struct.typeName() != null && !compact) {
      out.append(struct.typeName()).append(": ");
    }
    boolean first = true;
    for (KrlStruct.Field field : struct.fields()) {
      if (!first) {
        out.append(compact ? "," : ", ");
      }
      first = false;
      out.append(field.name()).append(' ');
      appendPart(out, field.value(), style);
    }
    closeStruct(out);
  }

  /**
   * Opens an aggregate without a type name, as in a data list.
   *
   * @param out where to
   */
  public static void openStruct(StringBuilder out) {
    out.append('{');
  }

  /**
   * Appends the name of the next field of an aggregate opened by {@link #openStruct}; its value is
   * to follow.
   *
   * @param out where to
   * @param name the field's name
   */
  public static void nextField(StringBuilder out, String name) {
    if (out.charAt(out.length() - 1) != '{') {
      out.append(',');
    }
    out.append(name).append(' ');
  }

  /**
   * Closes an aggregate.
   *
   * @param out where to
   */
  public static void closeStruct(StringBuilder out) {
    out.append('}');
  }

  /**
   * Appends a REAL.
   *
   * @param out where to
   * @param value the number; finite
   * @param style how
   */
  public static void appendReal(StringBuilder out, float value, RealStyle style) {
    RealText.append(out, value, style);
  }

  /**
   * Appends a BOOL.
   *
   * @param out where to
   * @param value the value
   */
  public static void appendBool(StringBuilder out, boolean value) {
    out.append(value ? "TRUE" : "FALSE");
  }
}
