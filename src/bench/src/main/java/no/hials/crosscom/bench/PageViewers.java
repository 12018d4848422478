package no.hials.crosscom.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.WebServer;
import org.jspecify.annotations.Nullable;

/**
 * Runs the server of the web page in this process, a simulated robot in a second one and viewers in
 * a third one, each of which watches two structures at 10 Hz; prints what the server costs.
 */
public final class PageViewers {
  private static final int PERIOD_MILLIS = 100;
  private static final Pattern TOKEN = Pattern.compile("socket-token\" content=\"([^\"]+)\"");

  private PageViewers() {}

  /**
   * Measures.
   *
   * @param args the number of viewers (default 100), the seconds of a row (default 60), the number
   *     of rows (default 10); or {@code robot}, or {@code viewers}, for the other processes
   */
  public static void main(String[] args) throws Exception {
    String kind = args.length > 0 ? args[0] : "100";
    switch (kind) {
      case "robot" -> robot();
      case "viewers" -> viewers();
      default ->
          measure(
              Integer.parseInt(kind),
              args.length > 1 ? Integer.parseInt(args[1]) : 60,
              args.length > 2 ? Integer.parseInt(args[2]) : 10,
              System.out);
    }
  }

  private static void measure(int viewers, int seconds, int rows, PrintStream out)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("viewers");
    try (OtherProcess robot = new OtherProcess("robot");
        OtherProcess others = new OtherProcess("viewers")) {
      Robot cell =
          new Robot(
              "cell", "127.0.0.1", Integer.parseInt(robot.ask("port")), null, null, null, null);
      try (WebServer web =
          WebServer.start(
              WebConfig.create(cfg -> cfg.robots(List.of(cell)).folder(folder).port(0)))) {
        for (int i = 0; i < viewers; i++) {
          others.ask(web.link(Role.VIEW));
        }
        OperatingSystemMXBean system =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        for (int i = 0; i < rows; i++) {
          long cpu = system.getProcessCpuTime();
          long start = System.nanoTime();
          long samples = Long.parseLong(others.ask("count"));
          long requests = Long.parseLong(robot.ask("count"));
          boolean unused = new CountDownLatch(1).await(seconds, TimeUnit.SECONDS);
          double elapsed = System.nanoTime() - start;
          out.printf(
              Locale.ROOT,
              "%d viewers: %.2f cores, %.0f MB resident, %.1f samples a second each, "
                  + "%.1f requests to the robot a second%n",
              viewers,
              (system.getProcessCpuTime() - cpu) / elapsed,
              MockLoad.residentKibibytes() / 1024.0,
              (Long.parseLong(others.ask("count")) - samples) / (elapsed / 1e9) / viewers,
              (Long.parseLong(robot.ask("count")) - requests) / (elapsed / 1e9));
        }
      }
    } finally {
      Files.deleteIfExists(folder);
    }
  }

  /** A process of this class that answers each line with a line, until its input ends. */
  private static final class OtherProcess implements AutoCloseable {
    private final Process process;
    private final PrintWriter to;
    private final BufferedReader from;

    OtherProcess(String kind) throws IOException {
      process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  PageViewers.class.getName(),
                  kind)
              .redirectError(ProcessBuilder.Redirect.INHERIT)
              .start();
      to = new PrintWriter(process.outputWriter(StandardCharsets.US_ASCII), true);
      from = process.inputReader(StandardCharsets.US_ASCII);
    }

    String ask(String line) throws IOException {
      to.println(line);
      String answer = from.readLine();
      if (answer == null) {
        throw new IOException("the other process has ended");
      }
      return answer;
    }

    @Override
    public void close() {
      to.close();
      try {
        process.waitFor();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static BufferedReader input() {
    return new BufferedReader(new InputStreamReader(System.in, StandardCharsets.US_ASCII));
  }

  private static void robot() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.recordedRequests(0))) {
      BufferedReader in = input();
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        System.out.println(line.equals("port") ? server.port() : server.requestCount());
      }
    }
  }

  private static void viewers() throws IOException, InterruptedException {
    HttpClient http = HttpClient.newHttpClient();
    Counter counter = new Counter();
    BufferedReader in = input();
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      if (line.equals("count")) {
        System.out.println(counter.samples);
      } else {
        open(http, line, counter);
        System.out.println("open");
      }
    }
    System.exit(0); // the sockets are still open
  }

  private static void open(HttpClient http, String link, Counter counter)
      throws IOException, InterruptedException {
    URI address = URI.create(link);
    String cookie =
        http.send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.discarding())
            .headers()
            .firstValue("set-cookie")
            .orElseThrow()
            .replaceFirst(";.*", "");
    HttpResponse<String> page =
        http.send(
            HttpRequest.newBuilder(address.resolve("/")).header("Cookie", cookie).build(),
            HttpResponse.BodyHandlers.ofString());
    Matcher token = TOKEN.matcher(page.body());
    if (!token.find()) {
      throw new IOException("the page has no token for its socket");
    }
    http.newWebSocketBuilder()
        .header("Cookie", cookie)
        .header("Origin", "http://" + address.getAuthority())
        .buildAsync(
            URI.create("ws://" + address.getAuthority() + "/socket?page=" + token.group(1)),
            counter)
        .join()
        .sendText(
            "{\"id\":1,\"do\":\"watch\",\"robot\":\"cell\",\"list\":\"a\",\"period\":"
                + PERIOD_MILLIS
                + ",\"names\":[\"$AXIS_ACT\",\"$POS_ACT\"]}",
            true)
        .join();
  }

  /** Counts samples and drops them. */
  private static final class Counter implements WebSocket.Listener {
    private final AtomicLong samples = new AtomicLong();

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      if (data.toString().contains("\"samples\"")) {
        samples.incrementAndGet();
      }
      from.request(1);
      return null;
    }
  }
}
