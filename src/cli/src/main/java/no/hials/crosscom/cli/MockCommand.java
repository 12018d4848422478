package no.hials.crosscom.cli;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code mock}. */
@Command(
    name = "mock",
    description = {
      "Simulates a controller with KUKAVARPROXY (KR 6 R900 sixx, KR C4), until Ctrl-C. Its first"
          + " line is: listening on HOST:PORT"
    },
    footer = {
      "",
      "Ctrl-C (SIGINT) and SIGTERM close it; that is its regular end, with exit code 0.",
      "",
      "Examples:",
      "  jopenshowvar mock",
      "  jopenshowvar mock --port 0 --verbose"
    })
final class MockCommand extends ConsoleCommand {
  @Option(
      names = "--host",
      order = 1,
      paramLabel = "ADDRESS",
      description = {
        "Local address to listen on. If not given, the loopback address, which only this machine"
            + " reaches."
      })
  private @Nullable String host;

  @Option(
      names = "--port",
      order = 2,
      paramLabel = "PORT",
      converter = Converters.ListeningPort.class,
      description = "TCP port to listen on, 0 for a free one; 7000 if not given.")
  private int port = ClientConfig.DEFAULT_PORT;

  MockCommand(Console console) {
    super(console);
  }

  @Override
  ExitCode run() throws IOException {
    if (host != null && host.isBlank()) {
      throw wrongUsage("--host must not be blank");
    }
    // in this order: a signal behind the first line finds both there
    try (StopSignal stop = new StopSignal();
        MockServer server = listen(addressOf(host), port)) {
      String shown = server.host();
      console()
          .print(
              "listening on "
                  + (shown.indexOf(':') >= 0 ? "[" + shown + "]" : shown)
                  + ":"
                  + server.port());
      stop.await();
      return ExitCode.DONE;
    }
  }

  private static InetAddress addressOf(@Nullable String host) throws CannotListenException {
    try {
      return host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new CannotListenException("cannot listen on " + host + ": the name is unknown", e);
    }
  }

  /** Starts a mock server that does not keep requests, since nobody asks it for them. */
  static MockServer listen(InetAddress address, int port) throws CannotListenException {
    try {
      return MockServer.start(cfg -> cfg.bindAddress(address).port(port).recordedRequests(0));
    } catch (IOException e) {
      throw new CannotListenException(String.valueOf(e.getMessage()), e);
    }
  }
}
