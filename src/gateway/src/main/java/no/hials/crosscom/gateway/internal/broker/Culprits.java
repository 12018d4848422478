package no.hials.crosscom.gateway.internal.broker;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the messages at which a broker ends the connection, as many brokers do instead of refusing
 * one that is too large or not allowed. After some connections that end soon, messages are sent one
 * at a time. The one that is on its way at an end becomes a suspect, and waits until a connection
 * has lasted for some time without suspects. Then the suspects are sent, one at a time: the one at
 * which this connection ends is blocked for a time, which doubles each time, and is a suspect again
 * after it. So nothing is blocked because of a network in which no connection lasts. There, the
 * search is given up after some time. Not thread-safe.
 *
 * <p>A message has a name: its topic or, if it was stored, one of its own; but if its topic is a
 * suspect, a stored message is sent to test the topic. One without a name is never a suspect.
 */
final class Culprits {
  private static final Logger LOG = LoggerFactory.getLogger(Culprits.class);

  /** The number of connections, one after the other, that end soon. */
  private static final int ENDS = 3;

  private static final long SOON = TimeUnit.SECONDS.toNanos(3);

  /** After this time without an end, the broker has accepted a message that it has confirmed. */
  static final long SETTLING = TimeUnit.MILLISECONDS.toNanos(10);

  private static final long LASTING = TimeUnit.SECONDS.toNanos(10);
  private static final long LONGEST_SEARCH = TimeUnit.MINUTES.toNanos(2);
  private static final long FIRST_BLOCK = TimeUnit.SECONDS.toNanos(10);
  private static final long LONGEST_BLOCK = TimeUnit.MINUTES.toNanos(10);

  /** The time for which a message is blocked. */
  private record Block(long until, long length) {}

  /** A suspect that was sent, and when it was confirmed; null if it was not. */
  private record Test(String name, @Nullable Long confirmedAt) {}

  private final String session;
  private final Map<String, Block> blocks = new HashMap<>();
  private final Set<String> suspects = new HashSet<>();

  /** The suspect that was sent and is not accepted; null if none was. */
  private @Nullable Test test;

  /** The last message that was confirmed on this connection; empty if none was. */
  private String confirmed = "";

  private long confirmedAt;

  /** The number of connections that have ended soon, one after the other. */
  private int ends;

  private long connectedAt;
  private long searchSince;

  /** Whether a search has taken too long, and no connection has lasted since. */
  private boolean givenUp;

  /**
   * Creates an object without suspects.
   *
   * @param session the name of the session, for the log
   */
  Culprits(String session) {
    this.session = session;
  }

  /** Called when the broker is connected. */
  void connected(long now) {
    connectedAt = now;
    test = null;
    confirmed = "";
  }

  private boolean lasts(long now) {
    return now - connectedAt >= LASTING;
  }

  /** Returns whether messages are sent one at a time. */
  boolean isSearching(long now) {
    return ends >= ENDS && !givenUp && !lasts(now);
  }

  private boolean hasSuspects() {
    return !suspects.isEmpty() || !blocks.isEmpty();
  }

  private boolean isSuspect(String name) {
    return suspects.contains(name) || blocks.containsKey(name);
  }

  /**
   * Returns the time from the confirmation of a message to the next one, so that it is clear at
   * which the broker ends the connection; 0 if messages are not sent one at a time.
   */
  long pause(long now) {
    return isSearching(now) ? SETTLING : 0;
  }

  private boolean isSettling(long now) {
    return !confirmed.isEmpty() && now - confirmedAt < SETTLING;
  }

  /** Returns whether a message must be sent later. */
  boolean mustWait(String name, long now) {
    settle(now);
    return isSuspect(name) && !isBlocked(name, now) && (test != null || !lasts(now));
  }

  /** Returns whether a stored message must be sent later. Its name is needed only with suspects. */
  boolean mustWait(StoredMessage message, long now) {
    return hasSuspects() && mustWait(message.name(), now);
  }

  /** Returns the name of a stored message that is sent now. */
  String name(String topic, StoredMessage message) {
    boolean testsTopic = hasSuspects() && isSuspect(topic) && !isSuspect(message.name());
    return testsTopic ? topic : message.name();
  }

  /**
   * Returns why a message is not sent; empty if it is.
   *
   * @param most the maximum size of a packet
   */
  String reasonAgainst(Publication message, String name, int most, long now) {
    if (message.size() > most) {
      return "it has " + message.size() + " bytes, and may have " + most;
    }
    return isBlocked(name, now) || isBlocked(message.topic(), now)
        ? "it has ended connections"
        : "";
  }

  /** Returns whether a message is refused now. */
  boolean isBlocked(String name, long now) {
    Block block = blocks.get(name);
    return block != null && now - block.until < 0;
  }

  /** Called when a message is sent. */
  void sent(String name) {
    if (isSuspect(name)) {
      test = new Test(name, null);
    }
  }

  /** Called when the broker has confirmed or refused a message. */
  void confirmed(String name, long now) {
    confirmed = name;
    confirmedAt = now;
    if (test != null && test.name.equals(name)) {
      test = new Test(name, now);
    }
  }

  /** Frees a suspect that was confirmed some time ago. */
  private void settle(long now) {
    if (test != null && test.confirmedAt != null && now - test.confirmedAt >= SETTLING) {
      suspects.remove(test.name);
      blocks.remove(test.name);
      test = null;
    }
  }

  /**
   * Called when the broker has ended a connection.
   *
   * @param unconfirmed the names of the messages that it has not confirmed
   * @return whether one of them is blocked or waits from now on, so that the next connection will
   *     be better
   */
  boolean ended(Set<String> unconfirmed, long now) {
    settle(now);
    boolean late = unconfirmed.isEmpty() && isSettling(now);
    Set<String> names = late ? Set.of(confirmed) : unconfirmed;
    boolean searching = isSearching(now);
    boolean better = searching && names.size() == 1 && suspects.addAll(names);
    givenUp &= !lasts(now);
    if (now - connectedAt >= (searching ? LASTING : SOON)) {
      ends = 0;
    } else if (!names.isEmpty()) {
      ends++;
    }
    if (ends < ENDS) {
      searchSince = now;
    } else if (now - searchSince > LONGEST_SEARCH && !givenUp) {
      givenUp = true;
      suspects.clear();
    }
    if (test != null) {
      block(test.name, now);
      better = true;
    }
    test = null;
    return better;
  }

  private void block(String culprit, long now) {
    Block last = blocks.get(culprit);
    long length = last == null ? FIRST_BLOCK : Math.min(2 * last.length, LONGEST_BLOCK);
    blocks.put(culprit, new Block(now + length, length));
    suspects.remove(culprit);
    LOG.warn(
        "MQTT {}: the broker ends the connection when it gets {}, perhaps because it is too large or"
            + " not allowed: it is refused for {} s",
        session,
        culprit,
        TimeUnit.NANOSECONDS.toSeconds(length));
  }
}
