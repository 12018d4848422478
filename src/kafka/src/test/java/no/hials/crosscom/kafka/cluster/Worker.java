package no.hials.crosscom.kafka.cluster;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.stream.Collectors;

/** A worker of Kafka Connect in distributed mode, with the settings that the how-to recommends. */
final class Worker implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final Path PLUGINS = Path.of("target", "plugin").toAbsolutePath();
  private static final HttpClient HTTP = HttpClient.newHttpClient();

  private final JavaProcess process;
  private final int port = JavaProcess.freePort();

  Worker(Path folder, String name, int brokerPort) throws IOException {
    if (!Files.isDirectory(PLUGINS.resolve("jopenshowvar-kafka"))) {
      throw new IOException("build the plugin first: " + PLUGINS + " is missing");
    }
    Path config = folder.resolve(name + ".properties");
    Files.writeString(
        config,
        String.join(
            "\n",
            "bootstrap.servers=127.0.0.1:" + brokerPort,
            "group.id=plant",
            "client.id=" + name,
            "listeners=http://127.0.0.1:" + port,
            "rest.advertised.host.name=127.0.0.1",
            "plugin.path=" + PLUGINS,
            "plugin.discovery=service_load",
            "key.converter=org.apache.kafka.connect.storage.StringConverter",
            "value.converter=org.apache.kafka.connect.json.JsonConverter",
            "value.converter.schemas.enable=false",
            "config.storage.topic=connect-configs",
            "config.storage.replication.factor=1",
            "offset.storage.topic=connect-offsets",
            "offset.storage.replication.factor=1",
            "offset.storage.partitions=1",
            "status.storage.topic=connect-status",
            "status.storage.replication.factor=1",
            "status.storage.partitions=1",
            "offset.flush.interval.ms=1000",
            "session.timeout.ms=6000",
            "heartbeat.interval.ms=2000",
            "scheduled.rebalance.max.delay.ms=1000",
            "producer.enable.idempotence=true",
            "consumer.session.timeout.ms=6000",
            "consumer.heartbeat.interval.ms=2000",
            ""));
    process =
        new JavaProcess(
            folder, name, "org.apache.kafka.connect.cli.ConnectDistributed", config.toString());
  }

  /** Waits until the worker answers. */
  Worker awaitStart() throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (true) {
      try {
        String unused = get("/connectors");
        return this;
      } catch (IOException e) {
        if (System.nanoTime() - end > 0) {
          throw e;
        }
        process.await(100);
      }
    }
  }

  String get(String path) throws IOException, InterruptedException {
    return send(HttpRequest.newBuilder(uri(path)).timeout(Duration.ofSeconds(10)).build());
  }

  /** Creates a connector, or changes it. */
  String put(String connector, Map<String, String> config)
      throws IOException, InterruptedException {
    String json =
        config.entrySet().stream()
            .map(one -> "\"" + one.getKey() + "\":\"" + one.getValue() + "\"")
            .collect(Collectors.joining(",", "{", "}"));
    return send(
        HttpRequest.newBuilder(uri("/connectors/" + connector + "/config"))
            .header("Content-Type", "application/json")
            .PUT(BodyPublishers.ofString(json))
            .build());
  }

  /** Creates a connector that reads robots into the topic {@code robots}. */
  void read(String connector, Robots robots, int tasks) throws IOException, InterruptedException {
    String unused =
        put(
            connector,
            Map.of(
                "connector.class",
                "no.hials.crosscom.kafka.RobotSourceConnector",
                "tasks.max",
                String.valueOf(tasks),
                "plant",
                robots.file().toString()));
  }

  /** Restarts a connector, but not its tasks. */
  void restart(String connector) throws IOException, InterruptedException {
    String unused =
        send(
            HttpRequest.newBuilder(uri("/connectors/" + connector + "/restart"))
                .POST(BodyPublishers.noBody())
                .build());
  }

  /** Pauses a connector, or resumes it. */
  void setPaused(String connector, boolean paused) throws IOException, InterruptedException {
    String unused =
        send(
            HttpRequest.newBuilder(
                    uri("/connectors/" + connector + (paused ? "/pause" : "/resume")))
                .PUT(BodyPublishers.noBody())
                .build());
  }

  void delete(String connector) throws IOException, InterruptedException {
    HttpRequest request = HttpRequest.newBuilder(uri("/connectors/" + connector)).DELETE().build();
    HttpResponse<String> unused = HTTP.send(request, BodyHandlers.ofString());
  }

  private URI uri(String path) {
    return URI.create("http://127.0.0.1:" + port + path);
  }

  private static String send(HttpRequest request) throws IOException, InterruptedException {
    HttpResponse<String> response = HTTP.send(request, BodyHandlers.ofString());
    if (response.statusCode() >= 300) {
      throw new IOException(response.statusCode() + " " + response.body());
    }
    return response.body();
  }

  /** Waits for a short time; throws if the process has ended. */
  void await(long millis) throws IOException, InterruptedException {
    process.await(millis);
  }

  void signal(String name) throws IOException, InterruptedException {
    process.signal(name);
  }

  Path log() {
    return process.log();
  }

  JavaProcess process() {
    return process;
  }

  @Override
  public void close() {
    process.close();
  }
}
