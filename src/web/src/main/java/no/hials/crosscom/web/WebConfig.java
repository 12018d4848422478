package no.hials.crosscom.web;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import org.jspecify.annotations.Nullable;

/** The options of a {@link WebServer}. Immutable; the {@link Builder} describes the options. */
public final class WebConfig {
  private final List<Robot> robots;
  private final RobotConnection.Opener opener;
  private final Path folder;
  private final PageAddress address;
  private final @Nullable ServerCertificate certificate;
  private final int port;
  private final boolean readOnly;
  private final boolean jogInAuto;
  private final Duration jogMaxDelay;
  private final @Nullable Path shapes;

  private WebConfig(Builder builder) {
    robots = List.copyOf(builder.robots);
    opener = builder.opener;
    folder = Objects.requireNonNull(builder.folder, "folder");
    address = builder.address;
    certificate = builder.certificate;
    port = builder.port;
    readOnly = builder.readOnly;
    jogInAuto = builder.jogInAuto;
    jogMaxDelay = builder.jogMaxDelay;
    shapes = builder.shapes;
    if (robots.isEmpty()) {
      throw new IllegalArgumentException("name at least one robot");
    }
    if (!address.isLoopback() && certificate == null) {
      throw new IllegalArgumentException(
          "other computers reach " + address.names().get(0) + ": the page needs a certificate");
    }
  }

  /**
   * Creates a configuration.
   *
   * @param settings sets the robots, the folder, and the options that differ from their defaults
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static WebConfig create(Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    return new WebConfig(builder);
  }

  /** Returns the robots of the page, in their order. */
  public List<Robot> robots() {
    return robots;
  }

  /** Returns the opener of the connections to the robots. */
  public RobotConnection.Opener opener() {
    return opener;
  }

  /** Returns the folder for watch lists, recordings and the audit log. */
  public Path folder() {
    return folder;
  }

  /** Returns the address of the page. */
  public PageAddress address() {
    return address;
  }

  /** Returns the certificate for TLS; empty for a page without TLS. */
  public Optional<ServerCertificate> certificate() {
    return Optional.ofNullable(certificate);
  }

  /** Returns the port of the page; 0 for a free one. */
  public int port() {
    return port;
  }

  /** Returns whether nothing may be changed on any robot. */
  public boolean readOnly() {
    return readOnly;
  }

  /** Returns whether real robots may be jogged in other modes than T1. */
  public boolean jogInAuto() {
    return jogInAuto;
  }

  /** Returns the maximum time of reading the position while a robot is jogged. */
  public Duration jogMaxDelay() {
    return jogMaxDelay;
  }

  /** Returns the folder with the shapes of the robot's links; empty for generated shapes. */
  public Optional<Path> shapes() {
    return Optional.ofNullable(shapes);
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private List<Robot> robots = List.of();
    private RobotConnection.Opener opener = RobotConnection::openLazily;
    private @Nullable Path folder;
    private PageAddress address = PageAddress.loopback();
    private @Nullable ServerCertificate certificate;
    private int port = 8080;
    private boolean readOnly;
    private boolean jogInAuto;
    private Duration jogMaxDelay = Duration.ofMillis(100);
    private @Nullable Path shapes;

    private Builder() {}

    /**
     * Sets the robots of the page, at least one. A robot without a name is called {@code robot}.
     */
    public Builder robots(List<Robot> value) {
      robots = List.copyOf(value);
      return this;
    }

    /**
     * Sets the opener that connects to the robots and starts the simulated ones. The default
     * connects in the background, and has no simulated robots.
     */
    public Builder opener(RobotConnection.Opener value) {
      opener = Objects.requireNonNull(value, "opener");
      return this;
    }

    /**
     * Sets the folder for watch lists, recordings and the audit log, created when needed. There is
     * no default.
     */
    public Builder folder(Path value) {
      folder = Objects.requireNonNull(value, "folder");
      return this;
    }

    /**
     * Sets the address of the page. The default is the loopback address; any other one needs a
     * certificate.
     */
    public Builder address(PageAddress value) {
      address = Objects.requireNonNull(value, "address");
      return this;
    }

    /**
     * Sets the certificate for TLS.
     *
     * @param value the certificate; null, which is the default, for a page without TLS
     */
    public Builder certificate(@Nullable ServerCertificate value) {
      certificate = value;
      return this;
    }

    /** Sets the port of the page, 0 for a free one. The default is 8080. */
    public Builder port(int value) {
      if (value < 0 || value > 65_535) {
        throw new IllegalArgumentException("port must be 0 to 65535, is " + value);
      }
      port = value;
      return this;
    }

    /** Sets whether nothing may be changed on any robot. The default is false. */
    public Builder readOnly(boolean value) {
      readOnly = value;
      return this;
    }

    /**
     * Sets whether real robots may be jogged in other modes than T1, where nobody has to hold an
     * enabling switch. The default is false. Robots simulated by this process may always be jogged
     * in every mode.
     */
    public Builder jogInAuto(boolean value) {
      jogInAuto = value;
      return this;
    }

    /**
     * Sets the maximum time of reading the position while a robot is jogged, 1 ms to 2 s. A longer
     * reading ends the jogging. The default is 100 ms.
     */
    public Builder jogMaxDelay(Duration value) {
      if (value.compareTo(Duration.ofMillis(1)) < 0 || value.compareTo(Duration.ofSeconds(2)) > 0) {
        throw new IllegalArgumentException("the delay must be 1 ms to 2 s, is " + value);
      }
      jogMaxDelay = value;
      return this;
    }

    /**
     * Sets the folder with the shapes of the robot's links, as files in STL format called {@code
     * base.stl}, {@code a1.stl} to {@code a6.stl} and {@code tool.stl}. Links without a file, and
     * those of pages without a folder, get a generated shape.
     *
     * @param value the folder; null for generated shapes
     */
    public Builder shapes(@Nullable Path value) {
      shapes = value;
      return this;
    }
  }
}
