package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The texts of docs/reference/krl-values.md, and texts that are not KRL values. */
final class KrlValueTest {

  private static KrlStruct struct(String type, KrlStruct.Field... fields) {
    return new KrlStruct(type, List.of(fields));
  }

  private static KrlStruct untyped(KrlStruct.Field... fields) {
    return new KrlStruct(null, List.of(fields));
  }

  private static KrlStruct.Field field(String name, KrlValue value) {
    return new KrlStruct.Field(name, value);
  }

  private static KrlStruct.Field field(String name, double value) {
    return new KrlStruct.Field(name, KrlReal.of(value));
  }

  private static KrlStruct.Field field(String name, int value) {
    return new KrlStruct.Field(name, new KrlInt(value));
  }

  private static KrlArray ints(int... values) {
    return new KrlArray(Arrays.stream(values).<KrlValue>mapToObj(KrlInt::new).toList());
  }

  private static KrlArray reals(double... values) {
    return new KrlArray(Arrays.stream(values).<KrlValue>mapToObj(KrlReal::of).toList());
  }

  /** Texts as a KR C4 prints them: parsed, and printed again as they were. */
  static Stream<Arguments> printed() {
    return Stream.of(
        // docs/reference/krl-values.md#scalars
        arguments("116", new KrlInt(116)),
        arguments("-1", new KrlInt(-1)),
        arguments("TRUE", new KrlBool(true)),
        arguments("FALSE", new KrlBool(false)),
        arguments("\"A\"", new KrlString("A")),
        arguments("#T1", new KrlEnum("T1")),
        arguments("#P_ACTIVE", new KrlEnum("P_ACTIVE")),
        arguments("#NONE", new KrlEnum("NONE")),
        arguments("\"text\"", new KrlString("text")),
        arguments("\" \"", new KrlString(" ")),
        arguments("63", new KrlInt(63)),
        // docs/reference/wire-format.md#examples
        arguments("100", new KrlInt(100)),
        arguments("#CHARGE_OK", new KrlEnum("CHARGE_OK")),
        // docs/reference/krl-values.md#structures
        arguments(
            "{E6POS: X 840.229, Y -840.229, Z 1794.12939, A -135.000, B 2.22039314E-12,"
                + " C 79.0000, S 2, T 34, E1 0.0, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}",
            struct(
                "E6POS",
                field("X", 840.229),
                field("Y", -840.229),
                field("Z", 1794.12939),
                field("A", -135.0),
                field("B", 2.22039314E-12),
                field("C", 79.0),
                field("S", 2),
                field("T", 34),
                field("E1", 0.0),
                field("E2", 0.0),
                field("E3", 0.0),
                field("E4", 0.0),
                field("E5", 0.0),
                field("E6", 0.0))),
        // docs/reference/krl-values.md#structures, the nested sample of LOAD, its elided numbers
        // filled in
        arguments(
            "{LOAD: M 65.0000, CM {FRAME: X 180.000, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0},"
                + " J {INERTIA: X 19.5000, Y 0.0, Z 0.0}}",
            struct(
                "LOAD",
                field("M", 65.0),
                field(
                    "CM",
                    struct(
                        "FRAME",
                        field("X", 180.0),
                        field("Y", 0.0),
                        field("Z", 0.0),
                        field("A", 0.0),
                        field("B", 0.0),
                        field("C", 0.0))),
                field("J", struct("INERTIA", field("X", 19.5), field("Y", 0.0), field("Z", 0.0))))),
        // CHAR arrays keep their brackets; the fields are those of PRO_IP
        // (docs/reference/krl-values.md#structures)
        arguments(
            "{PRO_IP: NAME[] \"/R1/XXX.SRC\", SNR 1, P_ARRIVED TRUE,"
                + " SI01 {CALL_STACK: NAME[] \" \", SNR 0, INT_FLAG FALSE}}",
            struct(
                "PRO_IP",
                field("NAME[]", new KrlString("/R1/XXX.SRC")),
                field("SNR", 1),
                field("P_ARRIVED", new KrlBool(true)),
                field(
                    "SI01",
                    struct(
                        "CALL_STACK",
                        field("NAME[]", new KrlString(" ")),
                        field("SNR", 0),
                        field("INT_FLAG", new KrlBool(false)))))),
        // only initialised components, none at all (docs/reference/krl-values.md#structures)
        arguments(
            "{E6POS: X 1.00000, C 2.00000}", struct("E6POS", field("X", 1.0), field("C", 2.0))),
        arguments("{E6POS: }", struct("E6POS")),
        // an array ends with a blank (docs/reference/krl-values.md#arrays)
        arguments("0.0 ".repeat(12), reals(new double[12])),
        arguments("-1.00000 0.100000 ", reals(-1, 0.1)),
        arguments("0.0 ", reals(0)),
        arguments("1 2 -3 ", ints(1, 2, -3)),
        arguments("7 ", ints(7)),
        arguments("TRUE FALSE ", new KrlArray(List.of(new KrlBool(true), new KrlBool(false)))),
        arguments("#T1 #EX ", new KrlArray(List.of(new KrlEnum("T1"), new KrlEnum("EX")))),
        arguments(
            "{T: A[] 1 2, B[] 0.500000, N[] \"x\", C 1}",
            struct(
                "T",
                field("A[]", ints(1, 2)),
                field("B[]", reals(0.5)),
                field("N[]", new KrlString("x")),
                field("C", 1))));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("printed")
  void aTextOfAControllerIsTheValueItStandsFor(String text, KrlValue value) {
    assertThat(KrlValue.parse(text)).isEqualTo(value);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("printed")
  void aValueIsPrintedAsTheControllerPrintsIt(String text, KrlValue value) {
    assertThat(value.print()).isEqualTo(text);
    assertThat(value).hasToString(text);
  }

  /** Texts that are parsed as well, and print otherwise. */
  static Stream<Arguments> alsoTaken() {
    KrlStruct frame = untyped(field("X", 0.0), field("Y", 0.0));
    return Stream.of(
        // literals of programs and dat files (docs/reference/krl-values.md#scalars)
        arguments("'B0101'", new KrlInt(5)),
        arguments("'HFF'", new KrlInt(255)),
        arguments("'B0000'", new KrlInt(0)),
        arguments("'B00111111'", new KrlInt(63)),
        arguments("'B000111111111'", new KrlInt(511)),
        arguments("'b101'", new KrlInt(5)),
        arguments("'hff'", new KrlInt(255)),
        arguments("'H7FFFFFFF'", new KrlInt(Integer.MAX_VALUE)),
        arguments("'H80000000'", new KrlInt(Integer.MIN_VALUE)),
        arguments("'HFFFFFFFF'", new KrlInt(-1)),
        arguments("'H00000000FFFFFFFF'", new KrlInt(-1)),
        arguments("'B" + "1".repeat(32) + "'", new KrlInt(-1)),
        arguments("'B1" + "0".repeat(31) + "'", new KrlInt(Integer.MIN_VALUE)),
        arguments("'B0" + "1".repeat(31) + "'", new KrlInt(Integer.MAX_VALUE)),
        arguments("2147483647", new KrlInt(Integer.MAX_VALUE)),
        arguments("-2147483648", new KrlInt(Integer.MIN_VALUE)),
        arguments("+12", new KrlInt(12)),
        arguments("007", new KrlInt(7)),
        arguments("-0", new KrlInt(0)),
        // KR C2, and what programs have (docs/reference/krl-values.md#real)
        arguments("90.00000", KrlReal.of(90)),
        arguments("-1.162400", KrlReal.of(-1.1624)),
        arguments("5.252814E-03", KrlReal.of(5.252814E-3)),
        arguments("1E5", KrlReal.of(1e5)),
        arguments("1.", KrlReal.of(1)),
        arguments(".5", KrlReal.of(0.5)),
        // BOOL in lower case (docs/reference/krl-values.md#what-a-write-accepts)
        arguments("true", new KrlBool(true)),
        arguments("False", new KrlBool(false)),
        // blanks around
        arguments("  116", new KrlInt(116)),
        arguments("\t\r\n TRUE", new KrlBool(true)),
        arguments(" \"A\" ", new KrlString("A")),
        arguments(" {X 0.0} ", untyped(field("X", 0.0))),
        arguments("\"\"", new KrlString("")),
        // dat files have no type name and no blank after a comma
        // (docs/reference/krl-values.md#structures)
        arguments("{X 0.0,Y 0.0}", frame),
        arguments("{ X 0.0 , Y 0.0 }", frame),
        arguments("{X\t0.0,\r\nY   0.0}", frame),
        arguments("{}", untyped()),
        arguments("{ }", untyped()),
        arguments("{E6POS:}", struct("E6POS")),
        arguments("{E6POS:   }", struct("E6POS")),
        arguments("{ E6POS : X 1 }", struct("E6POS", field("X", 1))),
        arguments("{FRAME:X 1}", struct("FRAME", field("X", 1))),
        // docs/reference/krl-values.md#what-a-write-accepts and docs/reference/kukavarproxy.md: INT
        // text for REAL, some fields, any order
        arguments("{X 10,Y 5}", untyped(field("X", 10), field("Y", 5))),
        arguments(
            "{E6POS: T 34, C 1.00000, X 2.00000}",
            struct("E6POS", field("T", 34), field("C", 1.0), field("X", 2.0))),
        // fields without a value are uninitialised
        arguments("{E6POS: X , Y 1, Z }", struct("E6POS", field("Y", 1))),
        arguments("{A[] , B 1}", untyped(field("B", 1))),
        arguments("{X}", untyped()),
        arguments("{X,Y}", untyped()),
        // commas, braces, colons and the like inside quotes
        arguments(
            "{N[] \"a, b}{: 'H' #T1\", M \"},{\"}",
            untyped(
                field("N[]", new KrlString("a, b}{: 'H' #T1")), field("M", new KrlString("},{")))),
        arguments(
            "{N[]\"x\",L{X 1}}",
            untyped(field("N[]", new KrlString("x")), field("L", untyped(field("X", 1))))),
        arguments("\"{X 1}\"", new KrlString("{X 1}")),
        arguments("\"\u00E5\"", new KrlString("\u00E5")),
        // names with an index, as docs/reference/krl-values.md#arrays addresses elements
        arguments("{A[1] 5, M[2,3] 6}", untyped(field("A[1]", 5), field("M[2,3]", 6))),
        arguments("{$X 1, _y 2}", untyped(field("$X", 1), field("_y", 2))),
        // arrays with and without the trailing blank (docs/reference/krl-values.md#arrays)
        arguments("1 2 -3", ints(1, 2, -3)),
        arguments(" 1   2 ", ints(1, 2)),
        arguments("0.0 1.0", reals(0, 1)),
        arguments("'B01' 2", ints(1, 2)),
        arguments("TRUE FALSE", new KrlArray(List.of(new KrlBool(true), new KrlBool(false)))),
        // one REAL among the numbers makes all of them REAL
        arguments("0.0 1 2", reals(0, 1, 2)),
        arguments("0 1.5", reals(0, 1.5)),
        arguments("16777217 0.0", reals(16777216, 0)));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("alsoTaken")
  void aTextOfAnotherFormIsTheValueToo(String text, KrlValue value) {
    assertThat(KrlValue.parse(text)).isEqualTo(value);
  }

  @Test
  void aLoneElementIsAnArrayIfABlankFollows() {
    assertThat(KrlValue.parse("5")).isEqualTo(new KrlInt(5));
    assertThat(KrlValue.parse("5 ")).isEqualTo(ints(5));
    assertThat(KrlValue.parse("5\n")).isEqualTo(ints(5));
    assertThat(KrlValue.parse("#T1 ")).isEqualTo(new KrlArray(List.of(new KrlEnum("T1"))));
  }

  @Test
  void aLoneElementInAnAggregateIsAnArrayIfItsNameHasBrackets() {
    assertThat(KrlValue.parse("{A[] 5 , B 5 }"))
        .isEqualTo(untyped(field("A[]", ints(5)), field("B", 5)));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("forWriting")
  void aValueForWritingIsPrintedInTheFewestCharacters(KrlValue value, String text) {
    assertThat(value.printShort()).isEqualTo(text);
  }

  static Stream<Arguments> forWriting() {
    return Stream.of(
        arguments(new KrlInt(-116), "-116"),
        arguments(new KrlReal(45), "45.0"),
        arguments(new KrlBool(false), "FALSE"),
        arguments(new KrlString("a b"), "\"a b\""),
        arguments(new KrlEnum("T1"), "#T1"),
        arguments(struct("E6POS"), "{}"),
        arguments(struct("FRAME", field("X", 0.0), field("Y", 0.1)), "{X 0.0,Y 0.1}"),
        arguments(
            struct(
                "LOAD",
                field("M", 65.0),
                field("CM", struct("FRAME", field("X", 180.0), field("A[]", ints(1, 2))))),
            "{M 65.0,CM {X 180.0,A[] 1 2}}"),
        arguments(reals(1, 2.5), "1.0 2.5 "));
  }

  @Test
  void anAggregateIsPrintedFieldByFieldAsForWriting() {
    StringBuilder out = new StringBuilder();

    KrlPrinter.openStruct(out);
    KrlPrinter.nextField(out, "M");
    KrlPrinter.appendReal(out, 65, RealStyle.SHORTEST);
    KrlPrinter.nextField(out, "N[]");
    KrlPrinter.append(out, new KrlString("{"), RealStyle.SHORTEST);
    KrlPrinter.nextField(out, "CM");
    KrlPrinter.openStruct(out);
    KrlPrinter.nextField(out, "X");
    KrlPrinter.appendReal(out, 180, RealStyle.SHORTEST);
    KrlPrinter.closeStruct(out);
    KrlPrinter.nextField(out, "B");
    KrlPrinter.appendBool(out, true);
    KrlPrinter.closeStruct(out);

    assertThat(out).hasToString("{M 65.0,N[] \"{\",CM {X 180.0},B TRUE}");
  }

  /** Text, position of the error, what is expected there, what is found. */
  static Stream<Arguments> malformed() {
    String end = "the end";
    String int32 = "an INT of 32 bits";
    return Stream.of(
        arguments("", 0, "a KRL value", end),
        arguments("   ", 3, "a KRL value", end),
        arguments("?", 0, "a KRL value", "'?'"),
        arguments("  X", 2, "a KRL value", "'X'"),
        arguments("\u0001", 0, "a KRL value", "character 0x01"),
        arguments("\u007F", 0, "a KRL value", "character 0x7F"),
        arguments("PONG", 0, "a KRL value", "'P'"),
        arguments("}", 0, "a KRL value", "'}'"),
        arguments(",", 0, "a KRL value", "','"),
        // INT
        arguments("2147483648", 0, int32, "'2'"),
        arguments("-2147483649", 0, int32, "'-'"),
        arguments("  99999999999999999999", 2, int32, "'9'"),
        arguments("-", 1, "an INT", end),
        arguments("+-1", 1, "an INT", "'-'"),
        arguments("1x", 1, "the end of an INT", "'x'"),
        arguments("1,2", 1, "the end of an INT", "','"),
        arguments("1}", 1, "the end of an INT", "'}'"),
        arguments("1-2", 1, "the end of an INT", "'-'"),
        arguments("1 ,2", 2, "the end of the value", "','"),
        arguments("1 }", 2, "the end of the value", "'}'"),
        // 'B..' and 'H..'
        arguments("'", 1, "B or H", end),
        arguments("'101'", 1, "B or H", "'1'"),
        arguments("'B'", 2, "a digit", "'''"),
        arguments("'B", 2, "a binary digit or '", end),
        arguments("'B012'", 4, "a binary digit or '", "'2'"),
        arguments("'H0G'", 3, "a hexadecimal digit or '", "'G'"),
        arguments("'H0", 3, "a hexadecimal digit or '", end),
        // a digit elsewhere in Unicode, which Character.digit takes
        arguments("'H\uFF11'", 2, "a hexadecimal digit or '", "'\uFF11'"),
        arguments("'H\u0661'", 2, "a hexadecimal digit or '", "'\u0661'"),
        arguments("'H100000000'", 0, int32, "'''"),
        arguments("'B1" + "0".repeat(32) + "'", 0, int32, "'''"),
        arguments("'HFF'X", 5, "the end of an INT", "'X'"),
        // REAL
        arguments(".", 1, "a REAL", end),
        arguments("-.", 2, "a REAL", end),
        arguments("1.5.2", 3, "the end of a REAL", "'.'"),
        arguments("1E", 2, "an exponent", end),
        arguments("1E+", 3, "an exponent", end),
        arguments("1.0Ex", 4, "an exponent", "'x'"),
        arguments("1.0E5.0", 5, "the end of a REAL", "'.'"),
        arguments("1.5f", 3, "the end of a REAL", "'f'"),
        arguments("1E39", 0, "a REAL within ±3.4028235E38", "'1'"),
        arguments("-1E39", 0, "a REAL within ±3.4028235E38", "'-'"),
        arguments(" 1E99999999999", 1, "a REAL within ±3.4028235E38", "'1'"),
        // BOOL
        arguments("TRU", 0, "TRUE or FALSE", "'T'"),
        arguments("FALSCH", 0, "TRUE or FALSE", "'F'"),
        arguments("TRUEE", 4, "the end of TRUE or FALSE", "'E'"),
        // ENUM
        arguments("#", 1, "a name", end),
        arguments("# T1", 1, "a name", "' '"),
        arguments("#1", 1, "a name", "'1'"),
        arguments("#T-1", 2, "the end of an ENUM constant", "'-'"),
        // texts
        arguments("\"", 1, "a closing double quote", end),
        arguments("\"abc", 4, "a closing double quote", end),
        arguments("\"a\"b\"", 3, "the end of a text in double quotes", "'b'"),
        arguments("\"a\" \"b\"", 4, "the end of the value", "'\"'"),
        // aggregates
        arguments("{", 1, "a field's name or '}'", end),
        arguments("{FRAME:", 7, "a field's name or '}'", end),
        arguments("{FRAME X 1}", 7, "a KRL value", "'X'"),
        arguments("{1 2}", 1, "a field's name or '}'", "'1'"),
        arguments("{,X 1}", 1, "a field's name or '}'", "','"),
        arguments("{: X 1}", 1, "a field's name or '}'", "':'"),
        arguments("{A: B: X 1}", 5, "a blank", "':'"),
        arguments("{X 1", 4, "',' or '}'", end),
        arguments("{X 1,}", 5, "a field's name", "'}'"),
        arguments("{X 1,,Y 2}", 5, "a field's name", "','"),
        arguments("{X 1;Y 2}", 4, "the end of an INT", "';'"),
        arguments("{X 1 ;Y 2}", 5, "a KRL value", "';'"),
        arguments("{X", 2, "a value", end),
        arguments("{X-1}", 2, "a blank", "'-'"),
        arguments("{X[1 2}", 4, "a field's name or '}'", "' '"),
        arguments("{X 1}}", 5, "the end of the value", "'}'"),
        arguments("{X 1} {X 1}", 6, "the end of the value", "'{'"),
        arguments("{X 1}2", 5, "the end of the value", "'2'"),
        arguments("{X \"a}", 6, "a closing double quote", end),
        arguments("{X {Y 1}", 8, "',' or '}'", end),
        arguments("{X 1, Y 2, x 3}", 0, "an aggregate with each field once", "'{'"),
        arguments("{A {X 1, X 2}}", 3, "an aggregate with each field once", "'{'"),
        // arrays
        arguments("{X 1 2}", 3, "one value, since the field's name has no []", "'1'"),
        arguments("{X[] {Y 1}}", 5, "a value that suits X[]", "'{'"),
        arguments("1 TRUE", 2, "another element of the same type", "'T'"),
        arguments("TRUE 1", 5, "another element of the same type", "'1'"),
        arguments("#T1 TRUE", 4, "another element of the same type", "'T'"),
        arguments("1 \"a\"", 2, "a KRL value", "'\"'"),
        arguments("1 {X 1}", 2, "a KRL value", "'{'"),
        arguments("1 2 x", 4, "a KRL value", "'x'"));
  }

  @ParameterizedTest(name = "[{index}] {0}")
  @MethodSource("malformed")
  void aMalformedTextIsRefusedWithPositionExpectedAndFound(
      String text, int position, String expected, String found) {
    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(() -> KrlValue.parse(text))
        .satisfies(
            e -> {
              assertThat(e.position()).isEqualTo(position);
              assertThat(e.expected()).isEqualTo(expected);
              assertThat(e.found()).isEqualTo(found);
              assertThat(e.text()).isEqualTo(text);
            })
        .withMessage(
            "expected "
                + expected
                + " at position "
                + position
                + ", found "
                + found
                + ", in: "
                + PrintableText.of(text));
  }

  @Test
  void anErrorInALongTextShowsWhatStandsAroundIt() {
    String text = "1 ".repeat(500) + "?" + " 2".repeat(500);

    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(() -> KrlValue.parse(text))
        .withMessage(
            "expected a KRL value at position 1000, found '?', in: ..."
                + "1 ".repeat(30)
                + "?"
                + " 2".repeat(29)
                + " ...")
        .satisfies(e -> assertThat(e.text()).isEqualTo(text));
  }

  @Test
  void anErrorAtTheEndOfALongTextShowsTheEnd() {
    String text = "{N[] \"" + "x".repeat(1000);

    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(() -> KrlValue.parse(text))
        .withMessage(
            "expected a closing double quote at position 1006, found the end, in: ..."
                + "x".repeat(120));
  }

  private static String nested(int depth) {
    return "{X ".repeat(depth) + "1" + "}".repeat(depth);
  }

  @Test
  void sixtyFourNestedAggregatesAreParsedAndPrinted() {
    KrlValue value = KrlValue.parse(nested(64));

    assertThat(value.print()).isEqualTo(nested(64));
  }

  @Test
  void sixtyFiveNestedAggregatesAreRefused() {
    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(() -> KrlValue.parse(nested(65)))
        .satisfies(e -> assertThat(e.position()).isEqualTo(64 * 3))
        .satisfies(e -> assertThat(e.expected()).isEqualTo("at most 64 nested aggregates"));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> struct("T", field("X", KrlValue.parse(nested(64)))))
        .withMessage("aggregates may nest 64 deep, these nest 65");
  }

  @Test
  void manyAggregatesBesideEachOtherAreNotNested() {
    StringBuilder text = new StringBuilder("{A0 {X 1}");
    for (int i = 1; i < 100; i++) {
      text.append(", A").append(i).append(" {X 1}");
    }
    text.append('}');

    assertThat(KrlValue.parse(text).print()).isEqualTo(text.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"{", "{X ", "{X {", "{T: X ", "[", "{\"", "{X \""})
  void aHundredThousandOpenedBracesAreAnErrorAndNoStackOverflow(String unit) {
    String text = unit.repeat(100_000);

    assertThatExceptionOfType(KrlSyntaxException.class).isThrownBy(() -> KrlValue.parse(text));
  }

  @Test
  void aFieldIsFoundWhateverItsCaseAndWithOrWithoutBrackets() {
    KrlStruct value = (KrlStruct) KrlValue.parse("{PRO_IP: NAME[] \"x\", Snr 1, A[1] 2, NAME 3}");

    assertThat(value.get("SNR")).contains(new KrlInt(1));
    assertThat(value.get("name[]")).contains(new KrlString("x"));
    assertThat(value.get("name")).contains(new KrlString("x"));
    assertThat(value.get("a[1]")).contains(new KrlInt(2));
    assertThat(value.get("A")).isEmpty();
    assertThat(value.get("SNR[]")).isEmpty();
    assertThat(value.get("NAM")).isEmpty();
    assertThat(value.get("")).isEmpty();
  }

  static Stream<Arguments> impossible() {
    return Stream.of(
        arguments(
            (Runnable) () -> new KrlArray(List.of()),
            "an array must have at least 1 element, has 0"),
        arguments(
            (Runnable) () -> new KrlArray(List.of(new KrlString("a"))),
            "an array's elements must be INT, REAL, BOOL or ENUM, [1] is \"a\""),
        arguments(
            (Runnable) () -> new KrlArray(List.of(ints(1))),
            "an array's elements must be INT, REAL, BOOL or ENUM, [1] is 1 "),
        arguments(
            (Runnable) () -> new KrlArray(List.of(new KrlInt(1), new KrlInt(2), KrlReal.of(3))),
            "an array's elements must be of one type, [1] is 1, [3] is 3.00000"),
        arguments(
            (Runnable) () -> new KrlString("\""),
            "a CHAR array cannot hold a double quote, found one at index 0 of: \""),
        arguments(
            (Runnable) () -> new KrlString("a\"b"),
            "a CHAR array cannot hold a double quote, found one at index 1 of: a\"b"),
        arguments(
            (Runnable) () -> new KrlEnum(""),
            "an ENUM constant is a name of letters, digits, _ and $, is \"\""),
        arguments(
            (Runnable) () -> new KrlEnum("#T1"),
            "an ENUM constant is a name of letters, digits, _ and $, is \"#T1\""),
        arguments(
            (Runnable) () -> new KrlEnum("1T"),
            "an ENUM constant is a name of letters, digits, _ and $, is \"1T\""),
        arguments(
            (Runnable) () -> new KrlEnum("T 1"),
            "an ENUM constant is a name of letters, digits, _ and $, is \"T 1\""),
        arguments(
            (Runnable) () -> struct("E6 POS"),
            "a STRUC's type is a name of letters, digits, _ and $, is \"E6 POS\""),
        arguments(
            (Runnable) () -> struct("T", field("X", 1), field("x", 2)), "field x is there twice"),
        arguments(
            (Runnable) () -> field("", 1),
            "a field's name is a name with or without an index, is \"\""),
        arguments(
            (Runnable) () -> field("A.B", 1),
            "a field's name is a name with or without an index, is \"A.B\""),
        arguments(
            (Runnable) () -> field("A[1", 1),
            "a field's name is a name with or without an index, is \"A[1\""),
        arguments(
            (Runnable) () -> field("A[1] ", 1),
            "a field's name is a name with or without an index, is \"A[1] \""),
        arguments(
            (Runnable) () -> field("A", ints(1)),
            "the field of a whole array is called NAME[], is \"A\""),
        arguments(
            (Runnable) () -> field("A[]", 1),
            "field A[] must hold an array or a CHAR array, holds 1"),
        arguments(
            (Runnable) () -> field("A[]", struct("T")),
            "field A[] must hold an array or a CHAR array, holds {T: }"));
  }

  @ParameterizedTest(name = "{1}")
  @MethodSource("impossible")
  void aValueThatNoTextStandsForIsRefused(Runnable constructor, String message) {
    assertThatIllegalArgumentException().isThrownBy(constructor::run).withMessage(message);
  }

  @Test
  void aValueKeepsTheElementsAndFieldsItWasMadeWith() {
    List<KrlValue> elements = new ArrayList<>(List.of(new KrlInt(1)));
    List<KrlStruct.Field> fields = new ArrayList<>(List.of(field("X", 1)));
    KrlArray array = new KrlArray(elements);
    KrlStruct struct = new KrlStruct("T", fields);

    elements.clear();
    fields.clear();

    assertThat(array).isEqualTo(ints(1));
    assertThat(struct).isEqualTo(struct("T", field("X", 1)));
  }

  @Test
  void aValueIsReadAsItsJavaType() {
    assertThat(KrlValue.parse("'HFF'").asInt()).isEqualTo(255);
    assertThat(KrlValue.parse("7").asDouble()).isEqualTo(7);
    assertThat(KrlValue.parse("0.100000").asDouble()).isEqualTo(0.1);
    assertThat(KrlValue.parse("27.0000057").asDouble()).isEqualTo(27.0000057);
    assertThat(KrlValue.parse("TRUE").asBool()).isTrue();
    assertThat(KrlValue.parse("\"text\"").asString()).isEqualTo("text");
    assertThat(KrlValue.parse("\" \"").asString()).isEmpty();
    assertThat(KrlValue.parse("#T1").asEnum()).isEqualTo("T1");
    assertThat(KrlValue.parse("{FRAME: X 1.5}").asStruct().get("X"))
        .hasValueSatisfying(x -> assertThat(x.asDouble()).isEqualTo(1.5));
    assertThat(KrlValue.parse("1 2 ").asList()).extracting(KrlValue::asInt).containsExactly(1, 2);
  }

  static Stream<Arguments> wrongTypes() {
    KrlValue real = KrlReal.of(5);
    return Stream.of(
        arguments((Executable) real::asInt, "the value must be an INT, is 5.00000"),
        arguments((Executable) real::asBool, "the value must be a BOOL, is 5.00000"),
        arguments(
            (Executable) real::asString, "the value must be a CHAR or CHAR array, is 5.00000"),
        arguments((Executable) real::asEnum, "the value must be a value of an ENUM, is 5.00000"),
        arguments((Executable) real::asStruct, "the value must be an aggregate, is 5.00000"),
        arguments((Executable) real::asList, "the value must be an array, is 5.00000"),
        arguments(
            (Executable) new KrlBool(true)::asDouble, "the value must be a REAL or INT, is TRUE"));
  }

  @ParameterizedTest
  @MethodSource("wrongTypes")
  void aValueOfAnotherTypeIsRefusedAndShown(Executable call, String message) {
    assertThatIllegalStateException().isThrownBy(call::execute).withMessage(message);
  }

  @Test
  void anArrayOfManyElementsIsParsedAndPrinted() {
    KrlArray array = new KrlArray(Collections.nCopies(10_000, new KrlInt(-7)));

    assertThat(KrlValue.parse(array.print())).isEqualTo(array);
  }
}
