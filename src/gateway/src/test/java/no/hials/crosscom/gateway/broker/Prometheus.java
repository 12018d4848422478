package no.hials.crosscom.gateway.broker;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;

/** Debian's Prometheus on a free port of the loopback address. */
final class Prometheus implements AutoCloseable {
  private static final Path PROGRAM = Path.of("/usr/bin/prometheus");
  private static final Pattern LISTENING =
      Pattern.compile("msg=\"Listening on\" address=127\\.0\\.0\\.1:(\\d+)");
  private static final ObjectMapper JSON = new ObjectMapper();

  private final HttpClient http = HttpClient.newHttpClient();
  private final OutputLines output;
  private final int port;

  /**
   * Starts Prometheus.
   *
   * @param folder for its configuration and data
   */
  Prometheus(Path folder, String config) throws IOException {
    Path file = Files.writeString(folder.resolve("prometheus.yml"), config);
    output =
        OutputLines.of(
            new ProcessBuilder(
                PROGRAM.toString(),
                "--config.file=" + file,
                "--storage.tsdb.path=" + folder.resolve("tsdb"),
                "--web.listen-address=127.0.0.1:0"));
    port = Integer.parseInt(output.await(LISTENING));
  }

  /** Skips the test if Prometheus is not installed. */
  static void assume() {
    if (!Files.isExecutable(PROGRAM)) {
      System.out.println("skipped: " + PROGRAM + " is not installed (apt install prometheus)");
      Assumptions.abort("prometheus is not installed");
    }
  }

  /** Returns the data of an answer of its API; fails if it reports an error. */
  JsonNode get(String path) throws IOException, InterruptedException {
    HttpRequest request =
        HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/api/v1/" + path))
            .timeout(Duration.ofSeconds(10))
            .build();
    String body = http.send(request, HttpResponse.BodyHandlers.ofString()).body();
    JsonNode answer = JSON.readTree(body);
    if (!answer.path("status").asText().equals("success")) {
      throw new AssertionError(path + ": " + body);
    }
    return answer.path("data");
  }

  /** Returns the series of a query now. */
  JsonNode query(String promql) throws IOException, InterruptedException {
    return get("query?query=" + URLEncoder.encode(promql, StandardCharsets.UTF_8)).path("result");
  }

  @Override
  public void close() {
    output.close();
  }
}
