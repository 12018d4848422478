package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.program.Builtin.Call;
import no.hials.crosscom.simulator.internal.program.Builtin.Kind;
import org.jspecify.annotations.Nullable;

/**
 * SWRITE and SREAD on CHAR arrays. Assumed: the formats are those of C, the state has {@code
 * #CMD_OK}, {@code #FMT_ERR} if the text, format and values do not match, or {@code #DATA_END} at
 * the end of the text (docs/reference/krl-language.md#functions).
 */
final class TextBuiltins {
  private static final int TEXT = 0;
  private static final int STATE = 1;
  private static final int OFFSET = 2;
  private static final int FORMAT = 3;
  private static final int FIRST_VALUE = 4;
  private static final int VALUES = 10;

  /** The maximum width that a format pads to, so that a text cannot fill the memory (assumed). */
  private static final int MAX_WIDTH = 255;

  private static final Pattern PART =
      Pattern.compile("%([-+ 0#]*)(\\d{0,3})(?:\\.(\\d{0,2}))?l?([a-zA-Z%])");

  static final List<Builtin> ALL =
      List.of(
          builtin("SWRITE", Kind.OUT, Kind.VALUE, TextBuiltins::write),
          builtin("SREAD", Kind.TEXT, Kind.OUT, TextBuiltins::read));

  private TextBuiltins() {}

  private static Builtin builtin(String name, Kind text, Kind values, Builtin.Body body) {
    List<Kind> kinds = new ArrayList<>(List.of(text, Kind.OUT, Kind.OUT, Kind.TEXT));
    kinds.addAll(Collections.nCopies(VALUES, values));
    return new Builtin(name, false, kinds, VALUES, body);
  }

  /** A part of a format: text, or a conversion with its width and precision, -1 if missing. */
  private record Part(String text, String flags, int width, int precision, char conversion) {
    static List<Part> parse(String format) {
      List<Part> parts = new ArrayList<>();
      Matcher matcher = PART.matcher(format);
      int from = 0;
      while (matcher.find()) {
        parts.add(literal(format.substring(from, matcher.start())));
        from = matcher.end();
        char conversion = Character.toLowerCase(matcher.group(4).charAt(0));
        parts.add(
            conversion == '%'
                ? literal("%")
                : new Part(
                    "",
                    matcher.group(1),
                    number(matcher.group(2)),
                    number(matcher.group(3)),
                    conversion));
      }
      parts.add(literal(format.substring(from)));
      return parts;
    }

    private static Part literal(String text) {
      return new Part(text, "", -1, -1, ' ');
    }

    private static int number(@Nullable String digits) {
      return digits == null || digits.isEmpty()
          ? -1
          : Math.min(MAX_WIDTH, Integer.parseInt(digits));
    }

    boolean isLiteral() {
      return conversion == ' ';
    }

    String format(KrlValue value) throws KrlExecutionException {
      return switch (conversion) {
        case 'd', 'i' -> integer("d", Operators.intOf(value));
        case 'x' -> integer("x", Operators.intOf(value));
        case 'f', 'e', 'g' -> printf(String.valueOf(conversion), true, Operators.number(value));
        case 'b' -> printf("s", false, Operators.boolOf(value) ? "1" : "0");
        case 's', 'c' -> printf("s", true, textOf(value));
        default -> throw Operators.wrongType("a format of %" + conversion, value);
      };
    }

    private static String textOf(KrlValue value) throws KrlExecutionException {
      if (value instanceof KrlString string) {
        return string.text();
      }
      if (value instanceof KrlEnum constant) {
        return constant.name();
      }
      throw Operators.wrongType("a text", value);
    }

    /** Java refuses the precision of an integer, which is its minimum number of digits in C. */
    private String integer(String type, int value) {
      if (precision < 0) {
        return printf(type, false, value);
      }
      String digits = type.equals("x") ? Integer.toHexString(value) : Integer.toString(value);
      boolean negative = digits.startsWith("-");
      String sign = negative ? "-" : type.equals("d") && flags.contains("+") ? "+" : "";
      digits = negative ? digits.substring(1) : digits;
      return printf(
          "s", false, sign + "0".repeat(Math.max(0, precision - digits.length())) + digits);
    }

    private String printf(String type, boolean precise, Object value) {
      String signs = type.equals("s") ? (flags.contains("-") ? "-" : "") : flags.replace("#", "");
      // Java refuses flags that C ignores
      String valid = signs.replaceAll("(.)(?=.*\\1)", "");
      valid = valid.contains("-") ? valid.replace("0", "") : valid;
      valid = valid.contains("+") ? valid.replace(" ", "") : valid;
      valid = width < 0 ? valid.replace("0", "").replace("-", "") : valid;
      valid = type.equals("x") ? valid.replace("+", "").replace(" ", "") : valid;
      return String.format(
          Locale.ROOT,
          "%"
              + valid
              + (width > 0 ? width : "")
              + (precise && precision >= 0 ? "." + precision : "")
              + type,
          value);
    }
  }

  private static void done(Call call, String result, int hits, int offset)
      throws KrlExecutionException {
    call.reference(STATE)
        .write(
            new KrlStruct(
                null,
                List.of(
                    new KrlStruct.Field("RET1", new KrlEnum(result)),
                    new KrlStruct.Field("HITS", new KrlInt(hits)))));
    call.reference(OFFSET).write(new KrlInt(offset));
  }

  private static @Nullable KrlValue write(Call call) throws KrlExecutionException {
    StringBuilder out = new StringBuilder();
    int asked = Math.max(0, Operators.intOf(call.reference(OFFSET).read()));
    int capacity = call.capacity(TEXT);
    int offset = Math.min(asked, capacity);
    int next = FIRST_VALUE;
    String result = "CMD_OK";
    for (Part part : Part.parse(call.text(FORMAT))) {
      if (part.isLiteral()) {
        out.append(part.text());
        continue;
      }
      Object value = next < FIRST_VALUE + VALUES ? call.arguments().get(next) : null;
      try {
        if (!(value instanceof KrlValue given)) {
          throw Operators.wrongType("a value for each format", new KrlInt(next - FIRST_VALUE));
        }
        out.append(part.format(given));
        next++;
      } catch (KrlExecutionException e) {
        result = "FMT_ERR";
        break;
      }
    }
    StringBuilder text = new StringBuilder(call.textOrEmpty(TEXT));
    if (out.length() > capacity - asked) {
      result = "FMT_ERR";
      out.setLength(Math.min(out.length(), capacity - offset));
    }
    while (text.length() < offset) {
      text.append(' ');
    }
    text.replace(offset, Math.min(text.length(), offset + out.length()), out.toString());
    call.reference(TEXT).write(new KrlString(text.toString()));
    done(call, result, next - FIRST_VALUE, offset + out.length());
    return null;
  }

  private static @Nullable KrlValue read(Call call) throws KrlExecutionException {
    Scan scan =
        new Scan(
            call.textOrEmpty(TEXT), Math.max(0, Operators.intOf(call.reference(OFFSET).read())));
    int next = FIRST_VALUE;
    boolean matches = true;
    for (Part part : Part.parse(call.text(FORMAT))) {
      if (part.isLiteral()) {
        matches = scan.skip(part.text());
      } else {
        Object target = next < FIRST_VALUE + VALUES ? call.arguments().get(next) : null;
        KrlValue value = target instanceof Reference ? scan.read(part) : null;
        matches = value != null;
        if (value != null && target instanceof Reference reference) {
          reference.write(value);
          next++;
        }
      }
      if (!matches) {
        break;
      }
    }
    String failure = scan.atEnd() ? "DATA_END" : "FMT_ERR";
    done(call, matches ? "CMD_OK" : failure, next - FIRST_VALUE, scan.at);
    return null;
  }

  /** Reads values from a text. */
  private static final class Scan {
    private static final Pattern INTEGER = Pattern.compile("[+-]?\\d+");
    private static final Pattern HEXADECIMAL = Pattern.compile("[0-9A-Fa-f]+");
    private static final Pattern REAL =
        Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
    private static final Pattern WORD = Pattern.compile("\\S+");

    private final String text;
    private int at;

    Scan(String text, int at) {
      this.text = text;
      this.at = Math.min(at, text.length());
    }

    boolean atEnd() {
      return text.substring(at).isBlank();
    }

    /** Skips the characters of a format; a blank stands for any number of blanks. */
    boolean skip(String characters) {
      for (int i = 0; i < characters.length(); i++) {
        char c = characters.charAt(i);
        if (c == ' ') {
          skipBlanks();
        } else if (at < text.length() && text.charAt(at) == c) {
          at++;
        } else {
          return false;
        }
      }
      return true;
    }

    private void skipBlanks() {
      while (at < text.length() && text.charAt(at) == ' ') {
        at++;
      }
    }

    private @Nullable String token(Pattern pattern, Part part) {
      skipBlanks();
      int end = part.width() > 0 ? Math.min(text.length(), at + part.width()) : text.length();
      Matcher matcher = pattern.matcher(text).region(at, end);
      if (!matcher.lookingAt()) {
        return null;
      }
      at = matcher.end();
      return matcher.group();
    }

    /** Returns the value of a conversion; null if the text has none here. */
    @Nullable KrlValue read(Part part) throws KrlExecutionException {
      if (part.conversion() == 'c') {
        return at < text.length() ? new KrlString(text.substring(at, ++at)) : null;
      }
      String token =
          token(
              switch (part.conversion()) {
                case 'd', 'i', 'b' -> INTEGER;
                case 'x' -> HEXADECIMAL;
                case 'f', 'e', 'g' -> REAL;
                default -> WORD;
              },
              part);
      if (token == null) {
        return null;
      }
      try {
        return switch (part.conversion()) {
          case 'd', 'i' -> new KrlInt(Integer.parseInt(token));
          case 'b' -> new KrlBool(Integer.parseInt(token) != 0);
          case 'x' -> new KrlInt(Integer.parseUnsignedInt(token, 16));
          case 'f', 'e', 'g' -> Operators.real(Double.parseDouble(token));
          case 's' -> new KrlString(token);
          default -> null;
        };
      } catch (NumberFormatException e) {
        return null; // too large
      }
    }
  }
}
