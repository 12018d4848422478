package no.hials.crosscom.gateway;

import static no.hials.crosscom.gateway.OpcUaPlant.awaitGood;
import static no.hials.crosscom.gateway.OpcUaPlant.robots;
import static no.hials.crosscom.gateway.OpcUaPlant.write;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyPair;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.internal.opcua.OpcUaKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.sdk.client.OpcUaClientConfigBuilder;
import org.eclipse.milo.opcua.sdk.client.identity.IdentityProvider;
import org.eclipse.milo.opcua.sdk.client.identity.SignedIdentityToken;
import org.eclipse.milo.opcua.sdk.client.identity.X509IdentityProvider;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.security.SecurityAlgorithm;
import org.eclipse.milo.opcua.stack.core.security.SecurityPolicy;
import org.eclipse.milo.opcua.stack.core.types.builtin.ByteString;
import org.eclipse.milo.opcua.stack.core.types.structured.SignatureData;
import org.eclipse.milo.opcua.stack.core.types.structured.UserNameIdentityToken;
import org.eclipse.milo.opcua.stack.core.util.SelfSignedCertificateBuilder;
import org.eclipse.milo.opcua.stack.core.util.SelfSignedCertificateGenerator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

@Timeout(60)
class OpcUaSecurityTest {
  private static final String CLIENT_URI = "urn:test:client";

  /** Shared by all tests, since the server's key takes time to create. */
  @TempDir private static Path folder;

  private static KeyPair keys;
  private static X509Certificate certificate;

  @KukaController private MockServer robot;

  @BeforeAll
  static void createCertificate() throws Exception {
    keys = SelfSignedCertificateGenerator.generateRsaKeyPair(2048);
    certificate =
        new SelfSignedCertificateBuilder(keys)
            .setCommonName("client")
            .setApplicationUri(CLIENT_URI)
            .addDnsName("localhost")
            .build();
    Files.write(folder.resolve("client.der"), certificate.getEncoded());
    Files.writeString(folder.resolve("password.txt"), "of anna");
  }

  @BeforeEach
  void trustNobody() throws IOException {
    Files.deleteIfExists(trusted());
  }

  private static Path trusted() {
    return folder.resolve("opcua/pki/trusted/certs/client.der");
  }

  private static void trust() throws Exception {
    Files.createDirectories(trusted().getParent());
    Files.write(trusted(), certificate.getEncoded());
  }

  private OpcUaPlant plant(String settings) throws IOException {
    return new OpcUaPlant(
        folder,
        """
        [robots.cell1]
        host = "%s"
        port = %d
        timeout = "1s"

        [groups.all]
        variables = ["$OV_PRO"]
        period = "20ms"

        [variables."$OV_PRO"]
        range = [0, 100]
        write = true

        [opcua]
        address = "127.0.0.1:PORT"
        %s

        [opcua.users.anna]
        role = "operator"
        certificate = "client.der"
        """
            .formatted(robot.host(), robot.port(), settings));
  }

  private static Consumer<OpcUaClientConfigBuilder> withCertificate(
      Consumer<OpcUaClientConfigBuilder> more) {
    return config -> {
      config
          .setApplicationUri(CLIENT_URI)
          .setKeyPair(keys)
          .setCertificate(certificate)
          .setCertificateChain(new X509Certificate[] {certificate});
      more.accept(config);
    };
  }

  @ParameterizedTest
  @EnumSource(
      value = SecurityPolicy.class,
      names = {"Basic256Sha256", "Aes128_Sha256_RsaOaep", "Aes256_Sha256_RsaPss"})
  void trustedClientsReadOverAnEncryptedConnection(SecurityPolicy policy) throws Exception {
    trust();
    try (OpcUaPlant plant = plant("")) {
      OpcUaClient client = plant.connect(policy, withCertificate(config -> {}));
      try {
        assertThat(awaitGood(client, "cell1:$OV_PRO").value().value()).isEqualTo(100);
      } finally {
        client.disconnect();
      }
    }
  }

  @Test
  void unknownClientsAreRejectedAndTheirCertificatesKept() throws Exception {
    try (OpcUaPlant plant = plant("")) {
      assertThatThrownBy(
              () -> plant.connect(SecurityPolicy.Basic256Sha256, withCertificate(config -> {})))
          .isInstanceOf(UaException.class);
    }
    try (var rejected = Files.list(folder.resolve("opcua/pki/rejected"))) {
      assertThat(rejected).isNotEmpty();
    }
  }

  @Test
  void aUserLogsInByCertificateAndWrites() throws Exception {
    trust();
    try (OpcUaPlant plant = plant("anonymous = false")) {
      OpcUaClient client =
          plant.connect(
              SecurityPolicy.Basic256Sha256,
              withCertificate(
                  config ->
                      config.setIdentityProvider(
                          new X509IdentityProvider(certificate, keys.getPrivate()))));
      try {
        awaitGood(client, "cell1:$OV_PRO");
        assertThat(write(client, robots(client, "cell1:$OV_PRO"), 12)).isEqualTo(StatusCodes.Good);
      } finally {
        client.disconnect();
      }
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("12");
    assertThat(Files.readString(folder.resolve("audit.jsonl"))).contains("opcua:anna");
  }

  @Test
  void anotherCertificateDoesNotLogIn() throws Exception {
    KeyPair others = SelfSignedCertificateGenerator.generateRsaKeyPair(2048);
    X509Certificate other = new SelfSignedCertificateBuilder(others).setCommonName("other").build();
    try (OpcUaPlant plant = plant("")) {
      assertThatThrownBy(
              () ->
                  plant.connect(
                      SecurityPolicy.None,
                      config ->
                          config.setIdentityProvider(
                              new X509IdentityProvider(other, others.getPrivate()))))
          .isInstanceOf(UaException.class);
    }
  }

  @Test
  void anEmptyPasswordIsRefusedWithAnAnswer() throws Exception {
    trust();
    String users = "[opcua.users.vera]\nrole = \"viewer\"\npassword-file = \"password.txt\"";
    IdentityProvider empty =
        (endpoint, nonce) ->
            new SignedIdentityToken(
                new UserNameIdentityToken(
                    "username",
                    "vera",
                    ByteString.of(new byte[0]),
                    SecurityAlgorithm.RsaOaepSha1.getUri()),
                new SignatureData(null, null));
    try (OpcUaPlant plant = plant(users)) {
      assertThatThrownBy(
              () ->
                  plant.connect(
                      SecurityPolicy.Basic256Sha256,
                      withCertificate(config -> config.setIdentityProvider(empty))))
          .hasMessageContaining("Bad_IdentityTokenInvalid");

      assertThat(plant.health().counter("opcua_logins_refused", "").get()).isOne();
    }
  }

  @Test
  void nobodyReadsWithoutANameIfTheConfigurationForbidsIt() throws Exception {
    try (OpcUaPlant plant = plant("anonymous = false")) {
      assertThatThrownBy(plant::connect).isInstanceOf(Exception.class);
    }
  }

  @Test
  void aPortInUseIsAnErrorWithItsReason() throws Exception {
    List<OutputKind<?>> kinds = List.of(new OpcUaKind());
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      TomlTable root =
          TomlTable.parse(
              folder.resolve("plant.toml"),
              """
              [robots.cell1]
              host = "%s:%d"
              [opcua]
              address = "127.0.0.1:%d"
              """
                  .formatted(robot.host(), robot.port(), other.getLocalPort()));
      GatewayConfig config = GatewayConfig.read(root, folder, Map.of(), kinds);

      assertThatThrownBy(() -> Gateway.start(config, kinds, RobotConnection::openLazily))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("127.0.0.1:" + other.getLocalPort() + ": Address already in use");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          address = "0.0.0.0:4840" | plant.toml:2: opcua.address: 0.0.0.0 can be reached from other computers: it needs a user
          address = "0.0.0.0:4840"; anonymous = true | it needs a user
          address = "192.0.2.1:x" | plant.toml:2: opcua.address: the port must be
          anonymous = false | plant.toml:2: opcua.anonymous: must be true without users, or nobody can log in
          anonymous = "no" | plant.toml:2: opcua.anonymous: must be true or false, without quotes
          users.vera.role = "chief" | opcua.users.vera.role: must be "operator" or "viewer", is chief
          users.vera.role = "viewer" | opcua.users.vera: needs a password-file or a certificate
          users.vera.role = "viewer"; users.vera.password-file = "none.txt" | none.txt: file not found
          users.vera.role = "viewer"; users.vera.certificate = "password.txt" | password.txt: it must be a certificate in DER or PEM
          port = 4840 | plant.toml:2: opcua.port: no such key; known: address, anonymous, allow-none, users
          """)
  void wrongSettingsAreErrorsWithLineAndRule(String settings, String message) throws Exception {
    String text = "[opcua]\n" + String.join("\n", List.of(settings.split("; ")));
    TomlTable root = TomlTable.parse(folder.resolve("plant.toml"), text);

    assertThatThrownBy(() -> new OpcUaKind().read(root.table("opcua")))
        .isInstanceOf(FileException.class)
        .hasMessageContaining(message);
  }
}
