package no.hials.crosscom.cli.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.PipedReader;
import java.io.PipedWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.Cli;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The addresses of {@code web}, and its certificates. */
@Timeout(60)
class WebCommandTest {
  @TempDir private Path folder;

  @Test
  void tlsHasACertificateWhoseFingerprintStaysTheSame() throws Exception {
    String first = run("--host", "127.0.0.2", "--tls");
    String second = run("--host", "127.0.0.2", "--tls");

    assertThat(first)
        .startsWith("https://127.0.0.2:")
        .containsPattern("jopenshowvar: made a certificate with the SHA-256 fingerprint [0-9A-F]");
    assertThat(second).contains("jopenshowvar: the certificate with the SHA-256 fingerprint ");
    assertThat(fingerprint(second)).isEqualTo(fingerprint(first)).hasSize(95);
    assertThat(folder.resolve("tls/page.pem")).exists();
  }

  @Test
  void aCertificateThatLacksANameIsReported() throws Exception {
    run("--tls");
    Path pem = folder.resolve("tls/page.pem");

    String said = run("--tls-cert", pem.toString(), "--host", "127.0.0.1", "--host", "cell-pc");

    assertThat(said)
        .startsWith("https://127.0.0.1:")
        .contains("browsers will warn: the certificate is not for cell-pc");
  }

  @Test
  void theProblemsOfAnArchiveAreReported() throws Exception {
    Path program = folder.resolve("cell/KRC/R1/Program");
    Files.createDirectories(program);
    Files.writeString(program.resolve("main.src"), "DEF MAIN( )\nMISSING()\nEND\n");

    assertThat(run("--archive", folder.resolve("cell").toString()))
        .contains("loaded with 1 warning KRC/R1/Program/main.src")
        .contains("KRC/R1/Program/main.src:2:1: ");
  }

  private static String fingerprint(String said) {
    return said.replaceAll("(?s).*fingerprint (\\S+).*", "$1");
  }

  /** Runs the command until it has printed the link; returns it and then what is on stderr. */
  private String run(String... options) throws Exception {
    String[] args = {"web", "--mock", "--port", "0", "--data", folder.toString()};
    String[] all = new String[args.length + options.length];
    System.arraycopy(args, 0, all, 0, args.length);
    System.arraycopy(options, 0, all, args.length, options.length);
    StringWriter err = new StringWriter();
    CompletableFuture<Integer> code = new CompletableFuture<>();
    try (PipedWriter out = new PipedWriter();
        BufferedReader printed = new BufferedReader(new PipedReader(out))) {
      Thread thread = new Thread(() -> code.complete(Main.run(all, out, err)));
      thread.start();
      String link = printed.readLine();
      thread.interrupt();
      code.join();
      return link + "\n" + err;
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--host 192.0.2.7 | --host 192.0.2.7: other computers reach this address, so the page needs"
            + " TLS: add --tls",
        "--host 0.0.0.0 | --host 0.0.0.0: other computers reach this address",
        "--host :: | --host ::: other computers reach this address",
        "--host a/b | --host: 'a/b' is neither a name nor an address",
        "--host name.invalid | --host: there is no address of name.invalid",
        "--tls --tls-cert a.pem | --tls, --tls-cert and --keystore exclude each other",
        "--tls-key a.pem | --tls-key goes with --tls-cert",
        "--tls --tls-password-file a | --tls-password-file goes with --tls-cert or --keystore",
        "--tls-cert none.pem | cannot read none.pem: file not found",
        "--keystore none.p12 | cannot read the key store none.p12",
        "--keystore none.p12 --tls-password-file none | cannot read none: file not found",
        "--stl none | --stl: there is no folder 'none'",
        "--stl= | --stl: there is no folder ''"
      })
  void wrongOptionsAreReportedBeforeAnythingListens(String options, String message) {
    Cli.Result result =
        Cli.run(("web --mock --port 0 --data " + folder + " " + options).split(" "));

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.out()).isEmpty();
    assertThat(result.err()).startsWith("jopenshowvar: " + message);
  }

  @Test
  void aPortInUseIsNamed() throws Exception {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      String port = Integer.toString(other.getLocalPort());

      Cli.run("web", "--mock", "--port", port, "--data", folder.toString())
          .failsInALine(3)
          .startsWith("jopenshowvar: cannot listen on port " + port + ": ")
          .doesNotContain("internal error");
    }
  }

  @Test
  void thePasswordOfAKeyStoreIsInAFile() throws Exception {
    Path store = folder.resolve("page.p12");
    Process keytool =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                "-genkeypair",
                "-keyalg",
                "EC",
                "-dname",
                "CN=test",
                "-keystore",
                store.toString(),
                "-storepass",
                "secret word")
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("keytool.txt").toFile())
            .start();
    assertThat(keytool.waitFor()).isZero();
    Path right = Files.writeString(folder.resolve("right.txt"), "secret word\n");
    Path wrong = Files.writeString(folder.resolve("wrong.txt"), "secret\n");

    String said = run("--keystore", store.toString(), "--tls-password-file", right.toString());
    Cli.Result refused =
        Cli.run(
            "web",
            "--mock",
            "--keystore",
            store.toString(),
            "--tls-password-file",
            wrong.toString());

    assertThat(said).startsWith("https://127.0.0.1:");
    assertThat(refused.code()).isEqualTo(2);
    assertThat(refused.err()).contains("the password of " + store + " is wrong");
  }
}
