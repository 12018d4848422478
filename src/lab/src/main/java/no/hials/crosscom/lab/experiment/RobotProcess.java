package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.KrlPrograms;

/**
 * The process of a {@link SimulatedRobot}. It prints the host and the port it listens on, a line
 * each, and exits when its input is closed, which also happens if the parent process is killed.
 */
final class RobotProcess {
  /** Starts fast and runs no JVM threads that compete with the loop for the CPUs. */
  private static final List<String> THRIFT = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  /** These are meant for the loop, and may conflict with the options above. */
  private static final Set<String> USERS_OPTIONS =
      Set.of("JDK_JAVA_OPTIONS", "JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS");

  private RobotProcess() {}

  /** Starts the process with the Java and the class path of this process. */
  static Process start(String latency, Axis start, RobotProgram program) throws IOException {
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
   * @param args the latency, the program, and the initial position of the axes, as {@link #start}
   *     passes them
   * @throws IOException if the server cannot be started or its address cannot be printed
   */
  public static void main(String... args) throws IOException {
    Latency latency = Latency.parse(args[0], 1);
    String program = RobotProgram.valueOf(args[1]).name().toLowerCase(Locale.ROOT);
    Axis start = Axis.of(Arrays.stream(args).skip(2).mapToDouble(Double::parseDouble).toArray());
    CountDownLatch ended = new CountDownLatch(1);
    Runtime.getRuntime().addShutdownHook(new Thread(() -> await(ended), "until-the-input-ends"));
    try (MockServer server = MockServer.start(cfg -> cfg.latency(latency).recordedRequests(0))) {
      KrlPrograms.start(server.controller(), start, program);
      System.out.println(server.host());
      System.out.println(server.port());
      while (System.in.read() >= 0) {
        // the input carries no data
      }
    } finally {
      ended.countDown();
    }
  }

  /** Keeps the robot there after Ctrl-C, which a terminal sends to this process, too. */
  private static void await(CountDownLatch ended) {
    try {
      ended.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
