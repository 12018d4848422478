package no.hials.crosscom.web.internal.http;

import java.security.SecureRandom;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.web.Role;

/** The tokens of links, each for one use, and the sessions of the browsers that used them. */
public final class Tokens {
  private static final SecureRandom RANDOM = new SecureRandom();
  private static final int BYTES = 32;
  private static final int MOST_LINKS = 64;
  private static final int MOST_SESSIONS = 256;

  /** The roles of unused links; the oldest ones are forgotten. */
  private final Map<String, Role> links =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Role> eldest) {
          return size() > MOST_LINKS;
        }
      };

  private final Map<String, BrowserSession> sessions = new ConcurrentHashMap<>();
  private final AtomicInteger numbers = new AtomicInteger();

  /** Returns 256 random bits, as text for an address or a header. */
  static String random() {
    byte[] bytes = new byte[BYTES];
    RANDOM.nextBytes(bytes);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  /** Returns the token of a new link. */
  public synchronized String newLink(Role role) {
    String token = random();
    links.put(token, role);
    return token;
  }

  /**
   * Uses up the token of a link.
   *
   * @return the key of a new session, for the cookie; empty if the token is unknown or was used
   */
  Optional<String> open(String token) {
    Role role;
    synchronized (this) {
      role = links.remove(token);
    }
    if (role == null || sessions.size() >= MOST_SESSIONS) {
      return Optional.empty();
    }
    String key = random();
    sessions.put(key, new BrowserSession(numbers.incrementAndGet(), role));
    return Optional.of(key);
  }

  /** Returns the session that a cookie names. */
  Optional<BrowserSession> session(String key) {
    return Optional.ofNullable(sessions.get(key));
  }
}
