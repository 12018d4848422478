package no.hials.crosscom.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProxySelector;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlPrograms;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.WebServer;
import org.jspecify.annotations.Nullable;

/**
 * Cuts the connection of a page that jogs a simulated robot, again and again, and measures until
 * the robot is told to stand: the connection is reset, nothing is forwarded any more, or the
 * process of the page is frozen. After each of the last two it goes on, and nothing may move.
 */
public final class JogCuts {
  private static final long LIMIT_MILLIS = 250;
  private static final long WATCH_NANOS = 200_000;
  private static final Duration LONGEST = Duration.ofSeconds(10);
  private static final String[] KINDS = {"reset", "silent network", "frozen page"};

  private JogCuts() {}

  /**
   * Measures.
   *
   * @param args the number of cuts (default 100); or {@code page} for the other process
   */
  public static void main(String[] args) throws Exception {
    if (args.length > 0 && args[0].equals("page")) {
      Page.run();
    } else if (!measure(args.length > 0 ? Integer.parseInt(args[0]) : 100, System.out)) {
      System.exit(1);
    }
  }

  /**
   * A cut.
   *
   * @param command the time until the robot was told to stand, ms
   * @param braking the time from then until it stood, ms
   * @param pause the longest time meanwhile in which this process got no CPU, ms
   */
  private record Cut(String kind, double command, double braking, double pause, boolean resumed) {}

  /** Waits for conditions, and notes the longest pause of this process. */
  private static final class Watcher {
    private final long begin = System.nanoTime();
    private long last = begin;
    private long pause;

    /** Returns the ms since the beginning when a condition holds. */
    double await(BooleanSupplier condition) throws IOException {
      while (!condition.getAsBoolean()) {
        step();
        if (last - begin > LONGEST.toNanos()) {
          throw new IOException(
              "the robot still moves " + LONGEST.toSeconds() + " s after the cut");
        }
      }
      return (System.nanoTime() - begin) / 1e6;
    }

    private void step() {
      LockSupport.parkNanos(WATCH_NANOS);
      long now = System.nanoTime();
      pause = Math.max(pause, now - last - WATCH_NANOS);
      last = now;
    }
  }

  private static boolean measure(int cuts, PrintStream out) throws IOException {
    Robot cell = new Robot("cell", null, 0, null, null, null, null);
    List<MockServer> mocks = new ArrayList<>();
    List<Cut> done = new ArrayList<>();
    int lost = 0;
    try (TemporaryFolder folder = new TemporaryFolder("jogcuts");
        WebServer web =
            WebServer.start(
                WebConfig.create(
                    cfg ->
                        cfg.robots(List.of(cell))
                            .folder(folder.path())
                            .port(0)
                            .jogMaxDelay(Duration.ofSeconds(2)) // a pause is not a cut
                            .opener(
                                (robot, settings) -> {
                                  MockServer mock = MockServer.start(it -> it.recordedRequests(0));
                                  mocks.add(mock);
                                  return new RobotConnection(
                                      robot,
                                      RobotConnection.open(
                                              robot.at(mock.host(), mock.port()), settings)
                                          .client(),
                                      mock);
                                })));
        CuttableProxy proxy = new CuttableProxy(web.port());
        OtherProcess page = new OtherProcess(JogCuts.class, "page")) {
      MockServer mock = mocks.get(0);
      prepare(mock.controller());
      while (done.size() < cuts) {
        String direction = done.size() % 2 == 0 ? "plus" : "minus"; // along X only
        String answer = page.ask(direction + " " + proxy.port() + " " + web.link(Role.JOG));
        Cut cut =
            answer.equals("moving")
                ? cut(KINDS[done.size() % KINDS.length], mock, proxy, page)
                : null;
        if (cut != null) {
          done.add(cut);
        } else if (++lost > cuts) {
          throw new IOException("the robot does not move: " + answer);
        } else {
          prepare(mock.controller());
        }
      }
    }
    return report(done, lost, out);
  }

  private static void prepare(Controller robot) throws IOException {
    robot.robot().cancel();
    robot.submit().cancel();
    robot.confirmAll();
    KrlPrograms.start(robot, KrlPrograms.START, "actuator");
  }

  /** Cuts the connection; returns null if the robot did not move at that moment. */
  private static @Nullable Cut cut(
      String kind, MockServer mock, CuttableProxy proxy, OtherProcess page) throws IOException {
    BooleanSupplier told = () -> mock.variables().get("MYPOS").contains("X 0.0,");
    if (told.getAsBoolean()) {
      return null;
    }
    switch (kind) {
      case "reset" -> proxy.reset();
      case "silent network" -> proxy.silence(true);
      default -> page.freeze();
    }
    Watcher watcher = new Watcher();
    double command = watcher.await(told);
    double pause = watcher.pause / 1e6;
    double stood = watcher.await(() -> mock.controller().standing());
    proxy.silence(false);
    page.resume();
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(LIMIT_MILLIS);
    boolean resumed = false;
    while (System.nanoTime() < end) {
      resumed |= !told.getAsBoolean();
      LockSupport.parkNanos(WATCH_NANOS);
    }
    return new Cut(kind, command, stood - command, pause, resumed);
  }

  private static boolean report(List<Cut> cuts, int lost, PrintStream out) {
    boolean good = true;
    for (String kind : KINDS) {
      List<Cut> own = cuts.stream().filter(it -> it.kind().equals(kind)).toList();
      if (!own.isEmpty()) {
        good &= report(kind, own, out);
      }
    }
    good &= report("all", cuts, out);
    cuts.stream()
        .filter(it -> it.command() > LIMIT_MILLIS)
        .forEach(
            it ->
                out.printf(
                    Locale.ROOT,
                    "too late: %s, %.0f ms, in which this process paused for up to %.0f ms%n",
                    it.kind(),
                    it.command(),
                    it.pause()));
    out.printf(Locale.ROOT, "not counted, because the robot did not move at the cut: %d%n", lost);
    return good;
  }

  private static boolean report(String kind, List<Cut> cuts, PrintStream out) {
    List<Double> commands = cuts.stream().map(Cut::command).sorted().toList();
    List<Double> brakings = cuts.stream().map(Cut::braking).sorted().toList();
    long inTime = commands.stream().filter(it -> it <= LIMIT_MILLIS).count();
    long resumed = cuts.stream().filter(Cut::resumed).count();
    out.printf(
        Locale.ROOT,
        "%s: %d of %d told to stand within %d ms: median %.0f ms, maximum %.0f ms; then braking:"
            + " median %.0f ms, maximum %.0f ms; moved again: %d%n",
        kind,
        inTime,
        cuts.size(),
        LIMIT_MILLIS,
        commands.get(commands.size() / 2),
        commands.get(commands.size() - 1),
        brakings.get(brakings.size() / 2),
        brakings.get(brakings.size() - 1),
        resumed);
    return inTime == cuts.size() && resumed == 0;
  }

  /** The page, without a browser: holds a button until its connection is lost. */
  private static final class Page implements WebSocket.Listener {
    private static final int BEAT_MILLIS = 50;
    private static final Pattern MARK = Pattern.compile("\"mark\":(\\d+)");
    private static final Pattern CLOCK = Pattern.compile("^\\{\"id\":0,.*\"clock\":(\\d+)");
    private static final Pattern ERROR = Pattern.compile("\"error\":\"([^\"]*)\"");

    private final CountDownLatch decided = new CountDownLatch(1);
    private final StringBuilder part = new StringBuilder();
    private volatile long mark = -1;
    private volatile long clock;
    private volatile String result = "not moving within 10 s";
    private volatile @Nullable ScheduledFuture<?> beats;
    private int beat;

    static void run() throws IOException, InterruptedException {
      HttpClient http = HttpClient.newHttpClient();
      ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
      BufferedReader in = OtherProcess.input();
      WebSocket last = null;
      Page page = null;
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (last != null && page != null) {
          page.end();
          last.abort();
        }
        page = new Page();
        String[] words = line.split(" ", 3);
        ProxySelector proxy =
            ProxySelector.of(
                new InetSocketAddress(
                    InetAddress.getLoopbackAddress(), Integer.parseInt(words[1])));
        HttpClient proxied = HttpClient.newBuilder().proxy(proxy).build();
        last = PageSocket.open(http, proxied, words[2], page);
        System.out.println(page.hold(last, timer, words[0].equals("plus")));
      }
      System.exit(0); // the timer still runs
    }

    private String hold(WebSocket socket, ScheduledExecutorService timer, boolean positive)
        throws InterruptedException {
      send(socket, "\"id\":0,\"do\":\"ping\"");
      if (!answered.await(LONGEST.toSeconds(), TimeUnit.SECONDS)) {
        return "no answer to ping";
      }
      String now = ",\"clock\":" + clock;
      send(socket, "\"id\":1,\"do\":\"lock\",\"robot\":\"cell\",\"locked\":false" + now);
      send(socket, "\"id\":2,\"do\":\"jog-ask\",\"robot\":\"cell\"");
      send(
          socket,
          "\"id\":3,\"do\":\"jog-open\",\"robot\":\"cell\",\"space\":\"base\",\"confirmed\":true"
              + now);
      if (!opened.await(LONGEST.toSeconds(), TimeUnit.SECONDS)) {
        return "no answer to jog-open";
      }
      send(
          socket,
          "\"id\":4,\"do\":\"jog-press\",\"robot\":\"cell\",\"hold\":1,\"direction\":0,"
              + "\"positive\":"
              + positive
              + ",\"percent\":50,\"step\":0");
      beats = timer.scheduleAtFixedRate(() -> beat(socket), 0, BEAT_MILLIS, TimeUnit.MILLISECONDS);
      boolean unused = decided.await(LONGEST.toSeconds(), TimeUnit.SECONDS);
      return result;
    }

    private final CountDownLatch answered = new CountDownLatch(1);
    private final CountDownLatch opened = new CountDownLatch(1);

    private void beat(WebSocket socket) {
      if (mark >= 0) {
        send(
            socket,
            "\"id\":5,\"do\":\"jog-beat\",\"robot\":\"cell\",\"hold\":1,\"beat\":"
                + ++beat
                + ",\"mark\":"
                + mark);
      }
    }

    private static void send(WebSocket socket, String fields) {
      socket.sendText("{" + fields + "}", true).join();
    }

    private void end() {
      ScheduledFuture<?> running = beats;
      if (running != null) {
        running.cancel(false);
      }
    }

    private void decide(String words) {
      result = words;
      answered.countDown();
      opened.countDown();
      decided.countDown();
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean isLast) {
      part.append(data);
      if (isLast) {
        String text = part.toString();
        part.setLength(0);
        Matcher error = ERROR.matcher(text);
        Matcher newMark = MARK.matcher(text);
        Matcher newClock = CLOCK.matcher(text);
        if (newClock.find()) {
          clock = Long.parseLong(newClock.group(1));
          answered.countDown();
        } else if (text.startsWith("{\"id\":3,") && text.contains("\"ok\"")) {
          opened.countDown();
        } else if (text.startsWith("{\"id\":") && error.find()) {
          end();
          decide(error.group(1));
        } else if (text.startsWith("{\"id\":") && newMark.find()) {
          mark = Math.max(mark, Long.parseLong(newMark.group(1)));
          if (text.contains("\"moving\":true")) {
            decide("moving");
          }
        }
      }
      from.request(1);
      return null;
    }
  }
}
