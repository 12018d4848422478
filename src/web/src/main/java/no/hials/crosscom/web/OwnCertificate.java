package no.hials.crosscom.web;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.FileException;

/**
 * A self-signed certificate, kept in a file so that its fingerprint stays the same. The {@code
 * keytool} of the running Java creates it: the JDK has no API for that, and a library for it is
 * larger than the whole web server.
 *
 * @param certificate the certificate
 * @param isNew whether the certificate was just created
 */
public record OwnCertificate(ServerCertificate certificate, boolean isNew) {
  private static final int DAYS = 365;
  private static final Duration MIN_VALIDITY = Duration.ofDays(30);
  private static final int MAX_SECONDS = 60;
  private static final String PASSWORD = "JOPENSHOWVAR_KEYTOOL";

  /**
   * Returns the certificate in a folder. Creates one if the folder has none, if it expires within
   * 30 days, or if it lacks a name of the page.
   *
   * @param folder the folder of its file {@code page.pem}, which only its owner may read
   * @throws FileException if the file cannot be written, or this Java has no {@code keytool}
   */
  public static OwnCertificate in(Path folder, PageAddress address) throws IOException {
    return in(folder, address, Path.of(System.getProperty("java.home")));
  }

  static OwnCertificate in(Path folder, PageAddress address, Path java) throws IOException {
    Path file = folder.resolve("page.pem");
    if (Files.exists(file)) {
      ServerCertificate kept = ServerCertificate.readPem(file, file, null);
      Instant now = Instant.now();
      if (kept.isValid(now)
          && kept.isValid(now.plus(MIN_VALIDITY))
          && address.names().stream().allMatch(kept::isFor)) {
        return new OwnCertificate(kept, false);
      }
    }
    try {
      createPrivate(folder);
      ServerCertificate made = make(java, folder, address.names());
      Path next = folder.resolve("page.pem.new");
      Files.deleteIfExists(next);
      Files.createFile(next, privately(folder, "rw-------"));
      Files.writeString(next, made.pem(), StandardCharsets.US_ASCII);
      Files.move(next, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
      return new OwnCertificate(made, true);
    } catch (FileException e) {
      throw e;
    } catch (IOException e) {
      throw FileException.cannot("write", file, e);
    }
  }

  private static void createPrivate(Path folder) throws IOException {
    Path parent = folder.toAbsolutePath().resolve("..").normalize();
    Files.createDirectories(parent);
    try {
      Files.createDirectory(folder, privately(parent, "rwx------"));
    } catch (FileAlreadyExistsException e) {
      // an existing folder keeps its permissions
    }
  }

  /** Returns the permissions of a new file; on other systems than Unix, those of its folder. */
  private static FileAttribute<?>[] privately(Path folder, String permissions) throws IOException {
    return Files.getFileStore(folder).supportsFileAttributeView("posix")
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(permissions))
        }
        : new FileAttribute<?>[0];
  }

  private static ServerCertificate make(Path java, Path folder, List<String> names)
      throws IOException {
    byte[] random = new byte[24];
    new SecureRandom().nextBytes(random);
    String password = Base64.getUrlEncoder().encodeToString(random);
    Path store = folder.resolve("page.p12");
    Files.deleteIfExists(store);
    try {
      keytool(java, store, password, names);
      return ServerCertificate.readKeyStore(store, password.toCharArray());
    } catch (GeneralSecurityException e) {
      throw new FileException("cannot read what keytool has made: " + e.getMessage(), e);
    } finally {
      Files.deleteIfExists(store);
    }
  }

  private static void keytool(Path java, Path store, String password, List<String> names)
      throws IOException {
    Path keytool =
        java.resolve("bin").resolve(File.separatorChar == '/' ? "keytool" : "keytool.exe");
    if (!Files.isExecutable(keytool)) {
      throw new FileException(
          "this Java has no "
              + keytool
              + ", which makes certificates: use a complete JRE, or a certificate of your own");
    }
    String alternatives =
        names.stream()
            .map(it -> (isAddress(it) ? "ip:" : "dns:") + it.replaceAll("[\\[\\]]", ""))
            .collect(Collectors.joining(","));
    ProcessBuilder builder =
        new ProcessBuilder(
            keytool.toString(),
            "-genkeypair",
            "-alias",
            "page",
            "-keyalg",
            "EC",
            "-groupname",
            "secp256r1",
            "-sigalg",
            "SHA256withECDSA",
            "-validity",
            "" + DAYS,
            "-dname",
            "CN=JOpenShowVar",
            "-ext",
            "san=" + alternatives,
            "-ext",
            "ku:critical=digitalSignature",
            "-ext",
            "eku=serverAuth",
            "-storetype",
            "PKCS12",
            "-keystore",
            store.toString(),
            "-storepass:env",
            PASSWORD);
    builder.environment().put(PASSWORD, password); // not an argument, which other users can see
    Path output = store.resolveSibling("keytool.txt");
    try {
      Process process = builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
      if (!process.waitFor(MAX_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        throw new FileException("keytool has not ended within " + MAX_SECONDS + " s");
      }
      if (process.exitValue() != 0) {
        throw new FileException("keytool failed: " + Files.readString(output).strip());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new FileException("interrupted while keytool runs", e);
    } finally {
      Files.deleteIfExists(output);
    }
  }

  private static boolean isAddress(String name) {
    return name.startsWith("[") || name.matches("[0-9.]+");
  }
}
