package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;

/**
 * The process of a {@link SimulatedRobot}. It prints where it listens, host and port, a line each,
 * and ends when its input does, as also happens if who started it is killed.
 */
final class RobotProcess {
  /** Quick to start, and no threads of the JVM that take the CPUs of the loop. */
  private static final List<String> THRIFT = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  /** These are meant for the loop, and may exclude the ones above. */
  private static final Set<String> USERS_OPTIONS =
      Set.of("JDK_JAVA_OPTIONS", "JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS");

  private RobotProcess() {}

  /** Starts the process, on the Java and with the classes of this one. */
  static Process start(String latency, Axes start, RobotProgram program) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(THRIFT);
    command.add("-cp");
    command.add(System.getProperty("java.class.path"));
    command.add(RobotProcess.class.getName());
    command.add(latency);
    command.add(program.name());
    for (double axis : start.toArray()) {
      command.add(Double.toString(axis));
    }
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().keySet().removeAll(USERS_OPTIONS);
    return builder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
  }

  /**
   * Simulates a robot.
   *
   * @param args the latency, the program, and where the axes are at first, as {@link #start} gives
   *     them
   * @throws IOException if it cannot be started, or not be told where it listens
   */
  public static void main(String... args) throws IOException {
    Latency latency = Latency.parse(args[0], 1);
    String program = RobotProgram.valueOf(args[1]).name().toLowerCase(Locale.ROOT);
    Axes start = Axes.of(Arrays.stream(args).skip(2).mapToDouble(Double::parseDouble).toArray());
    try (MockServer server = MockServer.start(cfg -> cfg.latency(latency).recordedRequests(0))) {
      KrlPrograms.start(server.controller(), start, program);
      System.out.println(server.host());
      System.out.println(server.port());
      while (System.in.read() >= 0) {
        // nothing is said to it
      }
    }
  }
}
