package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import no.hials.crosscom.mock.Latency;
import org.junit.jupiter.api.Test;
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
    "3600000,3600000"
  })
  void readsATimeAsTheMockServerDoes(String text, long millis) {
    Duration time = Duration.ofMillis(millis);
    assertThat(new Converters.Time().convert(text)).isEqualTo(time);
    assertThat(Latency.parse(text, 1)).isEqualTo(Latency.fixed(time));
  }

  @Test
  void readsATimeOfManyDays() {
    assertThat(new Converters.Time().convert("2147483647"))
        .isEqualTo(Duration.ofMillis(Integer.MAX_VALUE));
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
