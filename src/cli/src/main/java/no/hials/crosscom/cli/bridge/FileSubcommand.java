package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.Printable;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Progress;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.StoppedException;
import no.hials.crosscom.cli.base.Terminal;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.WireCode;

/** The common parts of the commands of {@link FileCommand}. */
abstract class FileSubcommand extends BridgeCommand {
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss", Locale.ROOT);

  /** Does the work; the caller reports refusals of the controller. */
  abstract ExitCode work() throws IOException;

  @Override
  public final ExitCode run() throws IOException {
    try {
      return work();
    } catch (CrossComException e) {
      return failed(e);
    }
  }

  /**
   * Refuses a transfer without a source or target. Checked here, because picocli cannot count
   * parameters with options between them.
   *
   * @param names the names of the arguments
   */
  final void checkBothGiven(String names, List<String> arguments) {
    if (arguments.size() < 2) {
      throw wrongUsage("needs " + names + ", there is only " + arguments.get(0));
    }
  }

  /** Reports a failure with possible reasons. */
  final ExitCode failed(CrossComException e) {
    if (e instanceof CrossComRefusedException refused) {
      return refused(refused, "likely cause: file or folder not found");
    }
    console().failure(e, isVerbose());
    if (e instanceof CrossComUnsupportedException none
        && none.getServer() == ServerType.KUKAVARPROXY) {
      console().hint("KUKAVARPROXY has no files: that needs C3 Bridge Interface on the controller");
    }
    return ExitCode.of(e);
  }

  /** Transfers a file. */
  @FunctionalInterface
  interface Transfer<J> {
    public void run(J job, StopSignal stop) throws IOException;
  }

  /**
   * Transfers one file after the other, until the end, a failure, or the user stops it.
   *
   * @param participle the operation on the remaining files, as in {@code not uploaded}
   */
  final <J> ExitCode transfer(
      String participle, List<J> jobs, Function<J, String> name, Transfer<J> transfer)
      throws IOException {
    List<String> rest = new ArrayList<>(jobs.stream().map(name).toList());
    try (StopSignal stop = new StopSignal()) {
      for (J job : jobs) {
        stop.check();
        transfer.run(job, stop);
        rest.remove(0);
      }
      // nothing may come after it either
      stop.check();
      return ExitCode.DONE;
    } catch (CrossComException e) {
      ExitCode code = failed(e);
      hintOfRest(participle, rest.subList(1, rest.size()));
      return code;
    } catch (StoppedException e) {
      console().failure(e, isVerbose());
      hintOfRest(participle, rest);
      return ExitCode.STOPPED;
    }
  }

  /** Creates the line that shows how far a transfer has come. */
  final Progress progress(String name, StopSignal stop) {
    return new Progress(console(), name, !isVerbose() && Terminal.showsProgress(), stop);
  }

  /** Prints a transferred file. */
  final void print(String command, Path local, String remote) throws IOException {
    long size = Files.size(local);
    boolean up = command.equals("put");
    String from = up ? local.toString() : remote;
    String to = up ? remote : local.toString();
    String line = from + " -> " + to + ", " + Printable.count(size, "byte");
    console()
        .printChange(
            line,
            isJson()
                ? JsonLine.object(
                    json -> {
                      json.writeStringField("command", command);
                      json.writeStringField("local", local.toString());
                      json.writeStringField("name", remote);
                      json.writeNumberField("size", size);
                    })
                : line);
  }

  /** Prints the remaining files, if any. */
  final void hintOfRest(String participle, List<String> names) {
    if (!names.isEmpty()) {
      console().hint("not " + participle + ": " + String.join(" ", names));
    }
  }

  @Override
  String accessHint() {
    return "likely cause: it already exists, is read-only, or belongs to the selected program"
        + " ('jopenshowvar program cancel' ends that)";
  }

  final List<String> checked(String label, List<String> names) {
    names.forEach(name -> checked(label, name));
    return names;
  }

  /** Returns whether a name is a folder, by its form or because the folder exists. */
  static boolean isFolder(ControllerFiles files, String name) throws IOException {
    if (RemoteName.isFolder(name)) {
      return true;
    }
    try {
      return files.getProperties(name).isDirectory();
    } catch (CrossComRefusedException e) {
      if (e.getErrorCode().orElse(null) == ErrorCode.GENERAL) {
        return false;
      }
      throw e;
    }
  }

  // printing

  /** Returns a code such as {@code virtual directory}. */
  static <E extends Enum<E> & WireCode> String words(Code<E> code) {
    return words(code.toString());
  }

  /** Returns the known attributes, and the others in hex; that of a directory is its type. */
  static List<String> attributes(Flags<FileAttribute> flags) {
    List<String> known =
        new ArrayList<>(
            flags.known().stream()
                .filter(flag -> flag != FileAttribute.DIRECTORY)
                .map(flag -> flag.name().toLowerCase(Locale.ROOT).replace('_', '-'))
                .toList());
    if (flags.unknown() != 0) {
      known.add("0x" + Integer.toHexString(flags.unknown()));
    }
    return known;
  }

  /** Returns a time in the time zone of this computer. */
  static String time(Optional<Instant> time) {
    return time.map(instant -> TIME.format(instant.atZone(ZoneId.systemDefault()))).orElse("");
  }
}
