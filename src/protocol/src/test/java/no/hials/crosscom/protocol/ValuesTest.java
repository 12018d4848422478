package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Instant;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.ItemTime;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.SystemTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The values in messages that are more than a number or a text. */
final class ValuesTest {

  @ParameterizedTest
  @CsvSource({
    "0, 1601-01-01T00:00:00Z",
    "1, 1601-01-01T00:00:00.000000100Z",
    "-1, 1600-12-31T23:59:59.999999900Z",
    // the offset of the Unix epoch, as published for FILETIME
    "116444736000000000, 1970-01-01T00:00:00Z",
    // c3-vectors.tsv, properties locked.txt: 01d83f12 1adbc000
    "132925536000000000, 2022-03-24T00:00:00Z",
    "9223372036854775807, +30828-09-14T02:48:05.477580700Z",
    "-9223372036854775808, -27627-04-19T21:11:54.522419200Z"
  })
  void aFiletimeIsAnInstantWithoutLoss(long ticks, Instant instant) {
    ItemTime time = ItemTime.ofTicks(ticks, -60);

    assertThat(time).isEqualTo(new ItemTime(instant, -60));
    assertThat(time.ticks()).isEqualTo(ticks);
  }

  @Test
  void anInstantThatAFiletimeCannotHoldIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ItemTime(Instant.ofEpochSecond(0, 50), 0))
        .withMessage("instant must be a multiple of 100 ns, is 1970-01-01T00:00:00.000000050Z");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ItemTime(Instant.MAX, 0))
        .withMessageStartingWith("instant must be -27627-04-19T21:11:54.522419200Z to +30828-");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ItemTime(Instant.parse("-27627-04-19T21:11:54.522419100Z"), 0))
        .withMessageEndingWith(", is -27627-04-19T21:11:54.522419100Z");
  }

  @Test
  void aSystemTimeIsAnInstantInMilliseconds() {
    // c3-vectors.tsv: specification sample, 3.8.1
    SystemTime time = new SystemTime(2026, 11, 6, 21, 6, 25, 55, 468);

    assertThat(time.instant()).contains(Instant.parse("2026-11-21T06:25:55.468Z"));
    assertThat(SystemTime.of(Instant.parse("2026-11-21T06:25:55.468999Z"))).isEqualTo(time);
    assertThat(SystemTime.of(Instant.parse("2026-11-22T00:00:00Z")).dayOfWeek()).isZero();
  }

  @Test
  void numbersThatAreNoTimeHaveNoInstant() {
    assertThat(new SystemTime(0, 0, 0, 0, 0, 0, 0, 0).instant()).isEmpty();
    assertThat(new SystemTime(2026, 2, 0, 29, 0, 0, 0, 0).instant()).isEmpty();
    assertThat(new SystemTime(2026, 1, 0, 1, 0, 0, 0, 1000).instant()).isEmpty();
    assertThat(new SystemTime(2026, 1, 0, 1, 0, 0, 0, 65535).instant()).isEmpty();
  }

  @Test
  void aSystemTimeOf16BitsIsAllThereIs() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SystemTime.of(Instant.parse("+65536-01-01T00:00:00Z")))
        .withMessage("year must be 0 to 65535, is 65536");
  }

  @Test
  void versionsAreOrderedByTheirNumbers() {
    assertThat(
            Stream.of(
                    new Version(1, 10, 0),
                    new Version(1, 4, 0),
                    new Version(1, 1, 2),
                    new Version(1, 1, 0),
                    new Version(2, 0, 0))
                .sorted())
        .extracting(Version::toString)
        .containsExactly("1.1", "1.1.2", "1.4", "1.10", "2.0");
  }

  @ParameterizedTest
  @CsvSource({"-1, 0, 0", "0, -1, 0", "0, 0, -1"})
  void aVersionHasNoNegativeNumber(int major, int minor, int patch) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Version(major, minor, patch))
        .withMessage("a version has no negative number, has " + major + "." + minor + "." + patch);
  }

  @Test
  void aServersInformationHasItsVersion() {
    ServerInformation information =
        new ServerInformation(
            1, 4, Code.of(BuildType.OPEN_SOURCE), SystemTime.of(Instant.EPOCH), "VM");

    assertThat(information.version()).isEqualTo(new Version(1, 4, 0));
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> new ServerInformation(256, 0, information.build(), information.time(), ""))
        .withMessage("major must be 0 to 255, is 256");
  }

  @Test
  void aFileHasNoNegativeSize() {
    FileProperties none = FileProperties.NONE;

    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new FileProperties(
                    none.itemType(),
                    -1,
                    none.attributes(),
                    none.created(),
                    none.accessed(),
                    none.modified(),
                    none.editMode(),
                    ""))
        .withMessage("size must not be negative, is -1");
  }

  @Test
  void bytesDoNotChangeWithTheArrayTheyAreFromOrGiven() {
    byte[] array = {1, 2, 3};
    Bytes bytes = Bytes.of(array);

    array[0] = 9;
    bytes.toByteArray()[1] = 9;

    assertThat(bytes).isEqualTo(Bytes.of(new byte[] {1, 2, 3}));
    assertThat(bytes).hasSameHashCodeAs(Bytes.of(new byte[] {1, 2, 3}));
    assertThat(bytes).isNotEqualTo(Bytes.of(array));
  }

  @Test
  void bytesAreTakenFromAndPutIntoPartsOfArrays() {
    byte[] array = {1, 2, 3, 4};
    byte[] target = new byte[4];

    Bytes.of(array, 1, 2).copyTo(target, 2);

    assertThat(target).containsExactly(0, 0, 2, 3);
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> Bytes.of(array, 3, 2));
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> Bytes.of(array).copyTo(target, 1));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 16, 17})
  void bytesAreShownByTheirNumberAndTheFirst16(int count) {
    assertThat(Bytes.of(new byte[count]))
        .hasToString(
            count
                + " bytes ["
                + "00".repeat(Math.min(count, 16))
                + (count > 16 ? "..." : "")
                + "]");
  }
}
