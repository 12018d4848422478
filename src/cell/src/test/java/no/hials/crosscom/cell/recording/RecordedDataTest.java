package no.hials.crosscom.cell.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import no.hials.crosscom.cell.FileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordedDataTest {
  private static final String FIRST = "2026-05-04T10:15:30.000000Z";

  @TempDir private Path dir;

  private RecordedData read(String... lines) throws IOException {
    Path file = dir.resolve("a.csv");
    Files.writeString(file, String.join("\r\n", lines));
    return RecordedData.read(file);
  }

  @Test
  void givesNumbersAndTextsByTheirTime() throws IOException {
    RecordedData data =
        read(
            "time,seconds,$POS_ACT.X,$MODE_OP,access_ms,status",
            FIRST + ",0.000000,525.000,#T1,2.125,",
            FIRST + ",0.100000,1.5E-05,\"a \"\"b\"\", c\",3,missed 1");

    assertThat(data.start()).isEqualTo(Instant.parse(FIRST));
    assertThat(data.series())
        .extracting(RecordedData.RecordedColumn::name)
        .containsExactly("$POS_ACT.X", "$MODE_OP");
    RecordedData.RecordedColumn x = data.find("$pos_act.x").orElseThrow();
    assertThat(x.isNumeric()).isTrue();
    assertThat(x.seconds()).containsExactly(0, 0.1);
    assertThat(x.values()).containsExactly(525, 1.5e-5);
    RecordedData.RecordedColumn mode = data.find("$MODE_OP").orElseThrow();
    assertThat(mode.isNumeric()).isFalse();
    assertThat(mode.texts()).containsExactly("#T1", "a \"b\", c");
    assertThat(mode.values()).containsExactly(Double.NaN, Double.NaN);
    assertThat(data.accessTimes())
        .singleElement()
        .extracting(RecordedData.RecordedColumn::values)
        .isEqualTo(new double[] {2.125, 3});
    assertThat(data.find("access_ms")).isEmpty();
  }

  @Test
  void takesAnEmptyCellForNoNumber() throws IOException {
    RecordedData.RecordedColumn series =
        read(
                "time,seconds,R,access_ms,status",
                FIRST + ",0.0,1,2,",
                FIRST + ",0.1,,,gap 3; gone",
                FIRST + ",0.2,2,2,")
            .series()
            .get(0);

    assertThat(series.values()).containsExactly(1, Double.NaN, 2);
    assertThat(series.isNumeric()).isTrue();
  }

  @Test
  void givesEachRobotItsOwnRows() throws IOException {
    RecordedData data =
        read(
            "time,seconds,robot,a:$R,b:$R,access_ms,status",
            FIRST + ",0.0,a,1,,10,",
            FIRST + ",0.1,b,,2,20,",
            FIRST + ",0.2,a,3,,11,");

    assertThat(data.find("a:$R").orElseThrow().seconds()).containsExactly(0, 0.2);
    assertThat(data.find("a:$R").orElseThrow().values()).containsExactly(1, 3);
    assertThat(data.find("b:$R").orElseThrow().values()).containsExactly(2);
    assertThat(data.accessTimes())
        .extracting(RecordedData.RecordedColumn::name)
        .containsExactly("a:access_ms", "b:access_ms");
    assertThat(data.accessTimes().get(0).values()).containsExactly(10, 11);
  }

  @Test
  void leavesOutALastRowThatIsNotComplete() throws IOException {
    assertThat(
            read("time,seconds,R,access_ms,status", FIRST + ",0.0,1,2,", FIRST + ",0.1,5")
                .series()
                .get(0)
                .values())
        .containsExactly(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "``                                 | ``                    | it is empty",
        "a,b,c,d                            | 1,2,3,4               | the first line must be"
            + " time,sec",
        "time,seconds,R,access_ms,status    | ``                    | it must have a row, has none",
        "time,seconds,R,access_ms,status    | now,0,1,2,            | line 2 must begin with a"
            + " time",
        "time,seconds,R,access_ms,status    | 2026-05-04T10:15:30Z,x,1,2, | line 2 must have the"
            + " sec"
      })
  void saysWhyAFileIsNoRecording(String header, String row, String reason) {
    assertThatThrownBy(() -> read(header, row))
        .isInstanceOf(FileException.class)
        .hasMessageContaining("a.csv is not a recording: ")
        .hasMessageContaining(reason);
  }

  @Test
  void repeatsOnlyTheEndsOfALongFirstLine() {
    assertThatThrownBy(() -> read("x".repeat(100_000), FIRST))
        .isInstanceOf(FileException.class)
        .hasMessageContaining("the first line must be time,seconds,...,access_ms,status, is xxx")
        .satisfies(e -> assertThat(e.getMessage().length()).isLessThan(3000));
  }

  @Test
  void saysInWhichLineARowHasAnotherNumberOfFields() {
    assertThatThrownBy(
            () ->
                read("time,seconds,R,access_ms,status", FIRST + ",0.0,1,2,,9", FIRST + ",0.0,1,2,"))
        .isInstanceOf(FileException.class)
        .hasMessageEndingWith("line 2 must have 5 fields, has 6");
  }

  @Test
  void saysWhichQuoteHidesTheRowsBehindIt() {
    assertThatThrownBy(
            () ->
                read(
                    "time,seconds,R,access_ms,status",
                    FIRST + ",0.0,1,2,",
                    FIRST + ",0.1,\"1,2,",
                    FIRST + ",0.2,1,2,"))
        .isInstanceOf(FileException.class)
        .hasMessageEndingWith("line 3 has a quote that is never closed");
  }

  @Test
  void skipsAByteOrderMark() throws IOException {
    assertThat(read("\ufefftime,seconds,R,access_ms,status", FIRST + ",0.0,1,2,").series())
        .hasSize(1);
  }

  @Test
  void saysThatThereIsNoFile() {
    assertThatThrownBy(() -> RecordedData.read(dir.resolve("none.csv")))
        .isInstanceOf(FileException.class)
        .hasMessageEndingWith("none.csv: file not found");
  }
}
