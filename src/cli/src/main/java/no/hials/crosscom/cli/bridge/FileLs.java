package no.hials.crosscom.cli.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.FileInfo;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ItemType;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code file ls [FOLDER]}. */
@Command(
    name = "ls",
    description = "Lists a folder of the controller: type, size, attributes and name of each item.",
    footer = {
      "",
      "The items are in the order of the controller. Unknown values are shown as -. Times are in"
          + " the time zone of this computer. If the list is too long for one answer, the command"
          + " asks for names only, and if that is still too long, for each type of item"
          + " separately.",
      "",
      "JSON: one object per item (JSON Lines) with name, path, type, size and attributes (an"
          + " array); with -l also created and modified in UTC. Unknown values are null.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file ls --host 172.31.1.147",
      "  jopenshowvar file ls -l 'KRC:\\R1\\PROGRAM' --host 172.31.1.147",
      "  jopenshowvar file ls /R1/System --json --mock | jq .name"
    })
final class FileLs extends FileSubcommand {
  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "FOLDER",
      description = "The folder. Default: KRC:\\R1.")
  private String folder = "KRC:\\R1";

  @Option(
      names = {"-l", "--long"},
      description = "Show the time of the last change; this sends one more request per item.")
  private boolean detailed;

  /** An item of the list, and its properties. */
  private record Item(FileEntry entry, String path, @Nullable FileInfo info) {
    String type() {
      return info != null ? words(info.type()) : entry.type().map(FileLs::words).orElse("");
    }

    @Nullable Long size() {
      if (entry.isDirectory() || (info != null && info.isDirectory())) {
        return null;
      }
      if (info != null) {
        return info.size();
      }
      return entry.size().isPresent() ? entry.size().getAsLong() : null;
    }

    @Nullable List<String> attributes() {
      return info != null
          ? FileSubcommand.attributes(info.attributes())
          : entry.attributes().map(FileSubcommand::attributes).orElse(null);
    }
  }

  @Override
  ExitCode work() throws IOException {
    checked("FOLDER", folder);
    try (RobotConnection controller = open()) {
      ControllerFiles files = controller.client().files();
      List<Item> items = new ArrayList<>();
      for (FileEntry entry : list(files)) {
        String path = RemoteName.in(folder, entry.name());
        items.add(new Item(entry, path, detailed ? properties(files, path) : null));
      }
      if (isJson()) {
        items.forEach(item -> console().print(JsonLine.object(json -> write(json, item))));
      } else {
        print(items);
      }
    }
    return ExitCode.DONE;
  }

  private List<FileEntry> list(ControllerFiles files) throws IOException {
    try {
      return files.list(folder);
    } catch (CrossComRefusedException e) {
      throwUnlessTooLong(e);
    }
    try {
      return files.list(folder, Set.of(), Set.of());
    } catch (CrossComRefusedException e) {
      throwUnlessTooLong(e);
    }
    return listByType(files);
  }

  private static void throwUnlessTooLong(CrossComRefusedException e) throws IOException {
    if (e.getErrorCode().orElse(null) != ErrorCode.LONG_ANSWER) {
      throw e;
    }
  }

  private List<FileEntry> listByType(ControllerFiles files) throws IOException {
    List<FileEntry> entries = new ArrayList<>();
    for (ItemType type : EnumSet.complementOf(EnumSet.of(ItemType.UNKNOWN))) {
      for (FileEntry entry : files.list(folder, Set.of(type), Set.of())) {
        entries.add(
            new FileEntry(
                entry.name(),
                Optional.of(Code.of(type)),
                entry.attributes(),
                entry.size(),
                entry.info()));
      }
    }
    console()
        .hint(
            "the list is too long for one answer: it was read type by type, without items of"
                + " unknown types");
    return entries;
  }

  /** Returns the properties; null if the item no longer exists. */
  private static @Nullable FileInfo properties(ControllerFiles files, String path)
      throws IOException {
    try {
      return files.getProperties(path);
    } catch (CrossComRefusedException e) {
      return null;
    }
  }

  private void write(JsonGenerator json, Item item) throws IOException {
    json.writeStringField("name", item.entry().name());
    json.writeStringField("path", item.path());
    json.writeStringField("type", item.type().isEmpty() ? null : item.type());
    json.writeObjectField("size", item.size());
    List<String> attributes = item.attributes();
    if (attributes == null) {
      json.writeNullField("attributes");
    } else {
      FileStat.writeArray(json, "attributes", attributes);
    }
    if (detailed) {
      Optional<FileInfo> info = Optional.ofNullable(item.info());
      FileStat.writeTime(json, "created", info.flatMap(FileInfo::created));
      FileStat.writeTime(json, "modified", info.flatMap(FileInfo::modified));
    }
  }

  private void print(List<Item> items) {
    Table table =
        detailed
            ? Table.withTitles("TYPE", "SIZE", "MODIFIED", "ATTRIBUTES", "NAME")
            : Table.withTitles("TYPE", "SIZE", "ATTRIBUTES", "NAME");
    for (Item item : items) {
      Long size = item.size();
      List<String> attributes = item.attributes();
      List<String> cells = new ArrayList<>();
      cells.add(item.type());
      cells.add(size == null ? "" : size.toString());
      if (detailed) {
        cells.add(time(Optional.ofNullable(item.info()).flatMap(FileInfo::modified)));
      }
      cells.add(attributes == null ? "" : String.join(",", attributes));
      cells.add(item.entry().name());
      table.add(cells.toArray(String[]::new));
    }
    table.print(console());
  }
}
