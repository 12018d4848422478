package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.FILE;
import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.entry;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.lang.Routine.Parameter;
import no.hials.crosscom.protocol.value.KrlEncoding;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FileTest {
  private static ParseResult parse(String text) {
    return KrlParser.parse(FILE, text);
  }

  private static Position at(int line, int column) {
    return new Position(FILE, line, column);
  }

  @Test
  void readsTheRoutinesOfAProgram() {
    ParseResult result =
        parse(
            """
            &ACCESS RVP

            DEF Main ( )
            END
              GLOBAL DEFFCT REAL Limit (Value :IN,Field[] :OUT,Table[,])
              ENDFCT
            GLOBAL DEF $Sub(A)
            END
            ; behind
            """);

    assertThat(result.errors()).isEmpty();
    SourceFile file = (SourceFile) result.file().orElseThrow();
    assertThat(file.position()).isEqualTo(at(3, 1));
    assertThat(file.name()).isEqualTo("Main");
    assertThat(file.routines())
        .containsExactly(
            new Routine(
                at(3, 1), false, null, List.of(), "Main", List.of(), List.of(), List.of(),
                at(4, 1)),
            new Routine(
                at(5, 3),
                true,
                "REAL",
                List.of(),
                "Limit",
                List.of(
                    new Parameter(at(5, 29), "Value", 0, false),
                    new Parameter(at(5, 39), "Field", 1, true),
                    new Parameter(at(5, 52), "Table", 2, true)),
                List.of(),
                List.of(),
                at(6, 3)),
            new Routine(
                at(7, 1),
                true,
                null,
                List.of(),
                "$Sub",
                List.of(new Parameter(at(7, 17), "A", 0, true)),
                List.of(),
                List.of(),
                at(8, 1)));
  }

  @Test
  void readsAFunctionOfAnArrayType() {
    assertThat(show(Snippets.onlyRoutine(parse("DEFFCT CHAR[] F()\nENDFCT"))))
        .isEqualTo("Routine(false, CHAR, [-], F, [], [], [])");
  }

  @Test
  void readsADataList() {
    ParseResult result = parse("&REL 5\n DEFDAT $Config PUBLIC ; c\nINT A\nENDDAT");

    assertThat(result.errors()).isEmpty();
    DataList list = (DataList) result.file().orElseThrow();
    assertThat(list.position()).isEqualTo(at(2, 2));
    assertThat(list.name()).isEqualTo("$Config");
    assertThat(list.isPublic()).isTrue();
    assertThat(list.headers()).containsExactly(entry("REL", "5"));
    assertThat(list.declarations()).hasSize(1);
  }

  @Test
  void readsAnEmptyDataList() {
    assertThat(parse("DEFDAT A\nENDDAT").file())
        .contains(new DataList(at(1, 1), "A", false, Map.of(), List.of()));
  }

  @Test
  void keepsTheHeaders() {
    KrlFile file =
        parse(
                "&access RVP\n&REL 12\n&PARAM EDITMASK = *\n; no header\n"
                    + "&PARAM TEMPLATE = C:\\X ; y\n&COMMENT\nDEF A()\nEND")
            .file()
            .orElseThrow();

    assertThat(file.headers())
        .containsExactly(
            entry("ACCESS", "RVP"),
            entry("REL", "12"),
            entry("PARAM", "EDITMASK = *\nTEMPLATE = C:\\X ; y"),
            entry("COMMENT", ""));
  }

  @Test
  void keepsHeadersInsideAndAfterAModule() {
    ParseResult result = parse("DEF A()\n&REL 5\nB=1\nEND\n&PARAM X = Y\nDEF C()\nEND\n");

    assertThat(result.errors()).isEmpty();
    KrlFile file = result.file().orElseThrow();
    assertThat(file.headers()).containsExactly(entry("REL", "5"), entry("PARAM", "X = Y"));
    assertThat(((SourceFile) file).routines()).extracting(Routine::name).containsExactly("A", "C");
  }

  @ParameterizedTest
  @ValueSource(strings = {"\n", "\r\n", "\r\r\n"})
  void countsLinesWithEitherLineEnd(String end) {
    assertThat(errors(parse(String.join(end, "DEF A()", "", ";FOLD INI;%{PE}", "A=)", "END"))))
        .containsExactly("4:3 expected a value, found )");
  }

  @ParameterizedTest
  @ValueSource(strings = {"\uFEFF", "\u00EF\u00BB\u00BF"})
  void skipsAByteOrderMark(String mark) {
    assertThat(errors(parse(mark + "DEF A() B\nEND")))
        .containsExactly("1:9 expected the end of the line, found B");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "A=1;B=2                 | 1:1 expected DEF, DEFFCT or DEFDAT, found A",
        "A=1;DEF A();END         | 1:1 expected DEF, DEFFCT or DEFDAT, found A",
        "DFE A();B=1;END         | 1:1 expected DEF, DEFFCT or DEFDAT, found DFE",
        "\\                      | 1:1 expected DEF, DEFFCT or DEFDAT, found the character \\",
        "END                     | 1:1 expected DEF, DEFFCT or DEFDAT, found END",
        "DEF;END                 | 1:4 expected a name, found the end of the line",
        "DEF A;END               | 1:6 expected (, found the end of the line",
        "DEF A(1);END            | 1:7 expected a name or ), found 1",
        "DEF A(B C);END          | 1:9 expected :, a comma or ), found C",
        "DEF A(B:X);END          | 1:9 expected IN or OUT, found X",
        "DEF A(B[3]:IN);END      | 1:9 the dimensions of a parameter must be open, as in NAME[]",
        "DEF A23456789012345678901234X();END | 1:5 a name has at most 24 characters,"
            + " A23456789012345678901234X has 25",
        "DECL DEF A();END        | 1:1 DECL is not allowed here",
        "DEF A()                 | 1:8 expected END, found the end of the file",
        "DEF A();B=1             | 2:4 expected END, found the end of the file",
        "DEF A();DEF B();END     | 2:1 expected END, found DEF",
        "DEF A();GLOBAL DEF B();END | 2:8 expected END, found DEF",
        "DEF A();ENDFCT          | 2:1 expected END, found ENDFCT",
        "DEF A();ENDDAT          | 2:1 expected END, found ENDDAT",
        "DEF A();END X           | 2:5 expected the end of the line, found X",
        "DEF A();END;B=1;C=1     | 3:1 expected DEF, DEFFCT or the end of the file, found B",
        "DEF A();END;END         | 3:1 expected DEF, DEFFCT or the end of the file, found END",
        "DEF A();END;DEFDAT A;INT B;ENDDAT | 3:1 expected DEF, DEFFCT or the end of the file, found"
            + " DEFDAT",
        "&;DEF A();END           | 1:1 expected a word after &",
        "DEFFCT A();ENDFCT       | 1:9 expected a name or [, found (",
        "DEFFCT INT A();END      | 2:1 expected ENDFCT, found END",
        "DEFFCT INT A();         | 2:1 expected ENDFCT, found the end of the file",
        "DEFDAT;ENDDAT           | 1:7 expected a name, found the end of the line",
        "DEFDAT A X;ENDDAT       | 1:10 expected PUBLIC or the end of the line, found X",
        "DEFDAT A();ENDDAT       | 1:9 expected PUBLIC or the end of the line, found (",
        "DEFDAT A                | 1:9 expected ENDDAT, found the end of the file",
        "DEFDAT A;END            | 2:1 expected ENDDAT, found END",
        "DEFDAT A;ENDAT          | 2:1 unknown statement ENDAT: expected = or ( after it, found the"
            + " end of the file",
        "DEFDAT A;ENDDAT;INT B;INT C | 3:1 expected the end of the file, found INT",
        "DEFDAT A;ENDDAT;DEF B();C=);END | 3:1 expected the end of the file, found DEF",
      })
  void reportsWhatIsWrongWithAFileOnce(String lines, String error) {
    assertThat(errors(parse(lines.replace(';', '\n')))).containsExactly(error);
  }

  @Test
  void wantsAModule() {
    assertThat(errors(parse("")))
        .containsExactly("1:1 expected DEF, DEFFCT or DEFDAT, found the end of the file");
    assertThat(errors(parse("\n; only a comment\n")))
        .containsExactly("3:1 expected DEF, DEFFCT or DEFDAT, found the end of the file");
  }

  @Test
  void givesNoTreeWithoutAModule() {
    assertThat(parse("A=1").file()).isEmpty();
    assertThat(parse("DEF (\nEND").file()).isEmpty();
    assertThat(parse("DEFDAT\nENDDAT").file()).isEmpty();
  }

  @Test
  void writesAnErrorAsItsPlaceAndMessage() {
    assertThat(parse("X").errors().get(0))
        .hasToString("T.SRC:1:1: expected DEF, DEFFCT or DEFDAT, found X");
  }

  @ParameterizedTest
  @ValueSource(strings = {"windows-1252", "UTF-8"})
  void readsAFileInEitherEncoding(String encoding, @TempDir Path folder) throws IOException {
    Path path = folder.resolve("A.DAT");
    String text = "DEFDAT A\r\nX[]=\"\u00FC\u20AC\"\r\nY\r\nENDDAT";
    Files.write(path, text.getBytes(Charset.forName(encoding)));

    ParseResult result = KrlParser.parse(path);

    assertThat(show(result.file().orElseThrow()))
        .isEqualTo("DataList(A, false, [InitialValue(X[]+open, \"\u00FC\u20AC\", )])");
    assertThat(result.errors())
        .extracting(KrlError::position)
        .containsExactly(new Position(path.toString(), 3, 1));
  }

  @Test
  void skipsAUtf8MarkInAFile(@TempDir Path folder) throws IOException {
    Path path = folder.resolve("a.src");
    Files.writeString(path, "\uFEFFDEF A()\nEND");

    assertThat(KrlParser.parse(path).errors()).isEmpty();
  }

  @Test
  void readsAnyByteInAComment() {
    byte[] bytes = new byte[256];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (i == '\n' ? ' ' : i);
    }
    String comment = KrlEncoding.decode(bytes);

    assertThat(errors(parse("DEFDAT A\nINT B=100 ;" + comment + "\nENDDAT"))).isEmpty();
  }

  @Test
  void failsIfAFileCannotBeRead(@TempDir Path folder) {
    assertThatThrownBy(() -> KrlParser.parse(folder.resolve("none.src")))
        .isInstanceOf(NoSuchFileException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"\u001A", "\r\n\u001A", "\u001A\u001A\r\n", "\f\u001A"})
  void theEndOfFileOfDosIsSkipped(String end) {
    ParseResult parsed = KrlParser.parse("x.src", "DEF X( )\r\n\fWAIT SEC 1\f\r\nEND" + end);

    assertThat(parsed.errors()).isEmpty();
    assertThat(parsed.file()).isPresent();
  }

  @Test
  void aFormFeedInATextStays() {
    DataList list =
        (DataList)
            KrlParser.parse("x.dat", "DEFDAT X\n\fCHAR C[9]=\"a\fb\"\f\nENDDAT\n")
                .file()
                .orElseThrow();

    assertThat(list.declarations().toString()).contains("a\fb");
  }

  @Test
  void theEndOfFileOfDosElsewhereIsAnError() {
    assertThat(KrlParser.parse("x.src", "DEF X( )\n\u001A\nEND\n").errors()).isNotEmpty();
  }
}
