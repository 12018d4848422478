package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Locale;
import java.util.stream.Collectors;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.Sample;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.cell.recording.CsvRecording;
import no.hials.crosscom.cell.recording.JsonRecording;
import no.hials.crosscom.cell.recording.Recording;
import no.hials.crosscom.cell.recording.RecordingFile;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LiveLine;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.Terminal;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code record}. */
@Command(
    name = "record",
    description = {
      "Records variables to a file, as CSV or JSON Lines.",
      "Reads at a fixed period until Ctrl-C."
    },
    footer = {
      "",
      "All variables must be readable at the start, otherwise no file is created. After a lost"
          + " connection, the command reconnects. Each sample is written immediately; with"
          + " several robots, in the order of their times, after at most 1 s. Ctrl-C (SIGINT) and"
          + " SIGTERM end the recording with exit code 0. If --for or --count ends it while the"
          + " connection is lost, the exit code is 4. If a reading takes longer than a period,"
          + " the missed periods are skipped and counted.",
      "",
      "CSV (RFC 4180, UTF-8): one row per sample. Columns:",
      "  time        start of the reading, by the clock of this computer:",
      "              2026-05-04T10:15:30.123456Z",
      "  seconds     the same, since the first sample of all robots",
      "  robot       name of the robot; only with several robots",
      "  $POS_ACT.X  one column for each number or text: a field, an element",
      "              NAME[1], or the variable itself; with several robots",
      "              cell1:$POS_ACT.X. Numbers are as on a KR C4, BOOL",
      "              is TRUE or FALSE, an ENUM begins with #, a text has no quotes",
      "  access_ms   duration of the reading of all variables",
      "  status      empty, or notes separated by ;",
      "The columns are set at the start. A field that is not initialised at the start has no"
          + " column; a field that is not initialised later is empty. Control characters are"
          + " written as \\x1B. A text that a spreadsheet would take for a formula, as it begins"
          + " with = + - @, tab or CR, has an apostrophe before it; so has such a part after a"
          + " semicolon. Only one command can record to a file.",
      "",
      "Notes in the status column:",
      "  missed N           N periods before this row were skipped",
      "  gap N; REASON      a row without values, for N failed readings before the",
      "                     next row of the robot; its time is when the",
      "                     connection was lost, or that of the row before it:",
      "                     gap N since TIME; REASON",
      "  dropped N          N samples before this row were lost, because the disk is",
      "                     too slow",
      "  no column for NAME a field that was not initialised at the start",
      "  other text         why a variable could not be read; its cells are empty",
      "",
      "JSON Lines: one line per sample, in the form of 'watch --json'.",
      "",
      "Quoting: a shell replaces $NAME and [ ] patterns, so put names in single quotes.",
      "",
      "Examples:",
      "  jopenshowvar record '$POS_ACT' '$OV_PRO' --out run.csv --host 172.31.1.147",
      "  jopenshowvar record '$AXIS_ACT' --period 20ms --for 1m --out axes.csv --mock",
      "  jopenshowvar record '$TORQUE_AXIS_ACT[]' --count 100 --out - --mock | head"
    })
public final class RecordCommand extends SamplingCommand {
  private static final String STDOUT = "-";

  @Option(
      names = {"-o", "--out"},
      required = true,
      paramLabel = "FILE",
      description = "The file to write, or - for stdout. An existing file needs --yes.")
  private String out = "";

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      description = "csv or jsonl. Default: jsonl if FILE ends with .jsonl, otherwise csv.")
  private @Nullable String format;

  @Option(
      names = "--raw",
      description =
          "Write texts to CSV exactly, without escapes and without an apostrophe before formulas.")
  private boolean raw;

  @Option(
      names = {"-y", "--yes"},
      order = 5,
      description = "Overwrite FILE.")
  private boolean yes;

  @Override
  public ExitCode run() throws IOException {
    boolean jsonLines = isJsonLines();
    if (raw && jsonLines) {
      throw wrongUsage("--raw goes with csv; JSON has the exact texts");
    }
    if (!out.equals(STDOUT)) {
      LocalFiles.checkNew(LocalFiles.path(this, out), yes);
    }
    try (StopSignal stop = new StopSignal();
        Sampling sampling = sampling()) {
      ExitCode first = readFirst(sampling);
      if (first != ExitCode.DONE) {
        return first;
      }
      try (Recording recording = open(jsonLines, sampling);
          LiveLine line = new LiveLine(console().err(), !isVerbose() && Terminal.showsProgress())) {
        recording.begin();
        ExitCode result = run(sampling, false, stop, new Recorder(sampling, recording, line));
        recording.end(sampling);
        line.clear();
        console().hint(summary(sampling));
        return result;
      }
    }
  }

  private boolean isJsonLines() {
    if (format == null) {
      return out.toLowerCase(Locale.ROOT).endsWith(".jsonl");
    }
    if (!format.equalsIgnoreCase("csv") && !format.equalsIgnoreCase("jsonl")) {
      throw wrongUsage("--format must be csv or jsonl, is " + format);
    }
    return format.equalsIgnoreCase("jsonl");
  }

  private Recording open(boolean jsonLines, Sampling sampling) {
    Recording.RecordingOutput sink =
        out.equals(STDOUT) ? new StdoutSink(console()) : RecordingFile.open(Path.of(out), out, yes);
    return jsonLines ? new JsonRecording(sink) : new CsvRecording(sink, sampling.robots(), raw);
  }

  /** Returns a summary of each robot. */
  private String summary(Sampling sampling) {
    String to = out.equals(STDOUT) ? "" : " to " + out;
    return sampling.robots().stream()
        .map(robot -> robot.label() + robot.summary())
        .collect(Collectors.joining("; ", "recorded" + to + ": ", ""));
  }

  /** Writes the samples and shows the progress. */
  private final class Recorder implements Sampling.Listener {
    private final Sampling sampling;
    private final Recording recording;
    private final LiveLine line;

    Recorder(Sampling sampling, Recording recording, LiveLine line) {
      this.sampling = sampling;
      this.recording = recording;
      this.line = line;
    }

    @Override
    public void sampled(SampledRobot robot, Sample sample) {
      recording.add(robot, sample, sampling.since(sample.time()));
    }

    @Override
    public void connectionChanged(SampledRobot robot, ConnectionEvent event) {
      recording.connectionChanged(robot, event);
      if (event.kind() == ConnectionChange.LOST || event.kind() == ConnectionChange.RECONNECTED) {
        line.clear();
        console().error(robot.label() + SampledRobot.text(event));
      }
    }

    @Override
    public boolean tick() {
      if (line.isDue()) {
        line.show(
            TimeText.roughSeconds(sampling.since(Instant.now()))
                + " s | "
                + sampling.robots().stream()
                    .map(robot -> robot.label() + robot.summary())
                    .collect(Collectors.joining(" | ")));
      }
      return true;
    }
  }

  /** Writes to stdout. */
  private record StdoutSink(Console console) implements Recording.RecordingOutput {
    @Override
    public void write(String text) {
      console.write(text);
    }

    @Override
    public void close() {
      // stdout is not ours
    }
  }
}
