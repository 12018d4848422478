package no.hials.crosscom.cell;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import org.jspecify.annotations.Nullable;

/**
 * A connection to a robot controller that the user chose.
 *
 * @param robot the robot
 * @param client its client
 * @param simulation closed with the connection: the simulated controller, if the robot is
 *     simulated. Programs that know its type use {@link #simulation(Class)}
 */
public record RobotConnection(
    Robot robot, CrossComClient client, @Nullable AutoCloseable simulation) implements Closeable {

  /** Opens connections, and starts simulated controllers. */
  @FunctionalInterface
  public interface Opener {
    /**
     * Connects to a robot.
     *
     * @param settings sets the options that the user does not choose
     * @throws CrossComException if no connection could be made
     */
    RobotConnection open(Robot robot, Consumer<ClientConfig.Builder> settings) throws IOException;
  }

  /**
   * Connects to a robot that has a host.
   *
   * @param settings sets the options that the user does not choose: {@link Robot#ONE_SHOT} or
   *     {@link Robot#LASTING}
   * @throws CrossComException if no connection could be made
   */
  public static RobotConnection open(Robot robot, Consumer<ClientConfig.Builder> settings)
      throws CrossComException {
    return new RobotConnection(robot, new CrossComClient(config(robot, settings)), null);
  }

  /**
   * Connects to a robot that has a host, in the background: the robot may be off until later. See
   * {@link CrossComClient#lazy}.
   *
   * @param settings sets the options that the user does not choose
   */
  public static RobotConnection openLazily(Robot robot, Consumer<ClientConfig.Builder> settings)
      throws CrossComException {
    return new RobotConnection(robot, CrossComClient.lazy(config(robot, settings)), null);
  }

  /**
   * Returns the simulated controller; empty if the robot is not simulated by this process.
   *
   * @param type the type of the simulated controllers that the program starts
   * @throws ClassCastException if the simulated controller is of another type
   */
  public <S extends AutoCloseable> Optional<S> simulation(Class<S> type) {
    return Optional.ofNullable(simulation).map(type::cast);
  }

  private static ClientConfig config(Robot robot, Consumer<ClientConfig.Builder> settings) {
    Duration limit = robot.timeout();
    return ClientConfig.create(
        Objects.requireNonNull(robot.host(), "a simulated robot needs its server first"),
        cfg -> {
          cfg.port(robot.port());
          if (limit != null) {
            cfg.connectTimeout(limit).requestTimeout(limit);
          }
          if (robot.server() != null) {
            cfg.server(robot.server());
          }
          if (robot.charset() != null) {
            cfg.charset(robot.charset());
          }
          settings.accept(cfg);
        });
  }

  @Override
  public void close() throws IOException {
    try {
      client.close();
    } finally {
      closeSimulation();
    }
  }

  private void closeSimulation() throws IOException {
    try {
      if (simulation != null) {
        simulation.close();
      }
    } catch (IOException | RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new IOException(e);
    }
  }
}
