package no.hials.crosscom.web.internal.http;

import java.security.SecureRandom;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Base64;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import no.hials.crosscom.web.Role;
import org.jspecify.annotations.Nullable;

/**
 * The tokens of links, each for one use, and the sessions of the browsers that used them.
 * Thread-safe.
 */
public final class Tokens {
  /** The time after which a link made by a browser expires. A link of the command does not. */
  public static final Duration LINK_TIME = Duration.ofMinutes(10);

  private static final SecureRandom RANDOM = new SecureRandom();
  private static final int BYTES = 32;

  /** More links than browsers can make in {@link #LINK_TIME}, so that they displace no other. */
  private static final int MAX_LINKS = 256;

  private static final int MAX_SESSIONS = 256;

  private final Clock clock;

  /** The unused links by their tokens; the oldest ones are forgotten. Guarded by this. */
  private final Map<String, Link> links =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Link> eldest) {
          return size() > MAX_LINKS;
        }
      };

  private final Map<String, BrowserSession> sessions = new ConcurrentHashMap<>();
  private final AtomicInteger numbers = new AtomicInteger();
  private final List<Consumer<BrowserSession>> atOpen = new CopyOnWriteArrayList<>();

  /**
   * A link that nobody has used.
   *
   * @param role the rights of the browser that uses it
   * @param label a name for that browser; may be empty
   * @param issuer the browser that made the link; null for a link of the command
   * @param end the time from which it is not valid
   */
  private record Link(Role role, String label, @Nullable BrowserSession issuer, Instant end) {}

  public Tokens(Clock clock) {
    this.clock = clock;
  }

  /** Returns 256 random bits, as text for an address or a header. */
  static String random() {
    byte[] bytes = new byte[BYTES];
    RANDOM.nextBytes(bytes);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  /** Adds a task that is called with each new browser. */
  public void atOpen(Consumer<BrowserSession> task) {
    atOpen.add(task);
  }

  /** Returns the token of a new link, which is valid until it is used. */
  public synchronized String newLink(Role role) {
    return put(new Link(role, "", null, Instant.MAX));
  }

  /**
   * Returns the token of a new link that a browser makes for another one.
   *
   * @param label a name for the other browser; may be empty
   * @return the token; empty if the issuer has been sent away, or has fewer rights than the role
   */
  public synchronized Optional<String> newLink(Role role, String label, BrowserSession issuer) {
    if (!issuer.isIn() || !issuer.role().includes(role)) {
      return Optional.empty();
    }
    return Optional.of(put(new Link(role, label, issuer, clock.instant().plus(LINK_TIME))));
  }

  private String put(Link link) {
    String token = random();
    links.put(token, link);
    return token;
  }

  /**
   * Uses up the token of a link.
   *
   * @return the key of a new session, for the cookie; empty if the token is unknown, used or
   *     expired
   */
  public Optional<String> open(String token) {
    String key = random();
    BrowserSession browser;
    synchronized (this) {
      Link link = links.remove(token);
      if (link == null || !clock.instant().isBefore(link.end) || sessions.size() >= MAX_SESSIONS) {
        return Optional.empty();
      }
      String issuer = link.issuer == null ? "the command line" : link.issuer.name();
      browser =
          new BrowserSession(
              numbers.incrementAndGet(), link.role, link.label, issuer, clock.instant());
      sessions.put(key, browser);
    }
    atOpen.forEach(task -> task.accept(browser));
    return Optional.of(key);
  }

  /** Returns the session that a cookie names. */
  Optional<BrowserSession> session(String key) {
    return Optional.ofNullable(sessions.get(key));
  }

  /** Returns the browsers with a session, the oldest first. */
  public List<BrowserSession> browsers() {
    return sessions.values().stream()
        .sorted(Comparator.comparingInt(BrowserSession::number))
        .toList();
  }

  /** Ends the session of a browser, and removes the unused links that it made. */
  public synchronized void end(BrowserSession browser) {
    browser.end();
    sessions.values().remove(browser);
    links.values().removeIf(link -> link.issuer == browser);
  }
}
