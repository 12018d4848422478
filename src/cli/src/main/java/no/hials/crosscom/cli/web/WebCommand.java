package no.hials.crosscom.cli.web;

import java.io.IOException;
import java.net.BindException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.Stream;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Profiles;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.CannotListenException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.RobotChoice;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.web.OwnCertificate;
import no.hials.crosscom.web.PageAddress;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.ServerCertificate;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.WebServer;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code web}. */
@Command(
    name = "web",
    description = {
      "Shows robots on a web page until Ctrl-C: variables, charts, the robot in 3-D, jogging,"
          + " programs, inputs and outputs.",
      "The first line of stdout is the link to open, which works once."
    },
    footer = {
      "",
      "Without --host the page is on the loopback address: only browsers on this computer reach it."
          + " A browser elsewhere, such as a phone, needs --host with TLS, and a link that the page"
          + " makes (\"Let somebody in\"). A robot is locked until somebody unlocks it on the page,"
          + " and always with --read-only. Every change of a robot is a line of audit.jsonl in the"
          + " folder of --data.",
      "",
      "Jogging on the page moves a machine. It is not an enabling device and not an emergency stop:"
          + " see docs/how-to/jog-the-robot.md.",
      "",
      "Ctrl-C (SIGINT) and SIGTERM end the command with exit code 0.",
      "",
      "Examples:",
      "  jopenshowvar web --mock --open",
      "  jopenshowvar web @cell1 @cell2 --read-only",
      "  jopenshowvar web --mock --archive cell.zip --port 0",
      "  jopenshowvar web @cell1 --host 192.168.1.20 --tls"
    })
public final class WebCommand extends ConsoleCommand {
  private static final int PORT = 8080;
  private static final Duration LONGEST_DELAY = Duration.ofSeconds(2);

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description =
          "A robot of the configuration file; short form: @NAME. Can be repeated. Without --robot,"
              + " --controller and --mock: JOPENSHOWVAR_HOST, or the default robot of the file; see"
              + " 'jopenshowvar --help'.")
  private List<String> robots = new ArrayList<>();

  @Option(
      names = "--controller",
      paramLabel = "HOST",
      description = "Name or address of a controller; also HOST:PORT or [IPV6]:PORT.")
  private @Nullable String controller;

  @Option(
      names = "--mock",
      description =
          "Use a simulated controller (KR 6 R900 sixx, KR C4), which runs only during this"
              + " command.")
  private boolean mock;

  @Option(
      names = "--server",
      paramLabel = "SERVER",
      completionCandidates = Converters.ServerName.class,
      description =
          "Server of the simulated controller: c3 for C3 Bridge (default), or kukavarproxy. The"
              + " type of a real server is detected, or set by 'server' in config.toml.")
  private @Nullable ServerType server;

  @Option(
      names = "--archive",
      paramLabel = "PATH",
      description =
          "Load the archive of a controller, a zip or a folder, into the simulated controller.")
  private @Nullable Path archive;

  @Option(
      names = "--timeout",
      paramLabel = "TIME",
      description =
          "Maximum time to wait for a connection and for each answer of a controller, such as"
              + " 500ms or 3s. Default: 5s for the connection, 3s for an answer.")
  private @Nullable Duration timeout;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      converter = Converters.ListeningPort.class,
      description = "TCP port of the page, 0 for a free one. Default: 8080.")
  private int port = PORT;

  @Option(
      names = "--host",
      paramLabel = "ADDRESS",
      description =
          "Address to listen on, or a name of it; 0.0.0.0 for all addresses of this computer. Can"
              + " be repeated: the others are names of this computer by which browsers may call"
              + " it. Default: the loopback address. Any other one needs TLS.")
  private List<String> hosts = new ArrayList<>();

  @Option(
      names = "--tls",
      description =
          "Use TLS with a certificate that is made at the first time, and print its fingerprint to"
              + " stderr.")
  private boolean tls;

  @Option(
      names = "--tls-cert",
      paramLabel = "FILE",
      description =
          "Use TLS with this certificate: a file in PEM format, those of its issuers after it.")
  private @Nullable Path certificate;

  @Option(
      names = "--tls-key",
      paramLabel = "FILE",
      description =
          "The private key of --tls-cert: a file in PEM format (PKCS #8). Default: the same file.")
  private @Nullable Path key;

  @Option(
      names = "--keystore",
      paramLabel = "FILE",
      description = "Use TLS with the certificate and key of this PKCS #12 or JKS file.")
  private @Nullable Path keyStore;

  @Option(
      names = "--tls-password-file",
      paramLabel = "FILE",
      description =
          "File with the password of --tls-key or --keystore. Default:"
              + " JOPENSHOWVAR_TLS_PASSWORD.")
  private @Nullable Path passwordFile;

  @Option(
      names = "--data",
      paramLabel = "FOLDER",
      description =
          "Folder for watch lists, recordings, the audit log and the certificate of --tls. Default:"
              + " the folder web next to the configuration file.")
  private @Nullable Path data;

  @Option(
      names = "--stl",
      paramLabel = "FOLDER",
      description =
          "Folder with an STL file for each link of the robot, for the 3-D view. Default: generated"
              + " shapes.")
  private @Nullable Path shapes;

  @Option(names = "--open", description = "Open the link in the browser.")
  private boolean open;

  @Option(names = "--read-only", description = "Refuse to send anything that changes a controller.")
  private boolean readOnly;

  @Option(
      names = "--jog-in-auto",
      order = 5,
      description =
          "Allow jogging of real robots in every mode. Without it, they have to be in T1, where a"
              + " person holds the enabling switch. Simulated robots may always be jogged.")
  private boolean jogInAuto;

  @Option(
      names = "--jog-max-delay",
      paramLabel = "TIME",
      order = 5,
      description =
          "Maximum time to read the position of a robot that is jogged, at most 2s. Default: 100ms."
              + " A longer time ends the jogging.")
  private Duration jogMaxDelay = Duration.ofMillis(100);

  @Override
  public ExitCode run() throws IOException {
    RobotChoice choice =
        new RobotChoice(
            this,
            "--controller",
            controller,
            "--controller HOST:PORT",
            null,
            robots,
            mock,
            ServerType.C3_BRIDGE,
            server,
            null,
            timeout);
    List<Robot> targets = choice.targets();
    if (archive != null && !mock) {
      throw wrongUsage("--archive goes with --mock");
    }
    // an empty path would be the current folder
    if (shapes != null && (shapes.toString().isEmpty() || !Files.isDirectory(shapes))) {
      throw wrongUsage("--stl: there is no folder '" + shapes + "'");
    }
    if (jogMaxDelay.compareTo(LONGEST_DELAY) > 0 || jogMaxDelay.toMillis() < 1) {
      throw wrongUsage("--jog-max-delay must be 1ms to 2s, is " + jogMaxDelay.toMillis() + "ms");
    }
    PageAddress address = address();
    LoadedFiles loaded = new LoadedFiles(false);
    Archive opened = archive == null ? null : LoadedFiles.open(List.of(archive));
    Path folder = data == null ? Profiles.path(console()::environment).resolveSibling("web") : data;
    ServerCertificate chosen = certificate(folder, address);
    WebConfig config =
        WebConfig.create(
            cfg ->
                cfg.robots(named(targets))
                    .opener((robot, settings) -> connect(robot, settings, opened, loaded))
                    .folder(folder)
                    .address(address)
                    .certificate(chosen)
                    .port(port)
                    .shapes(shapes)
                    .readOnly(readOnly)
                    .jogInAuto(jogInAuto)
                    .jogMaxDelay(jogMaxDelay));
    try (StopSignal stop = new StopSignal();
        WebServer page = start(config)) {
      String link = page.link(Role.JOG);
      console().print(link);
      if (open) {
        Browser.open(link).ifPresent(console()::error);
      }
      stop.await();
      return ExitCode.DONE;
    }
  }

  private PageAddress address() {
    PageAddress address;
    try {
      address = PageAddress.of(hosts);
    } catch (UnknownHostException e) {
      throw wrongUsage("--host: there is no address of " + hosts.get(0));
    } catch (IllegalArgumentException e) {
      throw wrongUsage("--host: " + e.getMessage());
    }
    if (Stream.of(tls, certificate != null, keyStore != null).filter(it -> it).count() > 1) {
      throw wrongUsage("--tls, --tls-cert and --keystore exclude each other");
    }
    if (key != null && certificate == null) {
      throw wrongUsage("--tls-key goes with --tls-cert");
    }
    if (passwordFile != null && certificate == null && keyStore == null) {
      throw wrongUsage("--tls-password-file goes with --tls-cert or --keystore");
    }
    if (!address.isLoopback() && !tls && certificate == null && keyStore == null) {
      throw wrongUsage(
          "--host "
              + hosts.get(0)
              + ": other computers reach this address, so the page needs TLS: add --tls, or"
              + " --tls-cert, or --keystore");
    }
    return address;
  }

  /** Returns the certificate of the options; null without TLS. */
  private @Nullable ServerCertificate certificate(Path folder, PageAddress address)
      throws IOException {
    if (tls) {
      OwnCertificate own = OwnCertificate.in(folder.resolve("tls"), address);
      console()
          .error(
              (own.isNew() ? "made a certificate" : "the certificate")
                  + " with the SHA-256 fingerprint "
                  + own.certificate().fingerprint());
      return own.certificate();
    }
    ServerCertificate read;
    if (keyStore != null) {
      read = ServerCertificate.ofKeyStore(keyStore, password());
    } else if (certificate != null) {
      read = ServerCertificate.ofPem(certificate, key == null ? certificate : key, password());
    } else {
      return null;
    }
    address.names().stream()
        .filter(it -> !read.isFor(it))
        .forEach(it -> console().error("browsers will warn: the certificate is not for " + it));
    return read;
  }

  private char @Nullable [] password() throws IOException {
    if (passwordFile == null) {
      String password = console().environment("JOPENSHOWVAR_TLS_PASSWORD");
      return password == null ? null : password.toCharArray();
    }
    try {
      return Files.readString(passwordFile).lines().findFirst().orElse("").toCharArray();
    } catch (IOException e) {
      throw FileException.cannot("read", passwordFile, e);
    }
  }

  /**
   * Returns the robots with names: one of the options is called by its address, or {@code mock}.
   */
  private static List<Robot> named(List<Robot> targets) {
    return targets.stream()
        .map(
            it ->
                it.name().isEmpty()
                    ? new Robot(
                        it.host() == null ? "mock" : it.host(),
                        it.host(),
                        it.port(),
                        it.timeout(),
                        it.readOnlyBy(),
                        it.server(),
                        it.charset())
                    : it)
        .toList();
  }

  private RobotConnection connect(
      Robot robot,
      Consumer<ClientConfig.Builder> settings,
      @Nullable Archive archive,
      LoadedFiles loaded)
      throws IOException {
    if (robot.host() != null) {
      return RobotConnection.openLazily(robot, settings);
    }
    if (archive == null) {
      return Robots.open(robot, settings);
    }
    RobotConnection connection =
        Robots.open(robot, settings, cfg -> cfg.archive(archive, loaded.mode()));
    MockServer simulation = Objects.requireNonNull(Robots.simulation(connection));
    loaded.add(simulation.archiveReport());
    loaded.lines().forEach(console()::hint);
    return connection;
  }

  private static WebServer start(WebConfig config) throws IOException {
    try {
      return WebServer.start(config);
    } catch (BindException e) {
      throw new CannotListenException(
          "cannot listen on port " + config.port() + ": " + e.getMessage(), e);
    }
  }
}
