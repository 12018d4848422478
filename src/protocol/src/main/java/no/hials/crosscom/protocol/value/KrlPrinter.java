package no.hials.crosscom.protocol.value;

/** Prints KRL values. */
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
   * @param out the target
   * @param value the value
   * @param style the style of REALs; {@link RealStyle#SHORTEST} also prints aggregates as in a data
   *     list, without type name and without blanks after commas
   */
  public static void append(StringBuilder out, KrlValue value, RealStyle style) {
    value.accept(new Appender(out, style, new KrlText()));
    if (value instanceof KrlArray) {
      out.append(' '); // as the controller does (docs/reference/krl-values.md#arrays)
    }
  }

  /** Appends values; inside an aggregate an array has no trailing blank. */
  private record Appender(StringBuilder out, RealStyle style, KrlText number)
      implements KrlVisitor<StringBuilder> {
    @Override
    public StringBuilder visit(KrlInt integer) {
      return out.append(integer.value());
    }

    @Override
    public StringBuilder visit(KrlReal real) {
      RealText.append(number.clear(), real.value(), style);
      return out.append(number);
    }

    @Override
    public StringBuilder visit(KrlBool bool) {
      appendBool(out, bool.value());
      return out;
    }

    @Override
    public StringBuilder visit(KrlString string) {
      return out.append('"').append(string.text()).append('"');
    }

    @Override
    public StringBuilder visit(KrlEnum constant) {
      return out.append('#').append(constant.name());
    }

    @Override
    public StringBuilder visit(KrlArray array) {
      String separator = "";
      for (KrlValue element : array.elements()) {
        out.append(separator);
        element.accept(this);
        separator = " ";
      }
      return out;
    }

    @Override
    public StringBuilder visit(KrlStruct struct) {
      boolean compact = style == RealStyle.SHORTEST;
      openStruct(out);
      if (struct.typeName() != null && !compact) {
        out.append(struct.typeName()).append(": ");
      }
      String separator = "";
      for (KrlStruct.Field field : struct.fields()) {
        out.append(separator).append(field.name()).append(' ');
        field.value().accept(this);
        separator = compact ? "," : ", ";
      }
      closeStruct(out);
      return out;
    }
  }

  /**
   * Opens an aggregate without a type name, as in a data list.
   *
   * @param out the target
   */
  public static void openStruct(StringBuilder out) {
    out.append('{');
  }

  /**
   * Appends the name of the next field of an aggregate opened by {@link #openStruct}; the caller
   * appends the value.
   *
   * @param out the target
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
   * @param out the target
   */
  public static void closeStruct(StringBuilder out) {
    out.append('}');
  }

  /**
   * Appends a REAL.
   *
   * @param out the target
   * @param value the number; finite
   * @param style the style
   */
  public static void appendReal(StringBuilder out, float value, RealStyle style) {
    KrlText text = new KrlText();
    RealText.append(text, value, style);
    out.append(text);
  }

  /**
   * Appends a BOOL.
   *
   * @param out the target
   * @param value the value
   */
  public static void appendBool(StringBuilder out, boolean value) {
    out.append(value ? "TRUE" : "FALSE");
  }
}
