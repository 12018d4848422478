package no.hials.crosscom.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;

/**
 * Watches many robots in this process, each at a fixed period with one structure and one scalar,
 * and prints what that costs and how punctual the samples are.
 */
public final class ManyRobots {
  private static final Duration IN_TIME = Duration.ofMillis(20);

  /** Samples are counted from this time after the start. */
  private static final Duration WARM_UP = Duration.ofSeconds(10);

  private final PrintStream out;
  private final Duration period;
  private final AtomicLong samples = new AtomicLong();
  private final AtomicLong late = new AtomicLong();
  private volatile boolean counting;

  ManyRobots(PrintStream out, Duration period) {
    this.out = out;
    this.period = period;
  }

  /**
   * Measures.
   *
   * @param args the number of robots (default 1000), how many of them never answer (default 0), the
   *     seconds of the measurement (default 20)
   * @throws IOException if connecting fails
   * @throws InterruptedException if the thread is interrupted
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    int robots = args.length > 0 ? Integer.parseInt(args[0]) : 1000;
    int silent = args.length > 1 ? Integer.parseInt(args[1]) : 0;
    int seconds = args.length > 2 ? Integer.parseInt(args[2]) : 20;
    new ManyRobots(System.out, Duration.ofMillis(100)).run(robots, silent, WARM_UP, seconds);
  }

  /**
   * The samples of one robot. Their times are whole periods after the most punctual sample before
   * the measurement.
   */
  private final class Punctuality {
    private long punctual;

    void add(Sample sample) {
      long now = System.nanoTime();
      if (punctual == 0) {
        punctual = now;
      }
      long lateness = (now - punctual) % period.toNanos();
      boolean early = lateness > period.toNanos() / 2;
      if (!counting) {
        punctual = early ? now : punctual;
        return;
      }
      samples.incrementAndGet();
      if ((!early && lateness > IN_TIME.toNanos()) || sample.missedPeriods() > 0) {
        late.incrementAndGet();
      }
    }
  }

  /** Returns the share of samples in time, in percent. */
  double run(int robots, int silent, Duration warmUp, int seconds)
      throws IOException, InterruptedException {
    Process standIn = startStandIn();
    List<CrossComClient> clients = new ArrayList<>();
    List<Watch> watches = new ArrayList<>();
    try (BufferedReader line =
        new BufferedReader(
            new InputStreamReader(standIn.getInputStream(), StandardCharsets.US_ASCII))) {
      int answering = Integer.parseInt(line.readLine());
      int never = Integer.parseInt(line.readLine());
      for (int i = 0; i < robots; i++) {
        int port = i < silent ? never : answering;
        CrossComClient client =
            new CrossComClient(ClientConfig.create("127.0.0.1", cfg -> cfg.port(port)));
        clients.add(client);
        Punctuality punctuality = new Punctuality();
        watches.add(client.watch(period, punctuality::add, "$AXIS_ACT", "$OV_PRO"));
      }
      pause(warmUp);
      OperatingSystemMXBean system =
          (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
      long cpu = system.getProcessCpuTime();
      long start = System.nanoTime();
      counting = true;
      pause(Duration.ofSeconds(seconds));
      counting = false;
      double cores = (system.getProcessCpuTime() - cpu) / (double) (System.nanoTime() - start);
      double expected = (robots - silent) * seconds * 1e9 / period.toNanos();
      double inTime =
          100.0 * (samples.get() - late.get()) / Math.max((double) samples.get(), expected);
      out.printf(
          Locale.ROOT,
          "%d robots, %d of them silent, every %d ms: %d threads, %.0f MB resident, %.2f cores, "
              + "%d samples of %.0f, %.2f %% within %d ms of their time%n",
          robots,
          silent,
          period.toMillis(),
          ManagementFactory.getThreadMXBean().getThreadCount(),
          MockLoad.residentKibibytes() / 1024.0,
          cores,
          samples.get(),
          expected,
          inTime,
          IN_TIME.toMillis());
      return inTime;
    } finally {
      watches.forEach(Watch::close);
      for (CrossComClient client : clients) {
        client.close();
      }
      standIn.getOutputStream().close(); // its input ends, and so does it
      standIn.waitFor();
    }
  }

  private static void pause(Duration time) throws InterruptedException {
    boolean unused = new CountDownLatch(1).await(time.toMillis(), TimeUnit.MILLISECONDS);
  }

  private static Process startStandIn() throws IOException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    return new ProcessBuilder(
            java,
            "-Xmx256m",
            "-cp",
            System.getProperty("java.class.path"),
            RobotsStandIn.class.getName())
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }
}
