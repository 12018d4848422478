package no.hials.crosscom.gateway.internal.opcua;

import io.prometheus.metrics.core.metrics.Counter;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.cell.FileException;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.sdk.server.identity.AbstractIdentityValidator;
import org.eclipse.milo.opcua.sdk.server.identity.AbstractUsernameIdentityValidator;
import org.eclipse.milo.opcua.sdk.server.identity.AbstractX509IdentityValidator;
import org.eclipse.milo.opcua.sdk.server.identity.CompositeValidator;
import org.eclipse.milo.opcua.sdk.server.identity.DefaultAnonymousIdentity;
import org.eclipse.milo.opcua.sdk.server.identity.DefaultUsernameIdentity;
import org.eclipse.milo.opcua.sdk.server.identity.DefaultX509UserIdentity;
import org.eclipse.milo.opcua.sdk.server.identity.Identity;
import org.eclipse.milo.opcua.sdk.server.identity.IdentityValidator;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.enumerated.UserTokenType;
import org.eclipse.milo.opcua.stack.core.types.structured.AnonymousIdentityToken;
import org.eclipse.milo.opcua.stack.core.types.structured.SignatureData;
import org.eclipse.milo.opcua.stack.core.types.structured.UserTokenPolicy;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Decides who may log in. Files of passwords and certificates are read at each log-in, so that
 * another password needs no restart.
 */
final class Users {
  private static final Logger LOG = LoggerFactory.getLogger(Users.class);

  /** The maximum number of refusals in the log in a time. */
  private static final int MOST_LINES = 20;

  private static final Duration LINES_TIME = Duration.ofSeconds(10);

  private final OpcUaSettings settings;
  private final Counter refused;
  private long firstLine = System.nanoTime();
  private int lines;

  Users(OpcUaSettings settings, Counter refused) {
    this.settings = settings;
    this.refused = refused;
  }

  /** Returns the first line of a file. */
  static String passwordOf(Path file) throws IOException {
    String password;
    try {
      password = Files.readString(file).lines().findFirst().orElse("");
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
    if (password.isBlank()) {
      throw new IOException("the first line of " + file + " must be the password, is empty");
    }
    return password;
  }

  /** Returns the certificate of a file in DER or PEM. */
  static X509Certificate certificateOf(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(in);
    } catch (CertificateException | IOException e) {
      throw new IOException("cannot read " + file + ": it must be a certificate in DER or PEM", e);
    }
  }

  /** Returns the start of a text from a client without line breaks, for one line in the log. */
  static String printable(String text) {
    return text.substring(0, Math.min(text.length(), 100)).replaceAll("\\p{Cntrl}|\\R", "?");
  }

  /** Returns the user of a session. */
  static User of(Session session) {
    Identity identity = session.getIdentity();
    return identity != null && identity.getUserData() instanceof User user ? user : User.ANONYMOUS;
  }

  /** Returns whether users can log in by name. */
  boolean hasPasswords() {
    return settings.users().stream().anyMatch(it -> it.passwordFile() != null);
  }

  /** Returns whether users can log in by certificate. */
  boolean hasCertificates() {
    return settings.users().stream().anyMatch(it -> it.certificate() != null);
  }

  IdentityValidator validator() {
    return new CompositeValidator(
        List.of(new AnonymousUsers(), new PasswordUsers(), new CertificateUsers()));
  }

  private final class AnonymousUsers extends AbstractIdentityValidator {
    @Override
    public Set<UserTokenType> getSupportedTokenTypes() {
      return EnumSet.of(UserTokenType.Anonymous);
    }

    @Override
    protected Identity.AnonymousIdentity validateAnonymousToken(
        Session session,
        AnonymousIdentityToken token,
        UserTokenPolicy policy,
        SignatureData signature)
        throws UaException {
      if (!settings.anonymous()) {
        refuse(session, "a client without a name");
        throw new UaException(StatusCodes.Bad_IdentityTokenRejected);
      }
      Identity.AnonymousIdentity identity = new DefaultAnonymousIdentity();
      identity.setUserData(User.ANONYMOUS);
      return identity;
    }
  }

  private final class PasswordUsers extends AbstractUsernameIdentityValidator {
    @Override
    protected Identity.@Nullable UsernameIdentity authenticateUsernamePassword(
        Session session, String name, String password) {
      for (User user : settings.users()) {
        Path file = user.passwordFile();
        if (user.name().equals(name) && file != null && isPassword(file, password)) {
          Identity.UsernameIdentity identity = new DefaultUsernameIdentity(name);
          identity.setUserData(user);
          return identity;
        }
      }
      refuse(session, "user '" + printable(name) + "'");
      return null;
    }
  }

  private static boolean isPassword(Path file, String given) {
    try {
      return MessageDigest.isEqual(
          passwordOf(file).getBytes(StandardCharsets.UTF_8),
          given.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      LOG.warn("OPC UA: {}", e.getMessage());
      return false;
    }
  }

  private final class CertificateUsers extends AbstractX509IdentityValidator {
    @Override
    protected Identity.@Nullable X509UserIdentity authenticateCertificate(
        Session session, X509Certificate certificate) {
      for (User user : settings.users()) {
        Path file = user.certificate();
        if (file != null && isCertificate(file, certificate)) {
          Identity.X509UserIdentity identity = new DefaultX509UserIdentity(certificate);
          identity.setUserData(user);
          return identity;
        }
      }
      refuse(
          session,
          "the certificate of " + printable(certificate.getSubjectX500Principal().getName()));
      return null;
    }
  }

  private static boolean isCertificate(Path file, X509Certificate given) {
    try {
      given.checkValidity();
      return certificateOf(file).equals(given);
    } catch (IOException | CertificateException e) {
      LOG.warn("OPC UA: {}", e.getMessage());
      return false;
    }
  }

  private void refuse(Session session, String who) {
    refuse(session.getClientAddress(), who);
  }

  /** Counts a refused log-in, and logs it if there are not too many. */
  synchronized void refuse(InetAddress address, String who) {
    refused.inc();
    long now = System.nanoTime();
    if (now - firstLine > LINES_TIME.toNanos()) {
      firstLine = now;
      lines = 0;
    }
    lines++;
    if (lines <= MOST_LINES) {
      LOG.warn(
          "OPC UA: {} at {} may not log in{}",
          who,
          address,
          lines < MOST_LINES ? "" : "; further refusals of the next seconds are only counted");
    }
  }
}
