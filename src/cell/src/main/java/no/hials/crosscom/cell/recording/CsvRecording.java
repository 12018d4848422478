package no.hials.crosscom.cell.recording;

import de.siegmar.fastcsv.writer.CsvWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Writes a CSV file (RFC 4180) with a row for each sample and a column for each number, as the help
 * of {@code record} describes it. {@link RecordedData} reads it.
 */
public final class CsvRecording implements Recording {
  private final RecordingOutput output;
  private final List<SampledRobot> robots;
  private final boolean severalRobots;
  private final boolean raw;

  /** The columns of values and their indices in a row. */
  private final Map<String, Integer> columns = new LinkedHashMap<>();

  private final Map<SampledRobot, Past> pasts = new HashMap<>();

  /** The time of the last row; rows of several robots are in the order of their times. */
  private Instant latest = Instant.MIN;

  private final StringWriter row = new StringWriter();
  private final CsvWriter csv = CsvWriter.builder().build(row);

  /** The state before the next sample. */
  private static final class Past {
    long number;
    @Nullable Instant time;

    /** The loss of the connection since the last sample. */
    @Nullable ConnectionEvent lost;

    /** Returns whether a loss is already recorded, since a sample followed it. */
    boolean isOld(ConnectionEvent loss) {
      return time != null && loss.time().isBefore(time);
    }
  }

  /**
   * Creates a recording with the columns of the first reading of the robots.
   *
   * @param robots the robots, which must have been read once
   * @param raw whether to write texts exactly, see {@link CsvText}
   */
  public CsvRecording(RecordingOutput output, List<SampledRobot> robots, boolean raw) {
    this.output = output;
    this.robots = robots;
    this.raw = raw;
    this.severalRobots = robots.size() > 1;
    int column = severalRobots ? 3 : 2;
    for (SampledRobot robot : robots) {
      pasts.put(robot, new Past());
      for (Map.Entry<String, KrlValue> value : robot.first().entrySet()) {
        for (Leaf leaf : Leaf.of(value.getKey(), value.getValue())) {
          if (columns.putIfAbsent(column(robot, leaf), column) == null) {
            column++;
          }
        }
      }
    }
  }

  private String column(SampledRobot robot, Leaf leaf) {
    return severalRobots ? robot.qualified(leaf.name()) : leaf.name();
  }

  private Past past(SampledRobot robot) {
    return pasts.computeIfAbsent(robot, key -> new Past());
  }

  @Override
  public void begin() {
    List<String> header = new ArrayList<>(List.of(RecordedData.TIME, RecordedData.SECONDS));
    if (severalRobots) {
      header.add(RecordedData.ROBOT);
    }
    header.addAll(columns.keySet());
    header.add(RecordedData.ACCESS);
    header.add(RecordedData.STATUS);
    write(header);
  }

  @Override
  public void add(SampledRobot robot, Sample sample, Duration since) {
    Past past = past(robot);
    if (sample.hasGapBefore()) {
      writeGap(robot, sample.failedPolls(), gapFrom(past, sample.time()), since, sample.time());
    }
    String[] cells = cells(robot, sample.time(), since);
    List<String> notes = new ArrayList<>();
    if (sample.number() > past.number + 1) {
      notes.add("dropped " + (sample.number() - past.number - 1));
    }
    if (sample.missedPeriods() > 0) {
      notes.add("missed " + sample.missedPeriods());
    }
    for (Map.Entry<String, Reading> reading : sample.readings().entrySet()) {
      fill(cells, robot, reading.getKey(), reading.getValue(), notes);
    }
    cells[cells.length - 2] = TimeText.millis(sample.duration());
    cells[cells.length - 1] = String.join("; ", notes);
    write(Arrays.asList(cells));
    past.number = sample.number();
    past.time = sample.time();
    past.lost = null;
  }

  /** Creates a row without values. */
  private String[] cells(SampledRobot robot, Instant time, Duration since) {
    latest = time;
    String[] cells = new String[columns.size() + (severalRobots ? 5 : 4)];
    Arrays.fill(cells, "");
    cells[0] = TimeText.instant(time);
    cells[1] = TimeText.seconds(since);
    if (severalRobots) {
      cells[2] = robot.name();
    }
    return cells;
  }

  private void fill(
      String[] cells, SampledRobot robot, String name, Reading reading, List<String> notes) {
    CrossComException failure = reading.failure();
    if (failure != null) {
      notes.add(failure.getMessage());
      return;
    }
    KrlValue value = reading.value();
    if (value == null) {
      return;
    }
    for (Leaf leaf : Leaf.of(name, value)) {
      Integer column = columns.get(column(robot, leaf));
      if (column == null) {
        notes.add("no column for " + leaf.name());
      } else {
        cells[column] = leaf.text();
      }
    }
  }

  private static Instant gapFrom(Past past, Instant now) {
    if (past.lost != null) {
      return past.lost.time();
    }
    return past.time == null ? now : past.time;
  }

  /** Writes a row for the failed readings, so that a plot shows a gap. */
  private void writeGap(
      SampledRobot robot, long failed, Instant from, Duration sinceNow, Instant now) {
    ConnectionEvent lost = past(robot).lost;
    CrossComException cause = lost == null ? null : lost.cause();
    boolean late = from.isBefore(latest);
    Instant time = late ? latest : from;
    String[] cells = cells(robot, time, sinceNow.minus(Duration.between(time, now)));
    cells[cells.length - 1] =
        "gap "
            + failed
            + (late ? " since " + TimeText.instant(from) : "")
            + (cause == null ? "" : "; " + cause.getMessage());
    write(Arrays.asList(cells));
  }

  @Override
  public void connectionChanged(SampledRobot robot, ConnectionEvent event) {
    Past past = past(robot);
    // the gap begins at the first loss
    if (event.kind() == ConnectionChange.LOST && past.lost == null && !past.isOld(event)) {
      past.lost = event;
    }
  }

  @Override
  public void end(Sampling sampling) {
    for (SampledRobot robot : robots) {
      if (robot.failedSinceSample() > 0) {
        Instant now = Instant.now();
        Instant from = gapFrom(past(robot), now);
        writeGap(robot, robot.failedSinceSample(), from, sampling.since(from), from);
      }
    }
  }

  private void write(List<String> fields) {
    try {
      csv.writeRecord(raw ? fields : fields.stream().map(CsvText::guarded).toList()).flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    output.write(row.toString());
    row.getBuffer().setLength(0);
  }

  @Override
  public void close() throws IOException {
    csv.close();
    output.close();
  }
}
