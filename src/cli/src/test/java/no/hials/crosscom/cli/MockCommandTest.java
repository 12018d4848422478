package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class MockCommandTest {
  private static final Pattern FIRST_LINE =
      Pattern.compile("listening on (127\\.0\\.0\\.1):(\\d+)");

  @Test
  void servesUntilItIsInterruptedAndThenFreesThePort() throws Exception {
    Lines lines = new Lines();
    CompletableFuture<Integer> code = new CompletableFuture<>();
    String[] args = {"mock", "--port", "0", "--no-discovery"};
    Thread mock = new Thread(() -> code.complete(Main.run(args, lines, new StringWriter())));
    mock.start();

    Matcher first = FIRST_LINE.matcher(lines.next());
    assertThat(first.matches()).isTrue();
    String[] read = {"read", "MYINT", "--host", first.group(1), "--port", first.group(2)};
    assertThat(Cli.run(read).lines()).containsExactly("MYINT = 0");
    assertThat(code).isNotDone();

    mock.interrupt();
    assertThat(code.get()).isZero();
    assertThat(Cli.run(read).code()).isEqualTo(3);
  }

  @Test
  void saysThatThePortIsInUse() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Cli.Result result = Cli.run("mock", "--port", "" + other.getLocalPort());

      assertThat(result.out()).isEmpty();
      assertThat(result.errLines())
          .singleElement()
          .asString()
          .startsWith("jopenshowvar: cannot listen on ")
          .contains(":" + other.getLocalPort());
      assertThat(result.code()).isEqualTo(3);
    }
  }

  @Test
  void saysThatTheAddressIsNotOfThisMachine() {
    // an address of the block for documentation, RFC 5737
    Cli.Result result = Cli.run("mock", "--host", "192.0.2.1", "--port", "0");

    assertThat(result.err()).startsWith("jopenshowvar: cannot listen on ").contains("192.0.2.1");
    assertThat(result.code()).isEqualTo(3);
  }

  /** Hands over what is printed, line by line. */
  private static final class Lines extends Writer {
    private final BlockingQueue<String> complete = new LinkedBlockingQueue<>();
    private final StringBuilder begun = new StringBuilder();

    String next() throws InterruptedException {
      return complete.take();
    }

    @Override
    public void write(char[] chars, int off, int len) {
      begun.append(chars, off, len);
    }

    @Override
    public void flush() {
      begun.toString().lines().forEach(complete::add);
      begun.setLength(0);
    }

    @Override
    public void close() {}
  }
}
