package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.TypeConversionException;

class ConvertersTest {

  @ParameterizedTest
  @CsvSource({
    "500,500",
    "1,1",
    "500ms,500",
    "3s,3000",
    "1.5s,1500",
    "2 s,2000",
    "1m,60000",
    "1min,60000",
    "0.001S,1",
    "2147483647,2147483647"
  })
  void readsATime(String text, long millis) {
    assertThat(new Converters.Time().convert(text)).isEqualTo(Duration.ofMillis(millis));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "s", "-1", "0", "0.5", "0ms", "1h", "PT3S", "3,5s", "2147483648", "1e3"})
  void refusesWhatIsNoTimeOfAMillisecondOrMore(String text) {
    assertThatThrownBy(() -> new Converters.Time().convert(text))
        .isInstanceOf(TypeConversionException.class)
        .hasMessageStartingWith("must be ")
        .hasMessageEndingWith("is " + text);
  }
}
