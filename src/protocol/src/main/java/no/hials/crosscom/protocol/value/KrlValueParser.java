package no.hials.crosscom.protocol.value;

import java.util.ArrayList;
import java.util.List;

/** Builds value trees, with {@link KrlScanner}. */
final class KrlValueParser {
  private final KrlScanner scanner;

  private KrlValueParser(KrlScanner scanner) {
    this.scanner = scanner;
  }

  static KrlValue parse(CharSequence text) {
    KrlScanner scanner = new KrlScanner(text);
    KrlValue value = new KrlValueParser(scanner).value(true, false);
    scanner.expectEnd();
    return value;
  }

  /** Reads the value of a scanner's current field. */
  static KrlValue fieldValue(KrlScanner scanner) {
    return new KrlValueParser(scanner).value(false, scanner.fieldHasBrackets());
  }

  /**
   * @param outermost whether this is the whole text, where a trailing blank means an array
   * @param array whether the name before it has brackets, which also mean an array
   */
  private KrlValue value(boolean outermost, boolean array) {
    int start = scanner.position();
    int c = scanner.peekAfterBlanks();
    if (c == '{') {
      return struct();
    }
    if (c == '"') {
      return new KrlString(scanner.readString());
    }
    KrlValue first = scalar();
    List<KrlValue> more = null;
    int next = scanner.peekAfterBlanks();
    while (next >= 0 && next != ',' && next != '}') {
      if (more == null) {
        more = new ArrayList<>(List.of(first));
      }
      int position = scanner.position();
      KrlValue element = scalar();
      if (isNumber(first) ? !isNumber(element) : element.getClass() != first.getClass()) {
        throw scanner.wrongAt(position, "another element of the same type");
      }
      more.add(element);
      next = scanner.peekAfterBlanks();
    }
    if (more != null) {
      if (!outermost && !array) {
        throw scanner.wrongAt(start, "one value, since the field's name has no []");
      }
      return array(more);
    }
    return array || (outermost && scanner.afterBlank()) ? array(List.of(first)) : first;
  }

  private static boolean isNumber(KrlValue value) {
    return value instanceof KrlInt || value instanceof KrlReal;
  }

  /** Returns an array of INT, or of REAL if one of its numbers is a REAL. */
  private static KrlArray array(List<KrlValue> elements) {
    if (elements.stream().anyMatch(KrlReal.class::isInstance)) {
      List<KrlValue> reals = new ArrayList<>(elements.size());
      for (KrlValue element : elements) {
        reals.add(element instanceof KrlInt number ? new KrlReal(number.value()) : element);
      }
      return new KrlArray(reals);
    }
    return new KrlArray(elements);
  }

  private KrlValue scalar() {
    int c = scanner.peekAfterBlanks();
    if (c == '#') {
      return new KrlEnum(scanner.readEnum());
    }
    if (c == '\'') {
      return new KrlInt(scanner.readInt());
    }
    if (c == 'T' || c == 't' || c == 'F' || c == 'f') {
      return new KrlBool(scanner.readBool());
    }
    if (c == '+' || c == '-' || c == '.' || (c >= '0' && c <= '9')) {
      return scanner.looksReal() ? new KrlReal(scanner.readFloat()) : new KrlInt(scanner.readInt());
    }
    throw scanner.wrong("a KRL value");
  }

  private KrlStruct struct() {
    int start = scanner.position();
    scanner.openStruct();
    String type = scanner.fieldName();
    List<KrlStruct.Field> fields = new ArrayList<>();
    while (scanner.nextField()) {
      String name = scanner.fieldName();
      int position = scanner.position();
      KrlValue value = fieldValue(scanner);
      try {
        fields.add(new KrlStruct.Field(name, value));
      } catch (IllegalArgumentException e) {
        throw scanner.wrongAt(position, "a value that suits " + name);
      }
    }
    try {
      return new KrlStruct(type.isEmpty() ? null : type, fields);
    } catch (IllegalArgumentException e) {
      throw scanner.wrongAt(start, "an aggregate with each field once");
    }
  }
}
