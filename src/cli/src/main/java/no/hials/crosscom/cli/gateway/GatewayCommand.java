package no.hials.crosscom.cli.gateway;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;

/**
 * {@code gateway}: a process of its own, whose libraries are not in this program. It gets all
 * arguments as they are.
 */
@Command(
    name = "gateway",
    description = {
      "Passes the values of robots on to MQTT, OPC UA and Prometheus until Ctrl-C.",
      "All arguments are for the gateway: 'jopenshowvar gateway --help' shows them."
    },
    footer = {
      "",
      "The gateway is a process of its own. Its folder is gateway, next to jopenshowvar.jar. See"
          + " docs/reference/gateway.md.",
      "",
      "Examples:",
      "  jopenshowvar gateway --mock 3 --prometheus 127.0.0.1:9464",
      "  jopenshowvar gateway --config plant.toml --dry-run"
    })
public final class GatewayCommand extends ConsoleCommand {
  private static final String JAR = "gateway/jopenshowvar-gateway.jar";

  /** From src/cli/target. */
  private static final String JAR_IN_BUILD = "../../gateway/target/" + JAR;

  @Parameters(arity = "0..*", paramLabel = "ARGUMENT", description = "Arguments of the gateway.")
  private List<String> arguments = new ArrayList<>();

  private GatewayCommand() {}

  /** Returns the command, whose own options are arguments as well. */
  public static CommandLine commandLine() {
    CommandLine line = new CommandLine(new GatewayCommand());
    CommandSpec spec = line.getCommandSpec();
    List.copyOf(spec.options()).forEach(spec::remove);
    return line.setUnmatchedOptionsArePositionalParams(true);
  }

  @Override
  public ExitCode run() throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-XX:-UseDynamicNumberOfGCThreads"); // Java 17 does not end if one cannot start
    command.add("-jar");
    command.add(jar().toString());
    command.addAll(arguments);
    Process process = new ProcessBuilder(command).inheritIO().start();
    // a Ctrl-C reaches both; another signal only this one
    Thread end = new Thread(process::destroy, "end-of-gateway");
    Runtime.getRuntime().addShutdownHook(end);
    try {
      return ExitCode.of(process.waitFor());
    } catch (InterruptedException e) {
      process.destroy();
      Thread.currentThread().interrupt();
      return ExitCode.STOPPED;
    }
  }

  private static Path jar() throws FileException {
    Path own;
    try {
      own =
          Path.of(GatewayCommand.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
    Path installed = own.resolveSibling(JAR);
    Path built = own.resolveSibling(JAR_IN_BUILD).normalize();
    if (!Files.exists(installed) && !Files.exists(built)) {
      throw new FileException("the gateway is not installed: there is no " + installed);
    }
    return Files.exists(installed) ? installed : built;
  }
}
