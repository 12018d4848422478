package no.hials.crosscom.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
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

  static void measure(int viewers, int seconds, int rows, PrintStream out)
      throws IOException, InterruptedException {
    try (TemporaryFolder folder = new TemporaryFolder("viewers");
        OtherProcess robot = new OtherProcess(PageViewers.class, "robot");
        OtherProcess others = new OtherProcess(PageViewers.class, "viewers")) {
      Robot cell =
          new Robot(
              "cell", "127.0.0.1", Integer.parseInt(robot.ask("port")), null, null, null, null);
      try (WebServer web =
          WebServer.start(
              WebConfig.create(cfg -> cfg.robots(List.of(cell)).folder(folder.path()).port(0)))) {
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
    }
  }

  private static void robot() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.recordedRequests(0))) {
      BufferedReader in = OtherProcess.input();
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        System.out.println(line.equals("port") ? server.port() : server.requestCount());
      }
    }
  }

  private static void viewers() throws IOException, InterruptedException {
    HttpClient http = HttpClient.newHttpClient();
    Counter counter = new Counter();
    BufferedReader in = OtherProcess.input();
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
    PageSocket.open(http, http, link, counter)
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
