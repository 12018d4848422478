package no.hials.crosscom.gateway.internal.broker;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the topics on which a broker ends the connection, as many brokers do instead of refusing a
 * message that is too large or not allowed. After some connections that the broker has ended soon,
 * messages are sent one at a time until all that were on their way are confirmed. A topic that is
 * alone on its way twice when the connection ends is blocked for a time, which doubles each time.
 * Not thread-safe.
 */
final class Culprits {
  private static final Logger LOG = LoggerFactory.getLogger(Culprits.class);

  /** The number of connections, one after the other, that the broker ends soon. */
  private static final int ENDS = 3;

  private static final long SOON = TimeUnit.SECONDS.toNanos(10);
  private static final long FIRST_BLOCK = TimeUnit.SECONDS.toNanos(10);
  private static final long LONGEST_BLOCK = TimeUnit.MINUTES.toNanos(10);

  /** After this time, messages are no longer sent one at a time. */
  private static final long LONGEST_SEARCH = TimeUnit.MINUTES.toNanos(5);

  /** The time for which a topic is blocked. */
  private record Block(long until, long length) {}

  private final String session;
  private final Map<String, Block> blocks = new HashMap<>();

  /** The topics of the messages among which the culprit is. */
  private final Set<String> suspects = new HashSet<>();

  /** The topics that were alone on their way when a connection ended, and not confirmed since. */
  private final Set<String> alone = new HashSet<>();

  private int ends;
  private long connectedAt;
  private long searchSince;

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
  }

  /** Returns whether messages are sent one at a time. */
  boolean isSearching(long now) {
    if (now - searchSince > LONGEST_SEARCH) {
      suspects.clear();
    }
    return !suspects.isEmpty();
  }

  /** Returns whether nothing is published on a topic now. */
  boolean isBlocked(String topic, long now) {
    Block block = blocks.get(topic);
    return block != null && now - block.until < 0;
  }

  /** Called when the broker has a message. */
  void confirmed(String topic) {
    suspects.remove(topic);
    alone.remove(topic);
    blocks.remove(topic);
  }

  /**
   * Called when the broker has ended a connection.
   *
   * @param topics the topics of the messages that it has not confirmed
   * @return whether one of them is blocked now, so that the next connection will be better
   */
  boolean ended(Set<String> topics, long now) {
    List<String> culprits = topics.stream().filter(blocks::containsKey).toList();
    if (culprits.isEmpty() && isSearching(now) && topics.size() == 1) {
      boolean again = !alone.addAll(topics);
      if (again || !blocks.isEmpty()) {
        culprits = List.copyOf(topics);
      }
    } else if (culprits.isEmpty() && now - connectedAt < SOON && !topics.isEmpty()) {
      ends++;
      if (ends >= ENDS && suspects.isEmpty()) {
        suspects.addAll(topics);
        alone.clear();
        searchSince = now;
      }
    } else {
      ends = 0;
    }
    for (String culprit : culprits) {
      Block last = blocks.get(culprit);
      long length = last == null ? FIRST_BLOCK : Math.min(2 * last.length, LONGEST_BLOCK);
      blocks.put(culprit, new Block(now + length, length));
      suspects.remove(culprit);
      ends = ENDS - 1; // the next one is soon found, if there is another
      LOG.warn(
          "MQTT {}: the broker ends the connection when it gets {}, perhaps because it is too large"
              + " or not allowed: nothing is published there for {} s",
          session,
          culprit,
          TimeUnit.NANOSECONDS.toSeconds(length));
    }
    return !culprits.isEmpty();
  }
}
