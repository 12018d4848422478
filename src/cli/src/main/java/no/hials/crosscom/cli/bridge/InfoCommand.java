package no.hials.crosscom.cli.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.Server;
import no.hials.crosscom.c3.BridgeInfo;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;

/** {@code info}. */
@Command(
    name = "info",
    description =
        "Prints the type and version of the server, the messages it supports, the host name and"
            + " clock of the controller, the robot's model and serial number, and the operating"
            + " mode.",
    footer = {
      "",
      "KUKAVARPROXY does not report its version, host name and clock. Unknown values and"
          + " variables that cannot be read are shown as -, in JSON as null.",
      "",
      "The features are the types of the messages that the server supports.",
      "",
      "JSON: one object with server, version, build, features (an array of numbers), host, clock,"
          + " model, serial and mode.",
      "",
      "Examples:",
      "  jopenshowvar info --host 172.31.1.147",
      "  jopenshowvar info --mock --json | jq .version"
    })
public final class InfoCommand extends BridgeCommand {
  /** A line of the table, and a field of the object. */
  private record Item(String name, @Nullable String value) {}

  @Override
  public ExitCode run() throws IOException {
    try (RobotConnection controller = open()) {
      CrossComClient client = controller.client();
      Server server;
      try {
        server = client.getServer();
      } catch (CrossComTimeoutException e) {
        console().failure(e, isVerbose());
        console().hint("check that KUKAVARPROXY or C3 Bridge listens on this port");
        return ExitCode.of(e);
      }
      List<Item> items = new ArrayList<>();
      addServer(items, client, server);
      items.add(new Item("model", variable(client, "$MODEL_NAME[]")));
      items.add(new Item("serial", variable(client, "$KR_SERIALNO")));
      items.add(new Item("mode", variable(client, "$MODE_OP")));
      if (isJson()) {
        console().print(JsonLine.object(json -> write(json, items, server)));
      } else {
        print(items, server);
      }
    }
    return ExitCode.DONE;
  }

  /** Adds the information of the server about itself, in one exchange if possible. */
  private static void addServer(List<Item> items, CrossComClient client, Server server)
      throws IOException {
    boolean bridge = server.type() == ServerType.C3_BRIDGE;
    BridgeInfo info = server.knows(MessageType.INFORMATION) ? client.information().get() : null;
    items.add(new Item("server", bridge ? "C3 Bridge Interface" : "KUKAVARPROXY"));
    items.add(new Item("version", server.version() == null ? null : server.version().toString()));
    items.add(new Item("build", info == null ? null : words(info.build().toString())));
    items.add(new Item("host", info == null ? null : info.host()));
    items.add(
        new Item("clock", info == null || info.clock() == null ? null : info.clock().toString()));
  }

  private static @Nullable String variable(CrossComClient client, String name) throws IOException {
    try {
      KrlValue value = client.readValue(name);
      return value instanceof KrlString string ? string.text() : value.toString();
    } catch (CrossComAccessException e) {
      return null;
    }
  }

  private static void write(JsonGenerator json, List<Item> items, Server server)
      throws IOException {
    for (Item item : items) {
      json.writeStringField(item.name(), item.value());
    }
    json.writeArrayFieldStart("features");
    for (int type : server.features().types()) {
      json.writeNumber(type);
    }
    json.writeEndArray();
  }

  private void print(List<Item> items, Server server) {
    Table table = Table.ofValues();
    for (Item item : items) {
      table.add(item.name(), item.value() == null ? "" : item.value());
    }
    table.add("features", ranges(server.features().types()));
    table.print(console());
  }

  /** Returns numbers in the form {@code 0-7 10}. */
  private static String ranges(Iterable<Integer> numbers) {
    List<String> ranges = new ArrayList<>();
    int first = -2;
    int last = -2;
    for (int number : numbers) {
      if (number != last + 1) {
        addRange(ranges, first, last);
        first = number;
      }
      last = number;
    }
    addRange(ranges, first, last);
    return String.join(" ", ranges);
  }

  private static void addRange(List<String> ranges, int first, int last) {
    if (first >= 0) {
      ranges.add(first == last ? String.valueOf(first) : first + "-" + last);
    }
  }
}
