package no.hials.crosscom.cli.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileInfo;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Table;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code file stat NAME...}. */
@Command(
    name = "stat",
    description =
        "Prints the properties of files and folders: both forms of the name, type, size,"
            + " attributes, times and edit mode.",
    footer = {
      "",
      "If a file cannot be found, the remaining ones are still printed. Times are in the time"
          + " zone of this computer. Unknown values are shown as -.",
      "",
      "JSON: one object per file (JSON Lines) with name, path, krcName, type, size, attributes"
          + " (an array), created, accessed, modified (in UTC) and editMode. Unknown values are"
          + " null.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file stat /R1/WELD.SRC --host 172.31.1.147",
      "  jopenshowvar file stat 'KRC:\\R1\\System\\$config.dat' --mock --json"
    })
final class FileStat extends FileSubcommand {
  @Parameters(arity = "1..*", paramLabel = "NAME", description = "A file or folder.")
  private List<String> names = List.of();

  /** The properties and names of a file. */
  private record Details(FileInfo info, @Nullable String path, @Nullable String krcName) {}

  @Override
  ExitCode work() throws IOException {
    checked("NAME", names);
    ExitCode result = ExitCode.DONE;
    try (RobotConnection controller = open()) {
      ControllerFiles files = controller.client().files();
      boolean first = true;
      for (String name : names) {
        try {
          Details details =
              new Details(
                  files.getProperties(name),
                  orNull(() -> files.getFullName(name)),
                  orNull(() -> files.getKrcName(name)));
          print(details, first);
          first = false;
        } catch (CrossComRefusedException e) {
          result = result.orWorse(failed(e));
        }
      }
    }
    return result;
  }

  /** Asks for a name. */
  private interface Question {
    String ask() throws IOException;
  }

  private static @Nullable String orNull(Question question) throws IOException {
    try {
      return question.ask();
    } catch (CrossComRefusedException e) {
      return null;
    }
  }

  private void print(Details details, boolean first) {
    if (isJson()) {
      console().print(JsonLine.object(json -> write(json, details)));
      return;
    }
    if (!first) {
      console().print("");
    }
    FileInfo info = details.info();
    Table.ofValues()
        .add("name", info.name())
        .add("path", details.path() == null ? "" : details.path())
        .add("KRC name", details.krcName() == null ? "" : details.krcName())
        .add("type", words(info.type()))
        .add("size", Long.toString(info.size()))
        .add("attributes", String.join(",", attributes(info.attributes())))
        .add("created", time(info.created()))
        .add("accessed", time(info.accessed()))
        .add("modified", time(info.modified()))
        .add("edit mode", words(info.editMode()))
        .print(console());
  }

  private static void write(JsonGenerator json, Details details) throws IOException {
    FileInfo info = details.info();
    json.writeStringField("name", info.name());
    json.writeStringField("path", details.path());
    json.writeStringField("krcName", details.krcName());
    json.writeStringField("type", words(info.type()));
    json.writeNumberField("size", info.size());
    writeArray(json, "attributes", attributes(info.attributes()));
    writeTime(json, "created", info.created());
    writeTime(json, "accessed", info.accessed());
    writeTime(json, "modified", info.modified());
    json.writeStringField("editMode", words(info.editMode()));
  }

  static void writeArray(JsonGenerator json, String name, List<String> values) throws IOException {
    json.writeArrayFieldStart(name);
    for (String value : values) {
      json.writeString(value);
    }
    json.writeEndArray();
  }

  static void writeTime(JsonGenerator json, String name, Optional<Instant> time)
      throws IOException {
    json.writeStringField(name, time.map(Instant::toString).orElse(null));
  }
}
