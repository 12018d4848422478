package no.hials.crosscom.kafka.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;

/** Simulated robots r1, r2 and so on, and the file of their plant. */
final class Robots implements AutoCloseable {
  private final Map<String, MockServer> servers = new LinkedHashMap<>();
  private final Path file;

  /**
   * Starts robots.
   *
   * @param tables the groups and variables of the file
   */
  Robots(Path folder, int count, String tables) throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 1; i <= count; i++) {
      MockServer server =
          MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).recordedRequests(1_000_000));
      servers.put("r" + i, server);
      text.append("[robots.r" + i + "]\nhost = \"127.0.0.1\"\nport = " + server.port());
      text.append("\nserver = \"c3\"\n");
    }
    file = folder.resolve("plant.toml");
    Files.writeString(file, text + tables);
  }

  Path file() {
    return file;
  }

  MockServer get(String name) {
    return servers.get(name);
  }

  List<String> names() {
    return List.copyOf(servers.keySet());
  }

  /** A time without an access to a robot. */
  private record Silence(Instant from, Instant to) {
    Duration length() {
      return Duration.between(from, to);
    }
  }

  /** Returns the longest silence of each robot since a time. */
  private List<Silence> silences(Instant since) {
    Instant now = Instant.now();
    List<Silence> longest = new ArrayList<>();
    for (MockServer server : servers.values()) {
      Silence own = new Silence(since, since);
      Instant last = since;
      for (RecordedRequest request : server.requests()) {
        if (request.time().isAfter(last)) {
          own = longer(own, new Silence(last, request.time()));
          last = request.time();
        }
      }
      longest.add(longer(own, new Silence(last, now)));
    }
    return longest;
  }

  private static Silence longer(Silence a, Silence b) {
    return b.length().compareTo(a.length()) > 0 ? b : a;
  }

  /** Returns the longest time without an access to a robot since a time, of all robots. */
  Duration longestSilence(Instant since) {
    return silences(since).stream().map(Silence::length).max(Duration::compareTo).orElseThrow();
  }

  /** Returns the time from a fault to the end of the last robot's longest silence. */
  Duration back(Instant fault) {
    return silences(fault).stream()
        .filter(one -> one.length().toMillis() > 1000)
        .map(one -> Duration.between(fault, one.to()))
        .max(Duration::compareTo)
        .orElse(Duration.ZERO);
  }

  /** Returns whether each robot was accessed after a time. */
  boolean areReadSince(Instant time) {
    return servers.values().stream()
        .allMatch(
            server -> {
              List<RecordedRequest> requests = server.requests();
              return !requests.isEmpty() && requests.get(requests.size() - 1).time().isAfter(time);
            });
  }

  /**
   * Checks that no robot was accessed over an older connection after a newer one: two workers that
   * access it at the same time alternate.
   */
  void assertOneAtATime() {
    servers.forEach(
        (name, server) ->
            assertThat(server.requests())
                .as("the connections that accessed %s", name)
                .extracting(RecordedRequest::connection)
                .isSorted());
  }

  @Override
  public void close() {
    servers.values().forEach(MockServer::close);
  }
}
