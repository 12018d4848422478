package no.hials.crosscom.web.internal.socket;

import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import org.jspecify.annotations.Nullable;

/**
 * The messages that wait to be sent to a viewer. Answers stay in their order. Of the events with
 * one key only the newest waits, so that a slow viewer sees the newest state and needs no memory.
 * Thread-safe.
 */
final class Outbox {
  /** A page waits for answers before it sends more, so a longer queue is not normal. */
  private static final int MAX_ANSWERS = 256;

  private final Queue<String> answers = new ArrayDeque<>();
  private final Map<String, String> events = new LinkedHashMap<>();
  private boolean sending;

  /** Adds an answer; returns false if too many wait. */
  synchronized boolean addAnswer(String text) {
    return answers.size() < MAX_ANSWERS && answers.add(text);
  }

  /** Adds an event, which replaces a waiting event with the same key. */
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

  /** Called when a text has been sent. */
  synchronized void sent() {
    sending = false;
  }
}
