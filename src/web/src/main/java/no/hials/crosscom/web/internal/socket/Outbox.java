package no.hials.crosscom.web.internal.socket;

import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import org.jspecify.annotations.Nullable;

/**
 * The messages that wait to be sent to a viewer. Answers stay in their order; of events of one kind
 * only the newest waits, so that a slow viewer sees the newest state and costs no memory.
 * Thread-safe.
 */
final class Outbox {
  /** The page waits for answers before it asks for more; a queue this long has another cause. */
  private static final int MAX_ANSWERS = 256;

  private final Queue<String> answers = new ArrayDeque<>();
  private final Map<String, String> events = new LinkedHashMap<>();
  private boolean sending;

  /** Adds an answer; returns false if too many wait. */
  synchronized boolean addAnswer(String text) {
    return answers.size() < MAX_ANSWERS && answers.add(text);
  }

  /** Adds an event, which replaces the one of the same key that still waits. */
  synchronized void putEvent(String key, String text) {
    events.put(key, text);
  }

  /** Returns the next text to send; null while another is being sent or none waits. */
  synchronized @Nullable String next() {
    if (sending) {
      return null;
    }
    String text = answers.poll();
    if (text == null) {
      Iterator<String> oldest = events.values().iterator();
      if (!oldest.hasNext()) {
        return null;
      }
      text = oldest.next();
      oldest.remove();
    }
    sending = true;
    return text;
  }

  /** Notes that a text is sent. */
  synchronized void sent() {
    sending = false;
  }
}
