package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.gateway.GatewayMain;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The dashboard and the alerts of {@code examples/gateway} on Debian's Prometheus, which reads a
 * gateway with two simulated robots and all outputs. Its broker does not run.
 */
@Timeout(120)
class PrometheusIT {
  private static final Path EXAMPLES = Path.of("../../examples/gateway").toAbsolutePath();
  private static final Path PROMTOOL = Path.of("/usr/bin/promtool");
  private static final Pattern ENDPOINT = Pattern.compile("Prometheus: (http://\\S+/metrics)");
  private static final Pattern PLACEHOLDER = Pattern.compile("\\{\\{(\\w+)}}");
  private static final List<String> ROBOTS = List.of("mock1", "mock2");

  @TempDir private static Path folder;
  private static OutputLines gateway;
  private static Prometheus prometheus;
  private static URI endpoint;

  @BeforeAll
  static void start() throws Exception {
    Prometheus.assume();
    int opcua;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      opcua = socket.getLocalPort();
    }
    Path config =
        Files.writeString(
            folder.resolve("plant.toml"),
            """
            [mqtt]
            url = "tcp://127.0.0.1:1"
            commands = true

            [opcua]
            address = "127.0.0.1:%d"
            """
                .formatted(opcua));
    gateway =
        OutputLines.of(
            new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                GatewayMain.class.getName(),
                "--config",
                config.toString(),
                "--mock",
                "2",
                "--prometheus",
                "127.0.0.1:0"));
    endpoint = URI.create(gateway.await(ENDPOINT));
    prometheus =
        new Prometheus(
            folder,
            Files.readString(EXAMPLES.resolve("prometheus.yml"))
                .replace("5s", "250ms")
                .replace("alerts.yml", EXAMPLES.resolve("alerts.yml").toString())
                .replace("127.0.0.1:9464", endpoint.getAuthority()));
  }

  @AfterAll
  static void close() {
    if (prometheus != null) {
      prometheus.close();
    }
    if (gateway != null) {
      gateway.close();
    }
  }

  private static JsonNode dashboard() throws Exception {
    return new ObjectMapper().readTree(EXAMPLES.resolve("grafana/dashboard.json").toFile());
  }

  private static Set<String> values(Iterable<JsonNode> series, String label) {
    Set<String> values = new TreeSet<>();
    series.forEach(one -> values.add(one.path("metric").path(label).asText()));
    return values;
  }

  @Test
  void eachQueryOfTheDashboardHasSeriesWithTheLabelsOfItsLegend() throws Exception {
    int queries = 0;
    for (JsonNode panel : dashboard().path("panels")) {
      for (JsonNode target : panel.path("targets")) {
        String legend = target.path("legendFormat").asText();
        String query = filled(target.path("expr").asText());
        List<String> labels = new ArrayList<>();
        PLACEHOLDER.matcher(legend).results().forEach(label -> labels.add(label.group(1)));

        JsonNode series = awaitSeries(query, labels.contains("robot") ? ROBOTS : List.of());

        for (JsonNode one : series) {
          assertThat(one.path("metric").fieldNames()).toIterable().as(query).containsAll(labels);
        }
        queries++;
      }
    }
    assertThat(queries).isGreaterThan(30);
  }

  /** Returns the query with the values of the variables that Grafana fills in. */
  private static String filled(String query) {
    assertThat(query).doesNotContainPattern("\\$(?!robot\\b|__rate_interval\\b|])");
    return query
        .replace("$robot", "(" + String.join("|", ROBOTS) + ")")
        .replace("$__rate_interval", "2s");
  }

  /** Returns the numbers of a query as soon as it has at least one for each of the robots. */
  private static JsonNode awaitSeries(String query, List<String> robots) throws Exception {
    while (true) {
      JsonNode series = prometheus.query(query);
      boolean hasNumbers =
          series.size() > 0
              && series.findValues("value").stream()
                  .noneMatch(it -> it.path(1).asText().equals("NaN"));
      if (hasNumbers && values(series, "robot").containsAll(robots)) {
        return series;
      }
    }
  }

  @Test
  void theVariableOfTheDashboardHasTheNamesOfTheRobots() throws Exception {
    Matcher query =
        Pattern.compile("label_values\\((\\w+), (\\w+)\\)")
            .matcher(
                dashboard().path("templating").path("list").path(1).path("definition").asText());
    assertThat(query.matches()).isTrue();

    awaitSeries(query.group(1), ROBOTS);
    JsonNode names =
        prometheus.get("label/" + query.group(2) + "/values?match[]=" + query.group(1));

    assertThat(names).extracting(JsonNode::asText).containsExactlyElementsOf(ROBOTS);
  }

  @Test
  void eachAlertIsEvaluatedAndOnlyTheBrokerIsAway() throws Exception {
    JsonNode rules;
    JsonNode broker;
    do {
      rules = prometheus.get("rules").path("groups").path(0).path("rules");
      broker = rule(rules, "BrokerAway");
    } while (!broker.path("state").asText().equals("pending")
        || !rule(rules, "RobotAway").path("state").asText().equals("inactive"));

    assertThat(rules)
        .hasSizeGreaterThan(5)
        .allSatisfy(rule -> assertThat(rule.path("health").asText()).isEqualTo("ok"));
    assertThat(broker.path("alerts").path(0).path("labels").path("instance").asText())
        .isEqualTo(endpoint.getAuthority());
  }

  private static JsonNode rule(JsonNode rules, String name) {
    for (JsonNode rule : rules) {
      if (rule.path("name").asText().equals(name)) {
        return rule;
      }
    }
    throw new AssertionError("no rule " + name);
  }

  @Test
  void promtoolHasNoObjectionToTheMetricsAndTheAlerts() throws Exception {
    if (!Files.isExecutable(PROMTOOL)) {
      System.out.println("skipped: " + PROMTOOL + " is not installed (apt install prometheus)");
      Assumptions.abort("promtool is not installed");
    }
    String metrics =
        HttpClient.newHttpClient()
            .send(HttpRequest.newBuilder(endpoint).build(), HttpResponse.BodyHandlers.ofString())
            .body();

    promtool(metrics, "check", "metrics");
    promtool("", "check", "rules", EXAMPLES.resolve("alerts.yml").toString());
  }

  private static void promtool(String input, String... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of(PROMTOOL.toString()));
    command.addAll(List.of(arguments));
    Path in = Files.writeString(folder.resolve("promtool.txt"), input);
    Process process =
        new ProcessBuilder(command).redirectErrorStream(true).redirectInput(in.toFile()).start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).as(output).isZero();
  }
}
