package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.BrowserSession;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The open socket of one page. Thread-safe. */
public final class Viewer implements Session.Listener.AutoDemanding {
  private static final Logger LOG = LoggerFactory.getLogger(Viewer.class);
  private static final int MESSAGES_PER_SECOND = 200;
  private static final int MESSAGES_IN_A_BURST = 400;
  private static final int MAX_WAITING_COMMANDS = 64;

  /** More than a person at a page stops at a time, each in a thread. */
  private static final int MAX_OVERTAKING = 16;

  private static final int POLICY_VIOLATION = 1008;

  private static final AtomicLong COUNT = new AtomicLong();

  private final long id = COUNT.incrementAndGet();
  private final BrowserSession browser;
  private final Commands commands;
  private final Executor workers;
  private final Sockets sockets;
  private final RateLimit rate = new RateLimit(MESSAGES_PER_SECOND, MESSAGES_IN_A_BURST);
  private final Outbox outbox = new Outbox();
  private final List<Runnable> atClose = new CopyOnWriteArrayList<>();
  private final Semaphore overtaking = new Semaphore(MAX_OVERTAKING);
  private volatile @Nullable Session session;
  private volatile boolean closed;
  private volatile long withdrawnAt = Long.MIN_VALUE;

  // guarded by this
  private final Queue<JsonNode> waiting = new ArrayDeque<>();
  private boolean working;

  Viewer(BrowserSession browser, Commands commands, Executor workers, Sockets sockets) {
    this.browser = browser;
    this.commands = commands;
    this.workers = workers;
    this.sockets = sockets;
  }

  /** Returns a unique number of the page. */
  public long id() {
    return id;
  }

  /** Returns the name of its browser, for people. */
  public String name() {
    return browser.name();
  }

  /** Returns its browser. */
  public BrowserSession browser() {
    return browser;
  }

  /** Returns the rights of its browser. */
  public Role role() {
    return browser.role();
  }

  /** Returns whether the socket is closed. */
  public boolean isClosed() {
    return closed;
  }

  /** Marks the changes that the page has sent until now as cancelled by it. */
  public void withdraw() {
    withdrawnAt = Call.now();
  }

  /** Returns the time of the last {@link #withdraw}, by {@link Call#now}. */
  long withdrawnAt() {
    return withdrawnAt;
  }

  /** Runs a task when the socket is closed; at once if it is closed already. */
  public void atClose(Runnable task) {
    atClose.add(task);
    if (closed && atClose.remove(task)) {
      task.run();
    }
  }

  /**
   * Sends an event. An event with the same key that still waits is dropped.
   *
   * @param key the kind of the event and its subject, such as {@code header/mock}
   */
  public void send(String key, ObjectNode event) {
    sendText(key, event.toString());
  }

  /** Sends an event that is already text, as {@link #send}. */
  public void sendText(String key, String event) {
    outbox.putEvent(key, event);
    flush();
  }

  private void reply(ObjectNode answer) {
    if (outbox.addAnswer(answer.toString())) {
      flush();
    } else {
      end("answers are not read");
    }
  }

  private void flush() {
    Session open = session;
    if (open == null || closed) {
      return;
    }
    String text = outbox.next();
    if (text != null) {
      open.sendText(text, Callback.from(this::sent, failure -> open.disconnect()));
    }
  }

  private void sent() {
    outbox.sent();
    flush();
  }

  /** Closes the connection at once, without waiting for the page. */
  void end(String reason) {
    leave();
    Session open = session;
    if (open != null) {
      open.close(
          POLICY_VIOLATION, reason, Callback.from(open::disconnect, failure -> open.disconnect()));
    }
  }

  /**
   * Marks the viewer as closed and runs its closing tasks, whatever one of them throws; a second
   * call does nothing.
   */
  private void leave() {
    closed = true;
    sockets.remove(this);
    for (Runnable task : List.copyOf(atClose)) {
      // unless atClose has run it
      if (atClose.remove(task)) {
        try {
          task.run();
        } catch (RuntimeException e) { // the others free robots and stop readings
          LOG.warn("a task at the end of a page of {} failed", name(), e);
        }
      }
    }
  }

  @Override
  public void onWebSocketOpen(Session opened) {
    session = opened;
    String refusal = sockets.add(this);
    if (!refusal.isEmpty()) {
      end(refusal);
      return;
    }
    if (!browser.isIn()) { // it may have been sent away since the request was checked
      end("sent away");
      return;
    }
    flush();
  }

  @Override
  public void onWebSocketText(String text) {
    if (closed) {
      return;
    }
    if (!browser.isIn()) {
      end("sent away");
      return;
    }
    if (!rate.take()) {
      end("too many messages");
      return;
    }
    JsonNode message;
    try {
      message = Json.parse(text);
    } catch (JsonProcessingException e) {
      reply(error(null, "the message is not JSON"));
      return;
    }
    switch (message.isObject() ? commands.urgency(message) : Commands.Urgency.QUICK) {
      case IN_ORDER -> enqueue(message);
      case OVERTAKING -> overtake(message);
      case QUICK -> reply(commands.answer(this, message));
    }
  }

  private static ObjectNode error(@Nullable JsonNode id, String reason) {
    ObjectNode answer = Json.object();
    answer.set("id", id == null ? Json.NULL : id);
    return answer.put("error", reason);
  }

  /** Binary messages are not part of the protocol. */
  @Override
  public void onWebSocketBinary(ByteBuffer payload, Callback callback) {
    callback.succeed();
    end("only text is understood");
  }

  private void enqueue(JsonNode message) {
    synchronized (this) {
      if (waiting.size() < MAX_WAITING_COMMANDS) {
        waiting.add(message);
        if (!working) {
          working = true;
          workers.execute(this::work);
        }
        return;
      }
    }
    reply(error(message.get("id"), "too many commands wait"));
  }

  /** Runs a command now, while others wait. */
  private void overtake(JsonNode message) {
    if (overtaking.tryAcquire()) {
      workers.execute(
          () -> {
            try {
              reply(commands.answer(this, message));
            } finally {
              overtaking.release();
            }
          });
    } else {
      reply(error(message.get("id"), "too many commands wait"));
    }
  }

  /** Runs the waiting commands, one after the other. */
  private void work() {
    while (true) {
      JsonNode next;
      synchronized (this) {
        next = closed ? null : waiting.poll();
        if (next == null) {
          working = false;
          return;
        }
      }
      reply(commands.answer(this, next));
    }
  }

  /** Does nothing: a close follows, and a browser that is gone needs no action. */
  @Override
  public void onWebSocketError(Throwable cause) {
    LOG.debug("the socket of {} failed", name(), cause);
  }

  @Override
  public void onWebSocketClose(int code, @Nullable String reason, Callback callback) {
    callback.succeed();
    leave();
  }
}
