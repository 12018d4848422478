package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.MqttClientSslConfig;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.internal.broker.BrokerSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LoginIT extends BrokerTest {
  private void run(String... command) throws Exception {
    List<String> all = new ArrayList<>(List.of(command));
    File log = folder.resolve("command.log").toFile();
    int code =
        new ProcessBuilder(all)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(log)
            .start()
            .waitFor();
    assertThat(code).as(Files.readString(log.toPath())).isZero();
  }

  /** Creates a key and its certificate for a name, in the files key.pem and ca.pem. */
  private void createCertificate(String name) throws Exception {
    Path keytool = Path.of(System.getProperty("java.home"), "bin", "keytool");
    List<String> store = List.of("-keystore", "k.p12", "-storepass", "secret1", "-alias", "k");
    List<String> create = new ArrayList<>(List.of(keytool.toString(), "-genkeypair"));
    create.addAll(store);
    create.addAll(
        List.of("-keyalg", "EC", "-dname", "CN=broker", "-ext", "san=" + name, "-validity", "2"));
    run(create.toArray(String[]::new));
    List<String> export =
        new ArrayList<>(List.of(keytool.toString(), "-exportcert", "-rfc", "-file", "ca.pem"));
    export.addAll(store);
    run(export.toArray(String[]::new));
    KeyStore keys = KeyStore.getInstance(folder.resolve("k.p12").toFile(), "secret1".toCharArray());
    String key =
        Base64.getMimeEncoder(64, new byte[] {'\n'})
            .encodeToString(keys.getKey("k", "secret1".toCharArray()).getEncoded());
    Files.writeString(
        folder.resolve("key.pem"),
        "-----BEGIN PRIVATE KEY-----\n" + key + "\n-----END PRIVATE KEY-----\n");
  }

  private Mosquitto tlsBroker() throws Exception {
    return new Mosquitto(
        folder,
        "allow_anonymous true\nuser root\ncertfile "
            + folder.resolve("ca.pem")
            + "\nkeyfile "
            + folder.resolve("key.pem"));
  }

  private Observer tlsObserver(int port) throws Exception {
    return new Observer(
        "127.0.0.1",
        port,
        null,
        null,
        MqttClientSslConfig.builder()
            .trustManagerFactory(BrokerSettings.trust(folder.resolve("ca.pem")))
            .hostnameVerifier((host, session) -> true)
            .build());
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 5})
  void logsInWithAPasswordFromAFile(int version) throws Exception {
    Path passwords = folder.resolve("passwords");
    Files.writeString(passwords, "");
    run("mosquitto_passwd", "-b", passwords.toString(), "gateway", "right");
    broker = new Mosquitto(folder, "allow_anonymous false\nuser root\npassword_file " + passwords);
    Files.writeString(folder.resolve("password"), "wrong\n");
    Gateway running =
        start(
            READ_ALL
                + mqtt(
                    broker,
                    "user = \"gateway\"",
                    "password-file = \"password\"",
                    "version = " + version));
    try (Observer observer =
        new Observer("127.0.0.1", broker.port(), "gateway", "right", null).subscribe("robots/#")) {
      await(() -> figure(running, "mqtt_messages_stored") > 0);
      assertThat(figure(running, "mqtt_connected")).isZero();

      Files.writeString(folder.resolve("password"), "right\n");

      observer.await("robots/cell1/$OV_PRO", "good");
    }
  }

  @Test
  void aTopicThatTheBrokerRefusesHasOneLineInTheLog() throws Exception {
    Files.writeString(folder.resolve("acl"), "topic read #\n");
    broker =
        new Mosquitto(
            folder,
            "max_queued_messages 1000\nallow_anonymous true\nuser root\nacl_file "
                + folder.resolve("acl"));
    Gateway running = start(READ_ALL + mqtt(broker));
    await(() -> figure(running, "mqtt_messages_dropped") > 50);

    assertThat(lines.get())
        .filteredOn(it -> it.contains("$OV_PRO"))
        .containsExactly(
            "MQTT plain: the broker refuses robots/cell1/$OV_PRO: not authorized; further"
                + " refusals of the topic are only counted");
  }

  @Test
  void encryptsAndChecksTheCertificate() throws Exception {
    createCertificate("ip:127.0.0.1");
    broker = tlsBroker();
    try (Observer observer = tlsObserver(broker.port()).subscribe("robots/#")) {
      start(
          READ_ALL
              + "[mqtt]\nurl = \"ssl://127.0.0.1:"
              + broker.port()
              + "\"\nca-file = \"ca.pem\"\n");

      observer.await("robots/cell1/$OV_PRO", "good");
    }
  }

  @Test
  void refusesABrokerWithTheCertificateOfAnotherName() throws Exception {
    createCertificate("dns:other.example");
    broker = tlsBroker();
    try (Observer observer = tlsObserver(broker.port()).subscribe("robots/#")) {
      Gateway running =
          start(
              READ_ALL
                  + "[mqtt]\nurl = \"ssl://127.0.0.1:"
                  + broker.port()
                  + "\"\nca-file = \"ca.pem\"\n");

      await(() -> figure(running, "mqtt_messages_stored") > 20);

      assertThat(figure(running, "mqtt_connected")).isZero();
      assertThat(observer.all()).isEmpty();
      assertThat(Files.readString(folder.resolve("mosquitto.log"))).contains("alert");
    }
  }
}
