package no.hials.crosscom.examples;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;

/** Logs two angles to a CSV file, fifty times a second, and marks missing samples. */
public final class LogToCsv {
  private static final Duration PERIOD = Duration.ofMillis(20);
  private static final int SAMPLES = 20;
  private static final String[] NAMES = {"$AXIS_ACT.A1", "$AXIS_ACT.A2"};

  private LogToCsv() {}

  /**
   * Runs the example. The file is a temporary one, {@code axes...csv}.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller with one slow answer
   * @throws IOException if reading failed, or the file could not be written
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    if (Arguments.nameAController(args)) {
      log(args[0], Integer.parseInt(args[1]));
      return;
    }
    try (MockServer robot = MockServer.start()) {
      Fault slow = Fault.delay(Duration.ofMillis(70)); // longer than three periods
      robot.fault(request -> robot.requestCount() == 11, slow);
      log(robot.host(), robot.port());
    }
  }

  private static void log(String host, int port) throws IOException, InterruptedException {
    Path file = Files.createTempFile("axes", ".csv");
    BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();
    try (CrossComClient client = new CrossComClient(host, port);
        BufferedWriter csv = Files.newBufferedWriter(file)) {
      csv.write("time,a1_deg,a2_deg,missed\n");
      // the listener only queues: writing to a disk would delay the next listener
      try (Watch watch = client.watch(PERIOD, samples::add, NAMES)) {
        for (int i = 0; i < SAMPLES; i++) {
          csv.write(line(samples.take()));
        }
        System.out.println("missed periods: " + watch.missedPeriods());
      }
    }
    List<String> lines = Files.readAllLines(file);
    System.out.println((lines.size() - 1) + " samples in " + file + ", after a gap:");
    lines.stream().filter(line -> !line.endsWith(",0")).forEach(System.out::println);
  }

  /** Writes a gap as a count of missing samples, never as an invented value. */
  private static String line(Sample sample) throws IOException {
    return sample.time()
        + ","
        + sample.value(NAMES[0])
        + ","
        + sample.value(NAMES[1])
        + ","
        + (sample.missedPeriods() + sample.failedPolls())
        + "\n";
  }
}
