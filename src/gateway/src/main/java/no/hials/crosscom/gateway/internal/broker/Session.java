package no.hials.crosscom.gateway.internal.broker;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import no.hials.crosscom.gateway.Health;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A lasting connection to a broker, with a thread of its own. Messages that the broker has not
 * confirmed when the connection is lost, and those that arrive until it is back, go to a store on
 * disk. The number of messages in memory is bounded.
 */
public final class Session implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Session.class);

  /** The maximum number of updates that wait for the thread: a second of a large plant. */
  private static final int INBOX = 20_000;

  /** After this time without an answer that it owes, the broker is lost. */
  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(60);

  private static final int TASKS_AT_ONCE = 200;
  private static final long TICK = Duration.ofMillis(250).toNanos();
  private static final long PAUSE = Duration.ofMillis(50).toNanos();
  private static final long END = Duration.ofSeconds(2).toNanos();

  private final BrokerSettings settings;
  private final String name;
  private final Path folder;
  private final SessionFigures figures;
  private final Duration longestSilence;
  private final Inbox inbox = new Inbox(INBOX);
  private final Inbox answers = new Inbox(1000);
  private final Queue<Runnable> events = new ConcurrentLinkedQueue<>();
  private final Thread thread;
  private volatile boolean closing;

  /** The connection in use; written by the thread. */
  private volatile @Nullable Link link;

  // used only by the thread
  private final InFlight inFlight = new InFlight();
  private final Refusals refusals;
  private final Attempts attempts;
  private final Culprits culprits;
  private @Nullable MessageStore store;
  private @Nullable Traffic traffic;
  private boolean connected;
  private long lastAnswer; // or when the broker has begun to owe an answer
  private boolean forwarding;
  private boolean forwardsOutage; // and not only what had to wait for room
  private long droppedStored;
  private long now = System.nanoTime(); // the same during a task, so that room stays room
  private long nextTick = now;

  /**
   * Creates a session; {@link #start} connects it.
   *
   * @param name its name in logs and figures
   * @param folder the folder of its store
   */
  public Session(BrokerSettings settings, String name, Path folder, Health health) {
    this(settings, name, folder, health, LONGEST_SILENCE);
  }

  Session(
      BrokerSettings settings, String name, Path folder, Health health, Duration longestSilence) {
    this.longestSilence = longestSilence;
    this.settings = settings;
    this.name = name;
    this.folder = folder;
    this.figures = new SessionFigures(health, name);
    this.culprits = new Culprits(name);
    this.refusals = new Refusals(name, figures, culprits);
    this.attempts = new Attempts(name, settings.url());
    this.thread = new Thread(this::loop, "mqtt-" + name);
    thread.setDaemon(true);
  }

  /** Starts the thread, which connects. */
  public void start(Traffic what) {
    traffic = what;
    thread.start();
  }

  /**
   * Runs a task on the thread of the session, later and in order. Does not block. If too many
   * updates wait, the oldest are lost and counted.
   *
   * @param updates the number of updates in it; 0 for a task that must not be lost
   */
  public void submit(int updates, Runnable task) {
    figures.dropped("queue", inbox.add(updates, task));
    LockSupport.unpark(thread);
  }

  /**
   * Publishes the answer to a command, as soon as there is room for it. If too many wait, the
   * oldest are lost and counted.
   */
  public void submitAnswer(Publication message) {
    figures.dropped("queue", answers.add(1, () -> publishAnswer(message)));
    LockSupport.unpark(thread);
  }

  private void publishAnswer(Publication message) {
    if (hasRoom()) {
      publishNow(message, true);
    } else if (connected) {
      figures.dropped("queue", 1);
    }
  }

  /** Publishes a message at once; returns false if it is refused. Only while it is connected. */
  public boolean publishNow(Publication message, boolean isAnswer) {
    return send(message, Outgoing.atOnce(message, isAnswer, System.nanoTime()));
  }

  /** Runs a task on the thread of the session soon, whether there is room or not. */
  public void run(Runnable task) {
    events.add(task);
    LockSupport.unpark(thread);
  }

  /** Returns whether the broker is connected; call it only on the thread of the session. */
  public boolean isConnected() {
    return connected;
  }

  /**
   * Publishes a message; call it only on the thread of the session.
   *
   * @param spare returns what to store if the broker does not get the message; null to forget it
   * @return whether it was sent, and not only stored
   */
  public boolean publish(Publication message, @Nullable Supplier<StoredMessage> spare) {
    boolean free = connected && (spare == null || hasRoom());
    if (free && !culprits.mustWait(message.topic(), now)) {
      send(message, Outgoing.of(message, spare, System.nanoTime()));
      return true;
    }
    if (spare != null) {
      store(spare.get());
    }
    return false;
  }

  /** Returns whether a message can be sent now; call it only on the thread of the session. */
  public boolean hasRoom() {
    return connected && inFlight.hasRoom(now);
  }

  /** Returns whether a message of a topic can be sent now; call it only on the thread. */
  public boolean hasRoom(String topic) {
    return hasRoom() && !culprits.mustWait(topic, now);
  }

  /** Returns whether a topic waits or is refused, as it may end connections; only on the thread. */
  public boolean isHeldBack(String topic) {
    return culprits.mustWait(topic, now) || culprits.isBlocked(topic, now);
  }

  /** Stores a message, to be forwarded later; call it only on the thread of the session. */
  public void store(StoredMessage message) {
    store().add(message);
  }

  /** Returns whether stored messages are forwarded now; call it only on the thread. */
  public boolean isForwarding() {
    return forwarding;
  }

  /** Publishes a stored message; returns false if it is refused. For {@link Traffic#forward}. */
  public boolean publishStored(Publication message, StoredMessage stored) {
    String as = culprits.name(message.topic(), stored);
    return send(message, Outgoing.stored(message, stored, as, System.nanoTime()));
  }

  /** Counts stored messages or values that can no longer be published. */
  public void lost(String reason, int number) {
    figures.dropped(reason, number);
    droppedStored += number;
  }

  /** Removes a stored message that is not published. */
  public void skipStored(StoredMessage stored) {
    inFlight.add(Outgoing.skipped(stored));
    confirm();
  }

  private MessageStore store() {
    MessageStore opened = store;
    if (opened == null) {
      opened = new MessageStore(folder, settings.storeLimit(), figures);
      store = opened;
    }
    return opened;
  }

  /** Returns whether such a message is sent. If not, it is counted and logged as refused. */
  public boolean accepts(Publication message) {
    return refusals.accept(message, message.topic(), link, now);
  }

  private boolean send(Publication message, Outgoing one) {
    Link over = Objects.requireNonNull(link);
    if (!refusals.accept(message, one.name, link, now)) {
      if (one.stored != null) {
        skipStored(one.stored);
      }
      return false;
    }
    if (inFlight.isEmpty()) {
      lastAnswer = one.sentAt;
    }
    inFlight.limit(over.mostInFlight(message.qos()), culprits.pause(now));
    inFlight.add(one);
    culprits.sent(one.name);
    CompletableFuture<?> unused =
        over.publishConfirmed(message, inFlight.bytesPerQuestion())
            .whenComplete((result, failure) -> run(() -> sent(over, message, one, failure)));
    return true;
  }

  private void sent(Link over, Publication message, Outgoing one, @Nullable Throwable failure) {
    if (over != link) {
      return;
    }
    lastAnswer = System.nanoTime();
    Throwable cause = Link.cause(failure);
    if (cause == null) {
      figures.published.inc();
    } else if (Refusals.isRefusal(cause)) {
      refusals.add(message.topic(), cause);
    } else {
      lost(over, cause);
      return;
    }
    culprits.confirmed(one.name, lastAnswer);
    traffic().confirmed(message);
    inFlight.done(one, lastAnswer);
    confirm();
  }

  /** Removes the oldest finished messages, and confirms them to the store. */
  private void confirm() {
    for (Outgoing first = inFlight.pollDone(); first != null; first = inFlight.pollDone()) {
      if (first.stored != null) {
        store().confirm(first.stored);
      }
    }
  }

  private Traffic traffic() {
    return Objects.requireNonNull(traffic, "not started");
  }

  private void loop() {
    long endBy = 0;
    while (endBy == 0 || System.nanoTime() - endBy < 0) {
      boolean busy = false;
      try {
        busy = step();
      } catch (RuntimeException | Error e) {
        failed(e);
      }
      if (closing && endBy == 0 && !busy) {
        endBy = System.nanoTime() + END;
        traffic().closing();
      }
      if (endBy != 0 && (!connected || inFlight.isEmpty())) {
        break;
      }
      if (!busy) {
        LockSupport.parkNanos(culprits.isSearching(now) ? Culprits.SETTLING : PAUSE);
      }
    }
    end();
  }

  /** Called with a failure of the thread. After an error, as without memory, it connects again. */
  private void failed(Throwable why) {
    try {
      if (why instanceof Error) {
        lost(link, why);
      }
      LOG.error("MQTT {}: a message is lost", name, why);
      figures.dropped("error", 1);
    } catch (RuntimeException | Error e) {
      // perhaps there is no memory for the log either; the thread must go on
    }
  }

  /** Does some of the work, and returns whether there may be more. */
  private boolean step() {
    boolean busy = false;
    for (Runnable event = events.poll(); event != null; event = events.poll()) {
      event.run();
      busy = true;
    }
    now = System.nanoTime();
    boolean owesAnswer = link != null && !(connected && inFlight.isEmpty());
    if (owesAnswer && now - lastAnswer > longestSilence.toNanos()) {
      String silence = "the broker has not answered for " + longestSilence.toSeconds() + " s";
      lost(link, new TimeoutException(silence));
    }
    if (link == null && !closing && attempts.isDue(now)) {
      connect();
    }
    busy |= runTasks(answers); // before other messages take the room
    if (now - nextTick >= 0) {
      nextTick = now + TICK;
      traffic().tick();
    }
    busy |= runTasks(inbox);
    return forward() || busy;
  }

  /** Runs tasks that can publish or must store, and returns whether there were any. */
  private boolean runTasks(Inbox from) {
    for (int i = 0; i < TASKS_AT_ONCE; i++) {
      now = System.nanoTime();
      boolean hasRoom = from == answers ? inFlight.hasRoomForAnswer(now) : inFlight.hasRoom(now);
      boolean free = !connected || hasRoom || closing;
      Runnable task = free || (from == inbox && inbox.isLate()) ? from.poll() : null;
      if (task == null) {
        return i > 0;
      }
      task.run();
    }
    return true;
  }

  /** Sends stored messages. They get half of the places, so that new messages do not wait. */
  private boolean forward() {
    boolean busy = false;
    while (connected && !closing && forwarding && inFlight.hasRoomForStored(now)) {
      StoredMessage next = store().next();
      if (next == null) {
        break;
      }
      try {
        if (culprits.mustWait(next, now) || !traffic().forward(next)) {
          store().putBack();
          break;
        }
      } catch (IllegalArgumentException e) {
        LOG.warn("MQTT {}: a stored message cannot be published: {}", name, e.getMessage());
        lost("unknown", 1);
        skipStored(next);
      }
      busy = true;
    }
    if (connected && forwarding && store().isEmpty()) {
      forwarding = false;
      if (droppedStored == 0 && forwardsOutage) {
        LOG.info("MQTT {}: all stored messages are forwarded", name);
      } else if (droppedStored > 0) {
        LOG.warn(
            "MQTT {}: the stored messages are forwarded, but {} of them or of their"
                + " values are lost: the robot or value is no longer there, or has another type",
            name,
            droppedStored);
      }
      forwardsOutage = false;
      droppedStored = 0;
      traffic().forwarded();
    }
    forwarding |= connected && !store().isEmpty();
    return busy;
  }

  private void connect() {
    keep(); // what an error left behind
    Link[] self = new Link[1];
    try {
      Link next =
          Link.create(settings, traffic().will(), failure -> run(() -> lost(self[0], failure)));
      self[0] = next;
      link = next;
      lastAnswer = System.nanoTime();
      CompletableFuture<?> unused =
          next.connect()
              .thenCompose(
                  ack ->
                      next.subscribe(traffic().subscriptions(), () -> next == link, this::refused))
              .whenComplete((result, failure) -> run(() -> connected(next, Link.cause(failure))));
    } catch (IOException | RuntimeException e) {
      link = null;
      attempts.failed(String.valueOf(e.getMessage()));
    }
  }

  private void refused(String filter, Throwable failure) {
    if (!closing) {
      String reason = failure.getMessage();
      LOG.error("MQTT {}: the broker refuses to subscribe {}: {}", name, filter, reason);
    }
  }

  private void connected(Link over, @Nullable Throwable failure) {
    if (failure != null) {
      lost(over, failure);
      return;
    }
    if (over != link) {
      CompletableFuture<?> unused = over.disconnect().exceptionally(ended -> null);
      return;
    }
    connected = true;
    attempts.connected();
    culprits.connected(System.nanoTime());
    figures.connected.set(1);
    forwardsOutage = !store().isEmpty();
    String stored = forwardsOutage ? ", " + store().size() + " stored messages are forwarded" : "";
    LOG.info("MQTT {}: connected to {}{}", name, settings.url(), stored);
    refusals.clear();
    store().reachedBroker();
    traffic().connected();
  }

  private void lost(@Nullable Link over, Throwable failure) {
    if (over == null || over != link) {
      return;
    }
    String reason = Link.reason(failure);
    boolean was = connected;
    connected = false;
    link = null;
    figures.connected.set(0);
    // if only the gateway has given up the connection, the broker tells the others that it is over
    CompletableFuture<?> unused = over.disconnectWithWill().exceptionally(ended -> null);
    Set<String> unconfirmed = inFlight.names();
    keep();
    if (!was) {
      attempts.failed(reason);
      return;
    }
    LOG.warn("MQTT {}: {} is lost, messages are stored: {}", name, settings.url(), reason);
    attempts.lost(
        Link.isInvalidPacket(failure)
            || (Link.isEndedByBroker(failure) && culprits.ended(unconfirmed, System.nanoTime())));
  }

  /** Stores what the broker has not confirmed, and forwards the rest of the store later. */
  private void keep() {
    store().rewind();
    for (Outgoing one = inFlight.pollLost(); one != null; one = inFlight.pollLost()) {
      if (!one.done && one.spare != null) {
        store().add(one.spare.get());
      }
    }
    forwarding = false;
  }

  private void end() {
    answers.runAll();
    inbox.runAll();
    Link last = link;
    connected = false;
    keep();
    figures.connected.set(0);
    store().close();
    if (last != null) {
      link = null;
      last.disconnect().orTimeout(END, TimeUnit.NANOSECONDS).exceptionally(late -> null).join();
    }
  }

  /** Begins to close, without waiting, so that several sessions can end at the same time. */
  public void beginClose() {
    closing = true;
    LockSupport.unpark(thread);
  }

  /** Publishes or stores the submitted messages, and disconnects. */
  @Override
  public void close() {
    beginClose();
    try {
      thread.join(TimeUnit.NANOSECONDS.toMillis(3 * END));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
