package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.cell.Robot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PageAddressTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({
    "127.0.0.1, 127.0.0.1",
    "127.0.0.2, 127.0.0.2",
    "localhost, localhost 127.0.0.1",
    "::1, [0:0:0:0:0:0:0:1]",
    "[::1], [0:0:0:0:0:0:0:1]"
  })
  void aLoopbackAddressHasItsNames(String host, String names) throws Exception {
    PageAddress address = PageAddress.of(List.of(host));

    assertThat(address.isLoopback()).isTrue();
    assertThat(address.names()).containsExactly(names.split(" "));
  }

  @Test
  void theFirstHostIsListenedOnAndTheOthersAreNames() throws Exception {
    PageAddress address =
        PageAddress.of(List.of("192.0.2.7", "Cell-PC.plant.example", "2001:DB8::7"));

    assertThat(address.address()).isEqualTo(InetAddress.getByName("192.0.2.7"));
    assertThat(address.isLoopback()).isFalse();
    assertThat(address.names())
        .containsExactly("192.0.2.7", "cell-pc.plant.example", "[2001:db8:0:0:0:0:0:7]");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.0.0.0", "::"})
  void allAddressesAreThoseOfThisComputerByTheirNumbers(String any) throws Exception {
    PageAddress address = PageAddress.of(List.of(any, "cell-pc"));

    assertThat(address.isLoopback()).isFalse();
    assertThat(address.names())
        .contains("cell-pc")
        .allMatch(it -> any.equals("::") || !it.startsWith("["))
        .doesNotContain("0.0.0.0", "[0:0:0:0:0:0:0:0]", "localhost")
        .hasSizeGreaterThan(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "a b", "a/b", "http://a", "a:80", "user@a", "-a", "[a]"})
  void whatIsNoNameIsRefused(String host) {
    assertThatIllegalArgumentException().isThrownBy(() -> PageAddress.of(List.of(host)));
    assertThat(PageAddress.canonical(host)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"192.0.2.7", "0.0.0.0", "::"})
  void onlyLoopbackNeedsNoCertificate(String host) throws Exception {
    PageAddress address = PageAddress.of(List.of(host));
    Robot robot = new Robot("r", "127.0.0.1", 0, null, null, null, null);

    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                WebConfig.create(cfg -> cfg.robots(List.of(robot)).folder(folder).address(address)))
        .withMessageContaining("the page needs a certificate");
  }
}
