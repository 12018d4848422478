package no.hials.crosscom.protocol.value;

/**
 * Reads KRL text piece by piece, without creating objects.
 *
 * <p>The caller calls the method for the value it expects: {@link #readInt()}, {@link #readReal()},
 * or for an aggregate {@link #openStruct()} and then {@link #nextField()} before each value. Other
 * text is a {@link KrlSyntaxException} with the position. A scanner is not thread-safe; {@link
 * #reset} reuses it.
 *
 * <p>The class is long, because its methods share one position and one text: a part of it in
 * another class would need an object for the position, and reading must not create objects.
 */
public final class KrlScanner {
  private static final int NO_CHAR = -1;

  /** Stands for a character that is not ASCII, and so only part of a string. */
  private static final byte NO_SYNTAX = 0;

  /** The maximum number of digits that always fit into a long. */
  private static final int MAX_DIGITS = 18;

  private CharSequence text = "";
  private byte[] bytes = {};
  private int base;
  private int pos;
  private int end;
  private int nameStart;
  private int nameEnd;
  private boolean firstField;
  private int depth;

  // where the last number begins, for readFloat
  private int numberStart;

  /** Creates a scanner of an empty text. */
  public KrlScanner() {}

  /**
   * Creates a scanner of a text.
   *
   * @param text the text
   */
  public KrlScanner(CharSequence text) {
    reset(text);
  }

  /**
   * Starts again with another text. The text must not change while it is read.
   *
   * @param newText the text
   */
  public void reset(CharSequence newText) {
    byte[] copy = new byte[newText.length()];
    for (int i = 0; i < copy.length; i++) {
      char c = newText.charAt(i);
      copy[i] = (byte) (c > 0x7F ? NO_SYNTAX : c);
    }
    reset(newText, copy, 0);
  }

  /**
   * Starts again with a text that is also available as bytes, which are not copied.
   *
   * @param newText the text
   * @param latin1 the text in ISO 8859-1
   * @param start the index of its first byte
   */
  public void reset(CharSequence newText, byte[] latin1, int start) {
    text = newText;
    bytes = latin1;
    base = start;
    pos = start;
    end = start + newText.length();
    depth = 0;
    firstField = false;
    nameStart = start;
    nameEnd = start;
  }

  /**
   * Returns the whole text.
   *
   * @return the text, not a copy
   */
  public CharSequence text() {
    return text;
  }

  /**
   * Returns the position.
   *
   * @return the index of the next character, from 0
   */
  public int position() {
    return pos - base;
  }

  private String text(int from, int to) {
    return text.subSequence(from - base, to - base).toString();
  }

  private int peek() {
    return pos < end ? bytes[pos] & 0xFF : NO_CHAR;
  }

  /** Skips blanks, tabs and line ends, and returns the character after them, or -1 at the end. */
  int peekAfterBlanks() {
    skipBlanks();
    return peek();
  }

  private void skipBlanks() {
    while (pos < end && isBlank(bytes[pos])) {
      pos++;
    }
  }

  /** Returns whether the character before the position is a blank. */
  boolean afterBlank() {
    return pos > base && isBlank(bytes[pos - 1]);
  }

  private static boolean isBlank(int c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
  }

  private static boolean isDigit(int c) {
    return c >= '0' && c <= '9';
  }

  private static boolean isNameStart(int c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$';
  }

  private static boolean isNamePart(int c) {
    return isNameStart(c) || isDigit(c);
  }

  /**
   * Returns whether a text is a KRL name. The controller's limit of 24 characters is not checked.
   */
  static boolean isName(CharSequence name) {
    if (name.isEmpty() || !isNameStart(name.charAt(0))) {
      return false;
    }
    for (int i = 1; i < name.length(); i++) {
      if (!isNamePart(name.charAt(i))) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns whether a text is a name, alone or followed by {@code []} or an index as {@code [1,2]}.
   */
  static boolean isFieldName(CharSequence name) {
    KrlScanner scanner = new KrlScanner(name);
    return !name.isEmpty() && scanner.skipFieldName() && scanner.pos == scanner.end;
  }

  /**
   * Creates an exception for the position.
   *
   * @param expected the text that would be correct
   * @return the exception, to be thrown
   */
  public KrlSyntaxException wrong(String expected) {
    return wrongAt(pos - base, expected);
  }

  /**
   * Creates an exception for an earlier position.
   *
   * @param position the index in the text
   * @param expected the text that would be correct
   * @return the exception, to be thrown
   */
  public KrlSyntaxException wrongAt(int position, String expected) {
    String found;
    if (position >= text.length()) {
      found = "the end";
    } else {
      char c = text.charAt(position);
      found = c < ' ' || c == 0x7F ? String.format("character 0x%02X", (int) c) : "'" + c + "'";
    }
    return new KrlSyntaxException(text, position, expected, found);
  }

  /**
   * Returns whether anything but blanks is left.
   *
   * @return true if so
   */
  public boolean hasMore() {
    return peekAfterBlanks() != NO_CHAR;
  }

  /** Checks that nothing but blanks is left. */
  public void expectEnd() {
    if (hasMore()) {
      throw wrong("the end of the value");
    }
  }

  /**
   * Reads an INT: decimal, {@code 'B0101'} or {@code 'HFF'}.
   *
   * @return the number
   * @throws KrlSyntaxException if the text is not an INT of 32 bits
   */
  public int readInt() {
    int c = peekAfterBlanks();
    if (c == '\'') {
      return readRadixInt();
    }
    numberStart = pos;
    boolean negative = c == '-';
    if (negative || c == '+') {
      pos++;
    }
    if (!isDigit(peek())) {
      throw wrong("an INT");
    }
    long value = 0;
    while (isDigit(peek())) {
      value = value * 10 + (bytes[pos] - '0');
      if (value > 1L + Integer.MAX_VALUE) {
        throw wrongAt(numberStart - base, "an INT of 32 bits");
      }
      pos++;
    }
    if (negative) {
      value = -value;
    }
    if ((int) value != value) {
      throw wrongAt(numberStart - base, "an INT of 32 bits");
    }
    endScalar("an INT");
    return (int) value;
  }

  private int readRadixInt() {
    numberStart = pos;
    pos++;
    int c = peek();
    int shift;
    if (c == 'B' || c == 'b') {
      shift = 1;
    } else if (c == 'H' || c == 'h') {
      shift = 4;
    } else {
      throw wrong("B or H");
    }
    pos++;
    int digitsStart = pos;
    long value = 0;
    while (peek() != '\'') {
      int digit = pos < end ? Character.digit(bytes[pos], 16) : -1;
      if (digit < 0 || digit >= 1 << shift || bytes[pos] > 'f') {
        throw wrong(shift == 1 ? "a binary digit or '" : "a hexadecimal digit or '");
      }
      value = (value << shift) | digit;
      if (value > 0xFFFF_FFFFL) {
        throw wrongAt(numberStart - base, "an INT of 32 bits");
      }
      pos++;
    }
    if (pos == digitsStart) {
      throw wrong("a digit");
    }
    pos++;
    endScalar("an INT");
    return (int) value;
  }

  /**
   * Reads a REAL, in any form that C's printf prints, or an INT.
   *
   * @return the double nearest to the text
   * @throws KrlSyntaxException if the text is not a number that a 32-bit float can hold
   */
  public double readReal() {
    int c = peekAfterBlanks();
    if (c == '\'') {
      return readRadixInt();
    }
    numberStart = pos;
    if (c == '-' || c == '+') {
      pos++;
    }
    long digits = 0;
    int point = NO_CHAR;
    int at = pos;
    while (true) {
      int digit = at < end ? bytes[at] - '0' : NO_CHAR;
      if (digit >= 0 && digit <= 9) {
        digits = digits * 10 + digit;
      } else if (digit == '.' - '0' && point < 0) {
        point = at;
      } else {
        break;
      }
      at++;
    }
    int count = at - pos - (point < 0 ? 0 : 1);
    pos = at;
    double value = endReal(digits, count, point < 0 ? 0 : point + 1 - at);
    return c == '-' ? -value : value;
  }

  private double endReal(long digits, int count, int shift) {
    if (count == 0) {
      throw wrong("a REAL");
    }
    int exponent = shift;
    int e = peek();
    if (e == 'E' || e == 'e') {
      pos++;
      exponent += readExponent();
    }
    endScalar("a REAL");
    double value = count > MAX_DIGITS ? Double.NaN : RealText.exactly(digits, exponent);
    if (Double.isNaN(value)) {
      value = Math.abs(Double.parseDouble(text(numberStart, pos)));
    }
    if ((float) value == Float.POSITIVE_INFINITY) {
      throw wrongAt(numberStart - base, "a REAL within ±3.4028235E38");
    }
    return value;
  }

  private int readExponent() {
    boolean negative = peek() == '-';
    if (negative || peek() == '+') {
      pos++;
    }
    if (!isDigit(peek())) {
      throw wrong("an exponent");
    }
    int value = 0;
    while (isDigit(peek())) {
      // the limit avoids an overflow, and is out of range whatever the digits before it
      value = Math.min(value * 10 + (bytes[pos] - '0'), 100_000_000);
      pos++;
    }
    return negative ? -value : value;
  }

  /**
   * Reads a REAL as the float nearest to the text, which is the number the controller holds.
   *
   * @return the number
   * @throws KrlSyntaxException if the text is not a number that a float can hold
   */
  public float readFloat() {
    double value = readReal();
    return RealText.narrowsSafely(value) || bytes[numberStart] == '\''
        ? (float) value
        : Float.parseFloat(text(numberStart, pos));
  }

  /** Returns whether the number at the position is written as a REAL, with point or exponent. */
  boolean looksReal() {
    for (int i = pos; i < end; i++) {
      int c = bytes[i];
      if (c == '.' || c == 'E' || c == 'e') {
        return true;
      }
      if (!isDigit(c) && c != '-' && c != '+') {
        return false;
      }
    }
    return false;
  }

  /**
   * Reads a BOOL, in upper or lower case.
   *
   * @return the value
   * @throws KrlSyntaxException if the text is not a BOOL
   */
  public boolean readBool() {
    skipBlanks();
    int start = pos;
    if (matches("TRUE")) {
      pos += 4;
      endScalar("TRUE or FALSE");
      return true;
    }
    if (matches("FALSE")) {
      pos += 5;
      endScalar("TRUE or FALSE");
      return false;
    }
    throw wrongAt(start - base, "TRUE or FALSE");
  }

  private boolean matches(String word) {
    if (end - pos < word.length()) {
      return false;
    }
    for (int i = 0; i < word.length(); i++) {
      if ((bytes[pos + i] & ~0x20) != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Reads a CHAR or CHAR array.
   *
   * @return the text between the quotes
   * @throws KrlSyntaxException if the text is not in double quotes
   */
  public String readString() {
    if (peekAfterBlanks() != '"') {
      throw wrong("a text in double quotes");
    }
    int start = pos + 1;
    skipString();
    String value = text(start, pos - 1);
    endScalar("a text in double quotes");
    return value;
  }

  private void skipString() {
    do {
      pos++;
      if (pos >= end) {
        throw wrong("a closing double quote");
      }
    } while (peek() != '"');
    pos++;
  }

  /**
   * Reads a value of an ENUM.
   *
   * @return the constant's name, without the {@code #}
   * @throws KrlSyntaxException if the text is not an ENUM constant
   */
  public String readEnum() {
    if (peekAfterBlanks() != '#') {
      throw wrong("an ENUM constant, such as #T1");
    }
    pos++;
    int start = pos;
    if (!isNameStart(peek())) {
      throw wrong("a name");
    }
    while (isNamePart(peek())) {
      pos++;
    }
    endScalar("an ENUM constant");
    return text(start, pos);
  }

  /** Checks that a blank, the end, or the end of a field follows a scalar. */
  private void endScalar(String what) {
    if (pos < end) {
      int c = bytes[pos];
      if (!isBlank(c) && !(depth > 0 && (c == ',' || c == '}'))) {
        throw wrong("the end of " + what);
      }
    }
  }

  /**
   * Opens an aggregate and skips its type name, if there is one.
   *
   * @throws KrlSyntaxException if the text is not an aggregate, or aggregates are nested too deep
   */
  public void openStruct() {
    if (peekAfterBlanks() != '{') {
      throw wrong("an aggregate in braces");
    }
    if (depth == KrlValue.MAX_DEPTH) {
      throw wrong("at most " + KrlValue.MAX_DEPTH + " nested aggregates");
    }
    pos++;
    depth++;
    firstField = true;
    skipBlanks();
    nameStart = pos;
    nameEnd = pos;
    if (isNameStart(peek())) {
      while (isNamePart(peek())) {
        pos++;
      }
      int afterName = pos;
      if (peekAfterBlanks() == ':') {
        nameEnd = afterName;
        pos++;
      } else {
        pos = nameStart;
      }
    }
  }

  /**
   * Moves to the value of the next field, whose name {@link #fieldIs} and {@link #fieldName}
   * return, or closes the aggregate. A field without a value is assumed to be uninitialised, and is
   * skipped.
   *
   * @return false if there are no more fields
   * @throws KrlSyntaxException if the next text is neither a field nor the closing brace
   */
  public boolean nextField() {
    while (true) {
      int c = peekAfterBlanks();
      if (c == '}') {
        pos++;
        depth--;
        firstField = false;
        return false;
      }
      if (!firstField) {
        if (c != ',') {
          throw wrong("',' or '}'");
        }
        pos++;
        skipBlanks();
      }
      nameStart = pos;
      if (!skipFieldName()) {
        throw wrong(firstField ? "a field's name or '}'" : "a field's name");
      }
      firstField = false;
      nameEnd = pos;
      int next = peekAfterBlanks();
      if (next != ',' && next != '}') {
        if (pos == nameEnd && next != '{' && next != '"') {
          throw wrong(pos == end ? "a value" : "a blank");
        }
        return true;
      }
    }
  }

  /**
   * Moves to the value of the next field as {@link #nextField} does, if it has a name and is
   * printed as usual: the name in upper case, and one blank at most between two parts. This is
   * faster than {@link #nextField} and {@link #fieldIs}.
   *
   * @param name ASCII, in upper case
   * @return false if the field was not recognised; the scanner has not moved
   */
  public boolean nextFieldIs(String name) {
    int length = name.length();
    int at = pos;
    if (end - at < length + 4) {
      return false;
    }
    if (!firstField && bytes[at++] != ',') {
      return false;
    }
    if (bytes[at] == ' ') {
      at++;
    }
    for (int i = 0; i < length; i++) {
      if (bytes[at + i] != name.charAt(i)) {
        return false;
      }
    }
    int value = bytes[at + length + 1];
    if (bytes[at + length] != ' ' || isBlank(value) || value == ',' || value == '}') {
      return false;
    }
    nameStart = at;
    nameEnd = at + length;
    pos = at + length + 1;
    firstField = false;
    return true;
  }

  private boolean skipFieldName() {
    if (!isNameStart(peek())) {
      return false;
    }
    while (isNamePart(peek())) {
      pos++;
    }
    if (peek() == '[') {
      pos++;
      while (isDigit(peek()) || peek() == ',') {
        pos++;
      }
      if (peek() != ']') {
        return false;
      }
      pos++;
    }
    return true;
  }

  /**
   * Returns whether the current field has a name, or after {@link #openStruct} the type, in upper
   * or lower case.
   *
   * @param name ASCII, in upper case
   * @return true if it has
   */
  public boolean fieldIs(String name) {
    int length = name.length();
    if (nameEnd - nameStart != length) {
      return false;
    }
    for (int i = 0; i < length; i++) {
      int c = bytes[nameStart + i];
      if (c >= 'a' && c <= 'z') {
        c -= 0x20;
      }
      if (c != name.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the name of the current field, as printed.
   *
   * @return the name; after {@link #openStruct} the name of the type, or empty
   */
  public String fieldName() {
    return text(nameStart, nameEnd);
  }

  /**
   * Reads the value of the current field, of any type.
   *
   * @return the value
   * @throws KrlSyntaxException if the text is not a KRL value
   */
  public KrlValue readFieldValue() {
    return KrlValueParser.fieldValue(this);
  }

  /**
   * Skips the value of the current field, of any type. Numbers and names in it are not checked.
   *
   * @throws KrlSyntaxException if an aggregate or a text has no end
   */
  public void skipFieldValue() {
    int c = peekAfterBlanks();
    if (c == '{') {
      openStruct();
      while (nextField()) {
        skipFieldValue();
      }
    } else if (c == '"') {
      skipString();
    } else {
      while (c >= 0 && c != ',' && c != '}') {
        pos++;
        c = peek();
      }
    }
  }

  /** Returns whether the current field is a whole array, with {@code []} after its name. */
  boolean fieldHasBrackets() {
    return nameEnd - nameStart > 2 && bytes[nameEnd - 2] == '[';
  }
}
