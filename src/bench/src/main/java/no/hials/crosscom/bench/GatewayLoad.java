package no.hials.crosscom.bench;

import com.hivemq.client.mqtt.MqttClient;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Lets a gateway read many robots at 10 Hz, two structures of 15 numbers each, and publish them to
 * Mosquitto, one message a structure. Prints how long a value takes from its reading to a
 * subscriber of the broker, and what each process costs. Robots, gateway, broker and subscriber are
 * processes of their own on this computer.
 */
public final class GatewayLoad {
  private static final Path BROKER = Path.of("/usr/sbin/mosquitto");
  private static final Duration PERIOD = Duration.ofMillis(100);
  private static final Duration WARM_UP = Duration.ofSeconds(15);
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final int STRUCTURES = 2;

  /** The place of the time in a message, {@code {"time":"2026-05-04T10:15:30.123Z",...}}. */
  private static final int TIME_FROM = 9;

  private static final int TIME_TO = TIME_FROM + 24;

  private final PrintStream out;
  private final Path gateway;

  /** How many messages took each number of ms; the last stands for all longer times. */
  private final AtomicIntegerArray millis = new AtomicIntegerArray(10_001);

  private final AtomicLong messages = new AtomicLong();
  private final AtomicLong unreadable = new AtomicLong();
  private volatile boolean counting;

  GatewayLoad(PrintStream out, Path gateway) {
    this.out = out;
    this.gateway = gateway;
  }

  /**
   * Measures.
   *
   * @param args the jar of the gateway, the number of robots (default 333), the seconds of the
   *     measurement (default 30)
   * @throws Exception if a process cannot be started
   */
  public static void main(String[] args) throws Exception {
    int robots = args.length > 1 ? Integer.parseInt(args[1]) : 333;
    int seconds = args.length > 2 ? Integer.parseInt(args[2]) : 30;
    new GatewayLoad(System.out, Path.of(args[0])).run(robots, seconds);
  }

  private void run(int robots, int seconds) throws Exception {
    Map<String, Process> processes = new LinkedHashMap<>();
    try (TemporaryFolder folder = new TemporaryFolder("gateway-load")) {
      int brokerPort = freePort();
      try {
        processes.put("broker", startBroker(folder.path(), brokerPort));
        Mqtt5AsyncClient subscriber = subscribe(brokerPort);
        Process standIn = java(List.of("-Xmx256m", "-cp", classPath(), standIn()));
        processes.put("robots", standIn);
        int port = Integer.parseInt(lines(standIn).readLine());
        Path plant = writePlant(folder.path(), robots, port, brokerPort);
        processes.put("gateway", startGateway(plant));
        measure(processes, robots, seconds);
        subscriber.disconnect().join();
      } finally {
        processes.values().forEach(it -> it.destroyForcibly().onExit().join());
      }
    }
  }

  private static String standIn() {
    return RobotsStandIn.class.getName();
  }

  private static String classPath() {
    return System.getProperty("java.class.path");
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private static Process startBroker(Path folder, int port)
      throws IOException, InterruptedException {
    Path config = folder.resolve("mosquitto.conf");
    Files.writeString(
        config,
        "listener "
            + port
            + " 127.0.0.1\nallow_anonymous true\nmax_queued_messages 0\n"
            + "log_type error\n");
    Process broker =
        new ProcessBuilder(BROKER.toString(), "-c", config.toString()).inheritIO().start();
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!listens(port)) {
      if (!broker.isAlive() || System.nanoTime() > end) {
        throw new IOException(BROKER + " does not listen");
      }
      boolean unused = broker.waitFor(20, TimeUnit.MILLISECONDS);
    }
    return broker;
  }

  private static boolean listens(int port) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private Mqtt5AsyncClient subscribe(int port) {
    Mqtt5AsyncClient client =
        MqttClient.builder()
            .useMqttVersion5()
            .serverHost("127.0.0.1")
            .serverPort(port)
            .buildAsync();
    client.connect().join();
    client
        .subscribeWith()
        .topicFilter("robots/+/+")
        .qos(MqttQos.AT_MOST_ONCE)
        .callback(this::arrived)
        .send()
        .join();
    return client;
  }

  private void arrived(Mqtt5Publish message) {
    long now = System.currentTimeMillis();
    if (!counting || message.getTopic().toString().endsWith("status")) {
      return;
    }
    String text = new String(message.getPayloadAsBytes(), StandardCharsets.UTF_8);
    if (!text.contains("\"quality\":\"good\"")) {
      unreadable.incrementAndGet();
      return;
    }
    long read = Instant.parse(text.substring(TIME_FROM, TIME_TO)).toEpochMilli();
    millis.incrementAndGet((int) Math.max(0, Math.min(now - read, millis.length() - 1)));
    messages.incrementAndGet();
  }

  private static Path writePlant(Path folder, int robots, int port, int brokerPort)
      throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 1; i <= robots; i++) {
      text.append("[robots.r%d]%nhost = \"127.0.0.1:%d\"%n".formatted(i, port));
      text.append("server = \"kukavarproxy\"\n");
    }
    text.append("[groups.all]\nvariables = [\"CELL_A\", \"CELL_B\"]\n");
    text.append("period = \"%dms\"%n".formatted(PERIOD.toMillis()));
    text.append("[mqtt]\nurl = \"tcp://127.0.0.1:%d\"%n".formatted(brokerPort));
    return Files.writeString(folder.resolve("plant.toml"), text);
  }

  private Process startGateway(Path plant) throws IOException {
    Process process =
        java(List.of("-Xmx1g", "-jar", gateway.toString(), "--config", plant.toString()));
    Thread reader =
        new Thread(() -> lines(process).lines().forEach(it -> {}), "output of the gateway");
    reader.setDaemon(true);
    reader.start();
    return process;
  }

  private static Process java(List<String> arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(arguments);
    return new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
  }

  private static BufferedReader lines(Process process) {
    return new BufferedReader(
        new InputStreamReader(process.getInputStream(), StandardCharsets.US_ASCII));
  }

  private void measure(Map<String, Process> processes, int robots, int seconds)
      throws InterruptedException, IOException {
    TimeUnit.NANOSECONDS.sleep(WARM_UP.toNanos());
    Map<String, Duration> before = cpu(processes);
    long start = System.nanoTime();
    counting = true;
    TimeUnit.SECONDS.sleep(seconds);
    counting = false;
    double passed = (System.nanoTime() - start) / 1e9;
    Map<String, Duration> after = cpu(processes);
    double expected = robots * STRUCTURES * passed * 1000 / PERIOD.toMillis();
    out.printf(
        Locale.ROOT,
        "%d robots, %.1f s: %.0f values a second, %d messages of %.0f, %d without a value%n",
        robots,
        passed,
        messages.get() * RobotsStandIn.FIELDS / passed,
        messages.get(),
        expected,
        unreadable.get());
    out.printf(
        "from the reading to a subscriber: median %d ms, 99 %% within %d ms, longest %d ms%n",
        percentile(0.5), percentile(0.99), percentile(1));
    for (String name : after.keySet()) {
      double cores = after.get(name).minus(before.get(name)).toNanos() / 1e9 / passed;
      out.printf(Locale.ROOT, "%-10s %.2f cores", name, cores);
      Process process = processes.get(name);
      out.println(process == null ? "" : ", " + residentMegabytes(process) + " MB resident");
    }
  }

  private static Map<String, Duration> cpu(Map<String, Process> processes) {
    Map<String, Duration> used = new LinkedHashMap<>();
    processes.forEach((name, it) -> used.put(name, it.info().totalCpuDuration().orElseThrow()));
    used.put("subscriber", ProcessHandle.current().info().totalCpuDuration().orElseThrow());
    return used;
  }

  private static long residentMegabytes(Process process) throws IOException {
    for (String line : Files.readAllLines(Path.of("/proc/" + process.pid() + "/status"))) {
      if (line.startsWith("VmRSS:")) {
        return Long.parseLong(line.replaceAll("\\D", "")) / 1024;
      }
    }
    return -1;
  }

  /** Returns the number of ms within which this part of the messages arrived. */
  private int percentile(double part) {
    long wanted = (long) Math.ceil(part * messages.get());
    long seen = 0;
    for (int i = 0; i < millis.length(); i++) {
      seen += millis.get(i);
      if (seen >= wanted) {
        return i;
      }
    }
    return millis.length();
  }
}
