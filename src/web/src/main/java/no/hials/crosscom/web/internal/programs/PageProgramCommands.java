package no.hials.crosscom.web.internal.programs;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import no.hials.crosscom.CrossComAction;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Changes;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;

/** Shows, uploads, selects, starts and stops the programs of a controller with C3 Bridge. */
public final class PageProgramCommands {
  /** The largest file that a message of a page can carry in Base64. */
  static final int MAX_UPLOADED = 180 * 1024;

  private static final int MAX_SHOWN = 2 * 1024 * 1024;
  private static final int MAX_PATH = 1000;
  private static final int MAX_ERRORS = 20;

  /** A name of KRL (docs/reference/krl-language.md#declarations) with the ending of a file. */
  private static final Pattern FILE_NAME =
      Pattern.compile("[A-Za-z_$][A-Za-z0-9_$]{0,23}\\.([Ss][Rr][Cc]|[Ss][Uu][Bb]|[Dd][Aa][Tt])");

  private static final List<String> ORDERS = List.of("start", "reset", "cancel");

  private final RobotSessions robots;
  private final Changes changes;

  public PageProgramCommands(RobotSessions robots, AuditLog audit) {
    this.robots = robots;
    this.changes = new Changes(audit);
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("programs", Role.VIEW, this::show);
    commands.add("program-files", Role.VIEW, this::list);
    commands.add("program-text", Role.VIEW, this::text);
    commands.add("program-select", Role.OPERATE, (call, answer) -> select(call));
    commands.add("program-order", Role.OPERATE, (call, answer) -> order(call));
    commands.addOvertaking("program-stop", Role.OPERATE, (call, answer) -> stop(call));
    commands.add("upload-check", Role.OPERATE, this::checkUpload);
    commands.add("upload", Role.OPERATE, this::upload);
  }

  private void show(Call call, ObjectNode answer) throws IOException {
    RobotSession robot = robots.of(call);
    answer.put("bridge", robot.isBridge());
    answer.put("simulated", robot.simulation().isPresent());
  }

  // files

  private static String checkedPath(Call call, String field) throws CommandException {
    String path = call.text(field, MAX_PATH).strip();
    if (path.isEmpty() || path.contains("..") || path.chars().anyMatch(Character::isISOControl)) {
      throw new CommandException(field + " is not a name on a controller");
    }
    return path;
  }

  private void list(Call call, ObjectNode answer) throws IOException {
    String folder = checkedPath(call, "folder");
    ArrayNode items = answer.putArray("items");
    for (FileEntry entry : robots.of(call).client().files().list(folder)) {
      boolean isFolder = entry.isDirectory();
      if (isFolder || FILE_NAME.matcher(entry.name()).matches()) {
        ObjectNode item = items.addObject();
        item.put("name", entry.name());
        item.put("path", RemoteName.in(folder, entry.name()));
        item.put("folder", isFolder);
        entry.size().ifPresent(size -> item.put("size", size));
      }
    }
  }

  private void text(Call call, ObjectNode answer) throws IOException {
    String name = checkedPath(call, "name");
    ControllerFiles files = robots.of(call).client().files();
    if (!files.exists(name)) {
      throw new CommandException("the files of the controller have no " + name);
    }
    long size = files.getProperties(name).size();
    if (size > MAX_SHOWN) {
      throw new CommandException(
          name + " has " + size + " bytes; the page shows at most " + MAX_SHOWN);
    }
    answer.put("name", name);
    answer.put("text", files.downloadText(name, TransferConfig.DEFAULT));
  }

  /** Returns the name on the controller of the file that a page sends. */
  private static String target(Call call) throws CommandException {
    String name = call.text("name");
    if (!FILE_NAME.matcher(name).matches()) {
      throw new CommandException(
          name
              + ": a file of KRL has a name of at most 24 letters, digits, _ and $, and ends in"
              + " .src, .sub or .dat");
    }
    return RemoteName.in(checkedPath(call, "folder"), name);
  }

  private static byte[] content(Call call) throws CommandException {
    try {
      return Base64.getDecoder().decode(call.text("content", MAX_UPLOADED * 4 / 3 + 4));
    } catch (IllegalArgumentException e) {
      throw new CommandException("content must be Base64");
    }
  }

  /** Answers with the errors of the file that the parser finds. Uploads nothing. */
  private void checkUpload(Call call, ObjectNode answer) throws IOException {
    String path = target(call);
    byte[] content = content(call);
    answer.put("path", path);
    answer.put("size", content.length);
    answer.put("exists", robots.of(call).client().files().exists(path));
    List<KrlError> errors =
        KrlParser.parse(RemoteName.last(path), KrlEncoding.decode(content)).errors();
    answer.put("errors", errors.size());
    ArrayNode first = answer.putArray("first");
    errors.stream().limit(MAX_ERRORS).forEach(error -> first.add(error.toString()));
  }

  private void upload(Call call, ObjectNode answer) throws IOException {
    RobotSession robot = robots.of(call);
    String path = target(call);
    byte[] content = content(call);
    boolean overwrite = call.optionalFlag("overwrite");
    changes.make(
        call,
        robot,
        "upload",
        path,
        content.length + " bytes",
        () -> {
          TransferConfig config =
              TransferConfig.create(
                  cfg -> cfg.overwrite(overwrite).verification(Verification.CONTENT));
          robot
              .lock()
              .upload(
                  call,
                  "upload " + path,
                  () -> robot.client().files().uploadAsync(content, path, config));
        });
    answer.put("path", path).put("size", content.length);
  }

  // programs

  /** Reads what a command needs, and returns the command. */
  @FunctionalInterface
  private interface Order {
    CrossComAction prepare(CrossComClient client) throws IOException;
  }

  private void send(
      Call call, RobotSession robot, String what, String name, Order order, String likelyCause)
      throws IOException {
    changes.make(
        call,
        robot,
        what,
        name,
        "",
        () -> {
          CrossComClient client = robot.client();
          String phrase = what + " " + name;
          robot.lock().check(call, phrase);
          try {
            CrossComAction command = order.prepare(client);
            robot.lock().send(call, phrase, sendIf -> client.asyncRun(command, sendIf));
          } catch (CrossComRefusedException e) {
            throw new CommandException(e.getMessage() + "; likely cause: " + likelyCause);
          }
        });
  }

  private void select(Call call) throws IOException {
    RobotSession robot = robots.of(call);
    String path = checkedPath(call, "name");
    send(
        call,
        robot,
        "select",
        path,
        client -> {
          String name = RemoteName.withoutEnding(krcName(client.files(), path));
          return it -> it.programs().select(name);
        },
        "the program has errors, or another one is active");
  }

  /** Returns the short name, or the name itself if the server does not know one. */
  private static String krcName(ControllerFiles files, String path) throws IOException {
    try {
      return files.getKrcName(path);
    } catch (CrossComRefusedException e) {
      return path;
    }
  }

  private static Interpreter interpreter(Call call) throws CommandException {
    Optional<String> name = call.optionalText("interpreter");
    return switch (name.orElse("robot")) {
      case "robot" -> Interpreter.ROBOT;
      case "submit" -> Interpreter.SUBMIT;
      default -> throw new CommandException("interpreter must be robot or submit");
    };
  }

  private static String programOf(Interpreter interpreter) {
    return "the program of the "
        + (interpreter == Interpreter.ROBOT ? "robot" : "submit")
        + " interpreter";
  }

  private void order(Call call) throws IOException {
    Interpreter interpreter = interpreter(call);
    String order = call.text("order");
    if (!ORDERS.contains(order)) {
      throw new CommandException("order must be one of " + ORDERS);
    }
    send(
        call,
        robots.of(call),
        order,
        programOf(interpreter),
        client ->
            it -> {
              Programs programs = it.programs();
              switch (order) {
                case "start" -> programs.start(interpreter);
                case "reset" -> programs.reset(interpreter);
                default -> programs.cancel(interpreter);
              }
            },
        "no program is selected, the mode or the state of the program does not allow it, or a"
            + " message has to be confirmed");
  }

  private void stop(Call call) throws IOException {
    RobotSession robot = robots.of(call);
    Interpreter interpreter = interpreter(call);
    String name = programOf(interpreter);
    changes.make(
        call,
        robot,
        "stop",
        name,
        "",
        () -> {
          robot.lock().checkStop("stop " + name);
          robot.lock().refuseWaiting();
          try {
            robot.client().programs().stop(interpreter);
          } catch (CrossComRefusedException e) {
            throw new CommandException(e.getMessage() + "; likely cause: no program is selected");
          } catch (CrossComException e) {
            throw new CommandException(
                e.isOutcomeUnknown()
                    ? "the stop was sent, but not answered: " + e.getMessage()
                    : "the stop was not sent: " + e.getMessage());
          } finally {
            robot.lock().refuseWaiting();
          }
        });
  }
}
