package no.hials.crosscom.cli.mock;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.SettingText;
import no.hials.crosscom.cli.base.CannotListenException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.Terminal;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.mock.FaultRule;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.SimulationClock;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code mock}. */
@Command(
    name = "mock",
    description = {
      "Simulates a controller with KUKAVARPROXY or C3 Bridge (KR C4, KR 6 R900 sixx or another"
          + " robot) until Ctrl-C, with variables, programs and files.",
      "The first line of stdout ends with a colon and the port."
    },
    footer = {
      "",
      "Ctrl-C (SIGINT) and SIGTERM end the command with exit code 0. Messages of the controller"
          + " are printed to stderr. On a terminal, without --verbose, the last line shows the"
          + " simulated time, mode, programs, axes in degrees, clients and requests. Without a"
          + " terminal, mode and programs are printed once, at the start.",
      "",
      "On a terminal the number of a key and Enter answer a dialogue of the program, and Enter"
          + " alone confirms messages. A pipe as standard input is not read.",
      "",
      "FAULT is NAME[:ARGUMENT][@REQUESTS][@VARIABLE][%%PROBABILITY]:",
      "  drop@3                 no answer to the third request",
      "  delay:200ms@$POS_ACT   requests for $POS_ACT take 200 ms",
      "  wrongId@5-10           wrong ids from the fifth to the tenth",
      "  closeAfter%%0.01        one connection in a hundred closed after an answer",
      "An unknown NAME, such as --fault list, prints a list of all names.",
      "",
      "Examples:",
      "  jopenshowvar mock",
      "  jopenshowvar mock --config krl/config.dat --program krl/actuator.src \\",
      "      --start --mode AUT",
      "  jopenshowvar mock --archive cell.zip --start --server c3",
      "  jopenshowvar mock --server c3 --config krl/config.dat --files krc --create",
      "  jopenshowvar mock --port 0 --latency krc4 --fault drop%%0.01 --seed 7"
    })
public final class MockCommand extends ConsoleCommand {
  /** The port of KUKAVARPROXY. */
  private static final int DISCOVERY_PORT = 6999;

  /** The port of C3 Bridge. */
  private static final int STANDARD_DISCOVERY_PORT = 7000;

  @Option(
      names = "--host",
      paramLabel = "ADDRESS",
      description =
          "Local address to listen on. Default: the loopback address, reachable only from this"
              + " computer.")
  private @Nullable String host;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      converter = Converters.ListeningPort.class,
      description = "TCP port to listen on, 0 for a free one. Default: 7000.")
  private int port = ClientConfig.DEFAULT_PORT;

  @Option(
      names = "--discovery",
      paramLabel = "PORT",
      converter = Converters.ListeningPort.class,
      description =
          "UDP port for discovery (WHEREAREYOU?), 0 for a free one. Answers go to port 7000 of"
              + " the sender. Default: 6999, or none if it is in use.")
  private @Nullable Integer discovery;

  @Option(
      names = "--standard-discovery",
      paramLabel = "PORT",
      converter = Converters.ListeningPort.class,
      description =
          "UDP port for the standard discovery of C3 Bridge, 0 for a free one. Answers go to the"
              + " port of the sender. Default: 7000, or none if it is in use.")
  private @Nullable Integer standardDiscovery;

  @Option(names = "--no-discovery", description = "Do not answer discovery.")
  private boolean noDiscovery;

  @Option(
      names = "--server",
      paramLabel = "SERVER",
      description = "The server: kukavarproxy (default), or c3 for C3 Bridge.")
  private ServerType serverType = ServerType.KUKAVARPROXY;

  @Option(
      names = "--code-page",
      paramLabel = "NUMBER",
      description =
          "Code page of the controller's Windows, such as 1251 or 936, in which functions 0 and 1"
              + " carry texts. Default: 1252.")
  private String codePage = "1252";

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description = "The robot, such as \"KR 210 R2700-2\". Default: \"KR 6 R900 sixx\".")
  private @Nullable String robot;

  @Option(names = "--robots", description = "Print the names for --robot, and end.")
  private boolean listRobots;

  @Option(
      names = "--files",
      paramLabel = "FOLDER",
      description =
          "Use this folder as KRC:\\ of C3 Bridge. Clients change the files in it; missing"
              + " folders of R1 and STEU are created. Default: files in memory.")
  private @Nullable Path files;

  @Option(names = "--create", description = "Create the folder of --files if it does not exist.")
  private boolean create;

  @Option(
      names = "--archive",
      paramLabel = "PATH",
      description =
          "Load the archive of a controller, a zip or a folder: its data lists, programs, submit"
              + " program and robot. C3 Bridge serves a copy of its files. Stderr shows the result"
              + " for each file.")
  private @Nullable Path archive;

  @Option(
      names = "--strict",
      description =
          "End with an error if a file has one. Default: the rest of the file is loaded, and a"
              + " program stops where it reaches what is not understood.")
  private boolean strict;

  @Option(
      names = "--json",
      description =
          "Print the result for each loaded file to stdout, one JSON object a line; the other lines"
              + " after the first go to stderr.")
  private boolean json;

  @Option(
      names = "--config",
      paramLabel = "FILE.dat",
      description = "Load a data list, such as $CONFIG.DAT. Can be repeated.")
  private List<Path> configs = new ArrayList<>();

  @Option(
      names = "--program",
      paramLabel = "FILE.src",
      description =
          "Load a program (.src, or .sub for the submit interpreter) and the data list of the same"
              + " name next to it, or use one of --archive. Can be repeated; the first .src and the"
              + " first .sub are selected.")
  private List<Path> programs = new ArrayList<>();

  @Option(
      names = "--start",
      description =
          "Start the selected programs; of an archive without --program its only program, else"
              + " cell.src.")
  private boolean start;

  @Option(
      names = "--mode",
      paramLabel = "MODE",
      converter = Converters.Mode.class,
      description = "Operating mode: T1 (default), T2, AUT or EXT.")
  private OperatingMode mode = OperatingMode.T1;

  @Option(
      names = "--speed",
      paramLabel = "SPEED",
      converter = Converters.ClockSpeed.class,
      description =
          "Speed of the simulation: a factor such as 10, max for as fast as possible, or real"
              + " (default).")
  private SimulationClock speed = SimulationClock.real();

  @Option(
      names = "--latency",
      paramLabel = "LATENCY",
      description =
          "Latency of a request: none (default), a time such as 5ms, krc4 as measured on a KR C4"
              + " (median 2.2 ms), or krc4-2014 as in the papers of 2014 (mean 5 ms).")
  private String latency = "none";

  @Option(
      names = "--fault",
      paramLabel = "FAULT",
      description = "Inject a fault, see below. Can be repeated.")
  private List<String> faults = new ArrayList<>();

  @Option(
      names = "--seed",
      paramLabel = "NUMBER",
      description = "Seed of the random numbers for latency and faults. Default: 1.")
  private long seed = 1;

  @Override
  public ExitCode run() throws IOException {
    if (listRobots) {
      RobotModel.names().forEach(console()::print);
      return ExitCode.DONE;
    }
    if (host != null && host.isBlank()) {
      throw wrongUsage("--host must not be blank");
    }
    checkCombinations();
    LoadedFiles loaded = new LoadedFiles(strict);
    Archive opened = archive == null ? null : LoadedFiles.open(List.of(archive));
    ControllerSetup setup = new ControllerSetup(configs, programs, mode, start, opened);
    setup
        .mistake()
        .ifPresent(
            mistake -> {
              throw wrongUsage(mistake);
            });
    RobotModel model = model(robot);
    int page = argument("--code-page", codePage, MockCommand::codePage);
    Latency times = argument("--latency", latency, text -> Latency.parse(text, seed));
    List<FaultRule> rules = new ArrayList<>();
    for (String fault : faults) {
      rules.add(argument("--fault", fault, text -> FaultRule.parse(text, seed)));
    }
    InetAddress address = addressOf(host);
    // in this order: a signal after the first line finds both there
    try (StopSignal stop = new StopSignal();
        MockServer server =
            Robots.listen(
                address,
                port,
                with(opened, loaded.mode())
                    .andThen(cfg -> cfg.clock(speed).latency(times).codePage(page).robot(model)))) {
      rules.forEach(server::faults);
      loaded.add(server.archiveReport());
      List<String> lines = setup.apply(server.controller(), loaded);
      if (serverType == ServerType.C3_BRIDGE) {
        setup.addPrograms(server.files());
      }
      warning(address).ifPresent(console()::error);
      console().print("listening on " + shown(server.host()) + ":" + server.port());
      printLoaded(loaded, opened);
      printDiscovery(server);
      lines.forEach(this::print);
      // log messages would break the line, and a background job would overwrite what the user types
      boolean line = !isVerbose() && Terminal.isInteractive();
      try (StatusLine status =
          new StatusLine(console(), server, () -> line && Terminal.isForeground())) {
        status.start();
        stop.await();
      }
      return ExitCode.DONE;
    }
  }

  private void checkCombinations() {
    if (noDiscovery && (discovery != null || standardDiscovery != null)) {
      String option = discovery != null ? "--discovery" : "--standard-discovery";
      throw wrongUsage(option + " and --no-discovery exclude each other");
    }
    if (serverType != ServerType.C3_BRIDGE && standardDiscovery != null) {
      throw wrongUsage("--standard-discovery needs --server c3");
    }
    if (serverType != ServerType.C3_BRIDGE && files != null) {
      throw wrongUsage("--files needs --server c3");
    }
    if (archive != null && files != null) {
      throw wrongUsage("--archive and --files exclude each other");
    }
    if (create && files == null) {
      throw wrongUsage("--create needs --files");
    }
  }

  /** Returns a warning that other computers reach a server on this address; empty for loopback. */
  static Optional<String> warning(InetAddress address) {
    return address.isLoopbackAddress()
        ? Optional.empty()
        : Optional.of(
            "warning: anyone who can reach this computer over the network can read and write the"
                + " controller's variables without a password");
  }

  private static String shown(String host) {
    return host.indexOf(':') >= 0 ? "[" + host + "]" : host;
  }

  private static int codePage(String text) {
    int number = SettingText.number(text, 1, 65_535);
    return MockServerConfig.create(cfg -> cfg.codePage(number)).codePage();
  }

  private static InetAddress addressOf(@Nullable String host) throws CannotListenException {
    try {
      return host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new CannotListenException("cannot listen on " + host + ": the name is unknown", e);
    }
  }

  // the server

  /** Sets the type of the server, its ports for discovery, and its files. */
  private Consumer<MockServerConfig.Builder> with(@Nullable Archive opened, LoadingMode loading)
      throws FileException {
    boolean bridge = serverType == ServerType.C3_BRIDGE;
    Optional<FileTree> tree = tree();
    return cfg -> {
      cfg.server(serverType);
      if (discovery != null) {
        cfg.discoveryPort(discovery);
      } else if (!noDiscovery) {
        cfg.discoveryPortIfFree(DISCOVERY_PORT);
      }
      if (standardDiscovery != null) {
        cfg.standardDiscoveryPort(standardDiscovery);
      } else if (bridge && !noDiscovery) {
        cfg.standardDiscoveryPortIfFree(STANDARD_DISCOVERY_PORT);
      }
      tree.ifPresent(cfg::files);
      if (opened != null) {
        cfg.archive(opened, loading);
      }
    };
  }

  private Optional<FileTree> tree() throws FileException {
    if (files == null) {
      return Optional.empty();
    }
    if (!create && Files.notExists(files)) {
      throw new FileException(
          "cannot use " + files + ": the folder does not exist; --create creates it");
    }
    try {
      return Optional.of(FileTree.over(Files.createDirectories(files)));
    } catch (IOException e) {
      throw FileException.cannot("use", files, e);
    }
  }

  /** Prints a line after the first: to stderr if stdout has JSON. */
  private void print(String line) {
    if (json) {
      console().hint(line);
    } else {
      console().print(line);
    }
  }

  private void printLoaded(LoadedFiles loaded, @Nullable Archive opened) {
    if (opened != null) {
      console()
          .hint("archive " + archive + opened.description().map(text -> ": " + text).orElse(""));
    }
    if (json) {
      loaded.reports().forEach(file -> console().print(LoadedFiles.json(file)));
    } else if (opened != null) {
      loaded.lines().forEach(console()::hint);
    } else {
      loaded.warnings().forEach(console()::hint);
    }
  }

  /** Prints the ports on which the server answers discovery, or why it does not. */
  private void printDiscovery(MockServer server) {
    printPort("discovery", server.host(), server.discoveryPort(), DISCOVERY_PORT);
    if (serverType == ServerType.C3_BRIDGE) {
      OptionalInt standard = server.standardDiscoveryPort();
      printPort("standard discovery", server.host(), standard, STANDARD_DISCOVERY_PORT);
    }
  }

  private void printPort(String what, String host, OptionalInt port, int usual) {
    if (port.isPresent()) {
      print(what + " on " + shown(host) + ":" + port.getAsInt());
    } else if (!noDiscovery) {
      console().error("no " + what + ": UDP port " + usual + " is in use");
    }
  }
}
