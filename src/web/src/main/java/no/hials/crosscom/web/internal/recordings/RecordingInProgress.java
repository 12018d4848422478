package no.hials.crosscom.web.internal.recordings;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.Sample;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.recording.CsvRecording;
import no.hials.crosscom.cell.recording.JsonRecording;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cell.recording.Recording;
import no.hials.crosscom.cell.recording.RecordingFile;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A recording that is being written, in its own thread. It continues without any page, until it is
 * stopped or too long. Thread-safe.
 */
final class RecordingInProgress implements Sampling.Listener {
  private static final Logger LOG = LoggerFactory.getLogger(RecordingInProgress.class);

  /** The longest recording: some hours of 20 values at 50 Hz. */
  static final long MAX_CHARACTERS = 256L * 1024 * 1024;

  private static final long STATE_NANOS = 500_000_000;
  private static final int MAX_REASONS = 3;
  private static final long SECONDS_TO_END = 10;

  private final String file;
  private final RobotSession robot;
  private final Sampling sampling;
  private final Recording recording;
  private final Consumer<RecordingInProgress> listener;
  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean stopped;
  private final AtomicLong characters = new AtomicLong();
  private long told = System.nanoTime();

  // guarded by this
  private Duration length = Duration.ZERO;
  private long rows;
  private long missed;
  private long failed;
  private boolean lost;
  private String reason = "";

  private RecordingInProgress(
      RobotSession robot,
      Sampling sampling,
      Path path,
      boolean jsonLines,
      Consumer<RecordingInProgress> listener) {
    this.file = path.getFileName().toString();
    this.robot = robot;
    this.sampling = sampling;
    this.listener = listener;
    Recording.RecordingOutput output = new Limited(RecordingFile.open(path, file, false));
    recording =
        jsonLines ? new JsonRecording(output) : new CsvRecording(output, sampling.robots(), false);
  }

  /**
   * Reads all variables once and begins to record them.
   *
   * @param path the file, which must not exist
   * @param listener called several times a second, and when the recording has ended
   * @throws IOException if a variable cannot be read, or the file cannot be created
   */
  static RecordingInProgress start(
      RobotSession robot,
      Sampling.SamplingPlan plan,
      Path path,
      boolean jsonLines,
      Consumer<RecordingInProgress> listener)
      throws IOException {
    Sampling sampling = robot.sample(plan);
    try {
      List<Sampling.Failure> failures = sampling.readFirst();
      if (!failures.isEmpty()) {
        throw new CommandException(
            failures.stream()
                .limit(MAX_REASONS)
                .map(failure -> String.valueOf(failure.cause().getMessage()))
                .reduce((one, other) -> one + "; " + other)
                .orElse(""));
      }
      RecordingInProgress started =
          new RecordingInProgress(robot, sampling, path, jsonLines, listener);
      Thread thread = new Thread(started::run, "web-recording-" + started.file);
      thread.setDaemon(true);
      thread.start();
      return started;
    } catch (OutputException e) {
      robot.endSampling(sampling);
      throw new IOException(e.getMessage(), e);
    } catch (IOException | RuntimeException e) {
      robot.endSampling(sampling);
      throw e;
    }
  }

  private void run() {
    try (recording) {
      recording.begin();
      sampling.run(false, () -> stopped, this);
      recording.end(sampling);
    } catch (IOException | RuntimeException e) {
      LOG.warn("the recording {} ended: {}", file, e.toString());
      setReason(String.valueOf(e.getMessage()));
    }
    try {
      robot.endSampling(sampling);
    } catch (IOException e) {
      LOG.debug("the sampling is not closed", e);
    }
    ended.countDown();
    listener.accept(this);
  }

  /** Ends the recording and waits until the file is complete. */
  void stop() {
    stopped = true;
    try {
      if (!ended.await(SECONDS_TO_END, TimeUnit.SECONDS)) {
        LOG.warn("the recording {} still waits for an answer of the robot", file);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns whether the recording has ended. */
  boolean isEnded() {
    return ended.getCount() == 0;
  }

  /** Returns the name of the file. */
  String file() {
    return file;
  }

  /** Returns the state for the page. */
  synchronized ObjectNode json() {
    return Json.object()
        .put("file", file)
        .put("robot", robot.name())
        .put("running", !isEnded())
        .put("rows", rows)
        .put("seconds", length.toMillis() / 1e3)
        .put("missed", missed)
        .put("failed", failed)
        .put("lost", lost)
        .put("bytes", characters.get())
        .put("reason", reason);
  }

  private synchronized void setReason(String why) {
    reason = why;
  }

  @Override
  public void sampled(SampledRobot from, Sample sample) {
    Duration since = sampling.since(sample.time());
    recording.add(from, sample, since);
    synchronized (this) {
      rows++;
      length = since;
      missed += sample.missedPeriods();
      failed += sample.failedPolls();
      lost = false;
    }
  }

  @Override
  public void connectionChanged(SampledRobot from, ConnectionEvent event) {
    recording.connectionChanged(from, event);
    synchronized (this) {
      lost = from.isLost();
    }
  }

  @Override
  public boolean tick() {
    if (System.nanoTime() - told >= STATE_NANOS) {
      told = System.nanoTime();
      listener.accept(this);
    }
    if (characters.get() >= MAX_CHARACTERS) {
      setReason("it has reached " + MAX_CHARACTERS / (1024 * 1024) + " MiB");
      return false;
    }
    return true;
  }

  /** Counts the characters that are written. */
  private final class Limited implements Recording.RecordingOutput {
    private final Recording.RecordingOutput output;

    Limited(Recording.RecordingOutput output) {
      this.output = output;
    }

    @Override
    public void write(String text) {
      output.write(text);
      characters.addAndGet(text.length());
    }

    @Override
    public void close() throws IOException {
      output.close();
    }
  }
}
