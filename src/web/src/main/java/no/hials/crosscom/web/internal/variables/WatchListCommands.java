package no.hials.crosscom.web.internal.variables;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.DeviceNames;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps watch lists as text files in the folder {@code lists}, for all browsers. */
public final class WatchListCommands {
  private static final Logger LOG = LoggerFactory.getLogger(WatchListCommands.class);
  private static final int MAX_LISTS = 200;
  private static final int MAX_TEXT = 200_000;
  private static final String ENDING = ".txt";
  private static final Pattern NAME =
      Pattern.compile("[\\p{L}\\p{N}]([\\p{L}\\p{N} _-]{0,58}[\\p{L}\\p{N}])?");

  private final Path folder;
  private final Sockets sockets;

  public WatchListCommands(Path folder, Sockets sockets) {
    this.folder = folder.resolve("lists");
    this.sockets = sockets;
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("lists", Role.VIEW, (call, answer) -> show(answer));
    commands.add("list-parse", Role.VIEW, (call, answer) -> put(parse(call), answer));
    commands.add("list-text", Role.VIEW, (call, answer) -> answer.put("text", list(call).text()));
    commands.add("list-save", Role.OPERATE, this::save);
    commands.add("list-delete", Role.OPERATE, this::delete);
  }

  private static WatchList parse(Call call) throws CommandException {
    return WatchList.parse(call.text("text", MAX_TEXT));
  }

  private static WatchList list(Call call) throws CommandException {
    return WatchList.of(
        call.millis("period", WatchList.MIN_PERIOD, WatchList.MAX_PERIOD),
        call.texts("names", WatchList.MAX_NAMES));
  }

  private static void put(WatchList list, ObjectNode json) {
    json.put("period", list.periodMillis());
    list.names().forEach(json.putArray("names")::add);
  }

  private void show(ObjectNode answer) throws IOException {
    ArrayNode all = answer.putArray("lists");
    read().forEach((name, list) -> put(list, all.addObject().put("name", name)));
  }

  private synchronized SortedMap<String, WatchList> read() throws IOException {
    SortedMap<String, WatchList> lists = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    if (!Files.isDirectory(folder)) {
      return lists;
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ENDING)) {
      for (Path file : files) {
        String name = file.getFileName().toString();
        name = name.substring(0, name.length() - ENDING.length());
        if (lists.size() < MAX_LISTS && NAME.matcher(name).matches()) {
          try {
            lists.put(name, read(file));
          } catch (IOException e) {
            LOG.warn("{} is left out: {}", file, e.toString());
          }
        }
      }
    }
    return lists;
  }

  private static WatchList read(Path file) throws IOException {
    if (Files.size(file) > MAX_TEXT) {
      throw new CommandException("more than " + MAX_TEXT + " bytes");
    }
    return WatchList.parse(Files.readString(file));
  }

  private Path file(Call call) throws CommandException {
    String name = call.text("name");
    if (!NAME.matcher(name).matches() || DeviceNames.isDevice(name)) {
      throw new CommandException(
          "the name of a list must have 1 to 60 letters, digits, blanks, - and _, begin and end"
              + " with none of the last three, and must not be a device name of Windows");
    }
    return folder.resolve(name + ENDING);
  }

  /** Returns the existing file with this name in any case, since the names of lists ignore case. */
  private Path inAnyCase(Path file) throws IOException {
    if (Files.exists(file) || !Files.isDirectory(folder)) {
      return file;
    }
    String name = file.getFileName().toString();
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(it -> it.getFileName().toString().equalsIgnoreCase(name))
          .findFirst()
          .orElse(file);
    }
  }

  private void save(Call call, ObjectNode answer) throws IOException {
    Path chosen = file(call);
    WatchList list = list(call);
    synchronized (this) {
      Path file = inAnyCase(chosen);
      if (!Files.exists(file) && read().size() >= MAX_LISTS) {
        throw new CommandException("there are " + MAX_LISTS + " lists: delete one first");
      }
      Files.createDirectories(folder);
      Path part = Files.createTempFile(folder, "list", ".part");
      try {
        Files.writeString(part, list.text());
        Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
      } finally {
        Files.deleteIfExists(part);
      }
    }
    tellAll();
  }

  private void delete(Call call, ObjectNode answer) throws IOException {
    Path file = file(call);
    synchronized (this) {
      if (!Files.deleteIfExists(inAnyCase(file))) {
        throw new CommandException("there is no such list");
      }
    }
    tellAll();
  }

  private void tellAll() {
    sockets.broadcast("lists", Json.event("lists"));
  }
}
