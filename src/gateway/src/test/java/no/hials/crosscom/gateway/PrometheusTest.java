package no.hials.crosscom.gateway;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Predicate;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.StreamHandler;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.internal.prometheus.PrometheusKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class PrometheusTest {
  @KukaController private MockServer robot;
  @TempDir private Path folder;

  private final HttpClient http = HttpClient.newHttpClient();
  private final int port = freePort();
  private Gateway gateway;

  private static int freePort() {
    try (ServerSocket socket = new ServerSocket(0)) {
      return socket.getLocalPort();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @BeforeEach
  void start() throws IOException {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"
        timeout = "1s"

        [groups.all]
        variables = ["$OV_PRO", "$POS_ACT", "$MODE_OP", "NOSUCH"]
        period = "50ms"

        [groups.field]
        variables = ["$POS_ACT.X"]
        period = "70ms"

        [variables."$OV_PRO"]
        unit = "percent"

        [prometheus]
        address = "127.0.0.1:%d"
        """
            .formatted(robot.host(), robot.port(), port);
    List<OutputKind<?>> kinds = List.of(new PrometheusKind());
    TomlTable root = TomlTable.parse(Path.of("plant.toml"), text);
    gateway =
        Gateway.start(
            GatewayConfig.read(root, folder, Map.of(), kinds), kinds, RobotConnection::openLazily);
  }

  @AfterEach
  void close() {
    gateway.close();
  }

  private String await(Predicate<String> condition) throws IOException, InterruptedException {
    String text;
    do {
      text =
          http.send(
                  HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/metrics"))
                      .timeout(Duration.ofSeconds(10))
                      .build(),
                  HttpResponse.BodyHandlers.ofString())
              .body();
    } while (!condition.test(text));
    return text;
  }

  @Test
  void showsTheValuesAndTheConnectionOfARobot() throws Exception {
    robot.variables().set("$OV_PRO", "73");

    String metrics = await(text -> text.contains("variable=\"$OV_PRO\"} 73.0"));

    assertThat(metrics)
        .contains(
            "jopenshowvar_value{robot=\"cell1\",unit=\"percent\",variable=\"$OV_PRO\"} 73.0",
            "jopenshowvar_value{robot=\"cell1\",unit=\"mm\",variable=\"$POS_ACT.X\"}",
            "jopenshowvar_state{robot=\"cell1\",state=\"#T1\",variable=\"$MODE_OP\"} 1.0",
            "jopenshowvar_variable_good{robot=\"cell1\",variable=\"NOSUCH\"} 0.0",
            "jopenshowvar_robot_connected{robot=\"cell1\"} 1.0");
  }

  @Test
  void aFieldThatIsReadAloneAndWithItsStructureIsOneSeries() throws Exception {
    String metrics =
        await(
            text ->
                text.contains("variable=\"$POS_ACT.Y\"}")
                    && text.contains("variable_good{robot=\"cell1\",variable=\"$POS_ACT.X\"} 1.0"));

    assertThat(metrics.lines().filter(line -> line.contains("variable=\"$POS_ACT.X\"} 525.0")))
        .singleElement()
        .asString()
        .startsWith("jopenshowvar_value{");
  }

  @Test
  void showsTheTimesOfAccessesAndTheAgesOfValues() throws Exception {
    String access = "jopenshowvar_robot_access_seconds_";

    String metrics =
        await(text -> text.contains("variable_age_seconds{robot=\"cell1\",variable=\"$OV_PRO\"}"));

    double count = number(metrics, access + "count{robot=\"cell1\"} ");
    assertThat(count).isPositive();
    assertThat(number(metrics, access + "bucket{robot=\"cell1\",le=\"+Inf\"} ")).isEqualTo(count);
    // an access that takes no time counts as 1.152 µs
    assertThat(number(metrics, access + "sum{robot=\"cell1\"} "))
        .isGreaterThanOrEqualTo(count * 1.152e-6)
        .isLessThan(60);
    assertThat(metrics)
        .contains("jopenshowvar_robot_accesses_timed_out_total{robot=\"cell1\"} 0.0");
  }

  private static double number(String metrics, String series) {
    return metrics
        .lines()
        .filter(line -> line.startsWith(series))
        .mapToDouble(line -> Double.parseDouble(line.substring(series.length())))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no " + series + " in\n" + metrics));
  }

  @Test
  void showsNoValueWhileTheRobotDoesNotAnswer() throws Exception {
    await(text -> text.contains("variable=\"$OV_PRO\"} 100.0"));

    robot.refuseConnections();
    robot.disconnectClients();

    assertThat(await(text -> text.contains("robot_connected{robot=\"cell1\"} 0.0")))
        .doesNotContain("jopenshowvar_value{")
        .contains("jopenshowvar_variable_good{robot=\"cell1\",variable=\"$OV_PRO\"} 0.0");

    robot.acceptConnections();

    await(text -> text.contains("variable=\"$OV_PRO\"} 100.0"));
  }

  @Test
  void requestsThatDoNotEndAreCutOffAndDoNotStopOthers() throws Exception {
    List<Socket> halfOpen = new ArrayList<>();
    try {
      for (int i = 0; i < 20; i++) {
        Socket socket = new Socket();
        halfOpen.add(socket);
        socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 30_000);
        socket.setSoTimeout(30_000);
        socket.getOutputStream().write('G');
      }

      await(text -> text.contains("jopenshowvar_robot_connected{robot=\"cell1\"} 1.0"));

      assertThat(halfOpen.get(0).getInputStream().read()).isEqualTo(-1);
    } finally {
      for (Socket socket : halfOpen) {
        socket.close();
      }
    }
  }

  @Test
  void aScraperThatGoesAwayLogsNothing() throws Exception {
    Queue<LogRecord> records = new ConcurrentLinkedQueue<>();
    Handler handler =
        new StreamHandler() {
          @Override
          public synchronized void publish(LogRecord one) {
            records.add(one);
          }
        };
    Logger logger = Logger.getLogger("io.prometheus");
    logger.addHandler(handler);
    try {
      for (int i = 0; i < 100; i++) {
        try (Socket scraper = new Socket(InetAddress.getLoopbackAddress(), port)) {
          scraper.setSoLinger(true, 0);
          scraper
              .getOutputStream()
              .write("GET /metrics HTTP/1.1\r\nHost: x\r\n\r\n".getBytes(UTF_8));
        }
        String unused = await(text -> text.contains("cell1"));
      }
    } finally {
      logger.removeHandler(handler);
    }
    assertThat(records).isEmpty();
  }
}
