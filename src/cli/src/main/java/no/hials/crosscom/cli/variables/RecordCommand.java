package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.Sample;
import no.hials.crosscom.cell.CsvRecording;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.JsonRecording;
import no.hials.crosscom.cell.OutputException;
import no.hials.crosscom.cell.Recording;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.TimeText;
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
      "Writes samples of variables to a file, as CSV or JSON Lines.",
      "It reads at a fixed period, until Ctrl-C."
    },
    footer = {
      "",
      "Every variable must be readable at the start, or no file is made. A connection that is lost"
          + " later is made again. Every sample is in the file at once. Ctrl-C (SIGINT) and"
          + " SIGTERM end it with exit code 0; if --for or --count ends it while the connection is"
          + " lost, the code is 4. If a reading takes longer than a period, the periods it missed"
          + " are left out and counted.",
      "",
      "CSV (RFC 4180, UTF-8): a row a sample. The columns:",
      "  time        when the reading began, by the clock of this computer:",
      "              2026-05-04T10:15:30.123456Z",
      "  seconds     the same, since the first sample",
      "  robot       whose row it is; only if several are recorded",
      "  $POS_ACT.X  a column for each number or text: a field, an element as",
      "              NAME[1], or the variable itself; cell1:$POS_ACT.X if several",
      "              robots are recorded. Numbers are as a KR C4 prints them, BOOL",
      "              is TRUE or FALSE, an ENUM has its #, a text has no quotes",
      "  access_ms   how long reading all variables took",
      "  status      empty if all went well, or notes with ; between them",
      "The columns of values are those that the variables have at the start, and stay. A field that"
          + " is not initialised then has none, and one that is not initialised later is empty.",
      "",
      "Notes in the column status:",
      "  missed N           N periods before this row were left out",
      "  gap N; why         a row without values stands for N readings that failed,",
      "                     as while the connection was lost; its time is that of the",
      "                     loss",
      "  dropped N          N samples before this row were lost, since the disk is",
      "                     too slow",
      "  no column for NAME a value that was not there at the start",
      "  anything else      why a variable, whose cells are empty, could not be read",
      "",
      "JSON Lines: a line a sample, as 'watch --json' prints it.",
      "",
      "Quoting: a shell replaces $NAME and takes [ ] for a pattern, so put names into single"
          + " quotes.",
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
      description = "The file to write; - for stdout. An existing file needs --yes.")
  private String out = "";

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      description = "csv or jsonl; if not given, jsonl for a FILE.jsonl, else csv.")
  private @Nullable String format;

  @Option(
      names = {"-y", "--yes"},
      order = 5,
      description = "Overwrite FILE.")
  private boolean yes;

  @Override
  public ExitCode run() throws IOException {
    boolean jsonLines = isJsonLines();
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

  private Recording open(boolean jsonLines, Sampling sampling) throws FileException {
    Recording.RecordingOutput sink =
        out.equals(STDOUT) ? new StdoutSink(console()) : FileSink.open(out, yes);
    return jsonLines ? new JsonRecording(sink) : new CsvRecording(sink, sampling.robots());
  }

  /** Returns a summary of each robot. */
  private String summary(Sampling sampling) {
    String to = out.equals(STDOUT) ? "" : " to " + out;
    return sampling.robots().stream()
        .map(robot -> robot.label() + robot.summary())
        .collect(Collectors.joining("; ", "recorded" + to + ": ", ""));
  }

  /** Writes the samples and shows how it goes. */
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

  /** Writes to a file without a buffer, so that written data survives the end of this process. */
  private record FileSink(String name, OutputStream file) implements Recording.RecordingOutput {
    static FileSink open(String name, boolean overwrite) throws FileException {
      Path path = Path.of(name);
      boolean replaces = overwrite || (Files.exists(path) && !Files.isRegularFile(path));
      List<OpenOption> how =
          replaces
              ? List.of(
                  StandardOpenOption.WRITE,
                  StandardOpenOption.CREATE,
                  StandardOpenOption.TRUNCATE_EXISTING)
              : List.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW);
      try {
        return new FileSink(name, Files.newOutputStream(path, how.toArray(OpenOption[]::new)));
      } catch (IOException e) {
        throw FileException.cannot("write", path, e);
      }
    }

    @Override
    public void write(String text) {
      try {
        file.write(text.getBytes(StandardCharsets.UTF_8));
      } catch (IOException e) {
        throw new OutputException(name, e);
      }
    }

    @Override
    public void close() throws IOException {
      file.close();
    }
  }
}
