package no.hials.crosscom;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.protocol.MessageType;
import org.jspecify.annotations.Nullable;

/**
 * The right to use a connection: one thread or asynchronous operation has it at a time, in the
 * order of their requests. A thread can acquire it again while it has it.
 *
 * <p>Like a fair lock, but an operation can also wait without a thread, and may release in another
 * thread. If nobody else wants it, acquiring creates no objects.
 */
final class Turn {
  private enum State {
    WAITING,
    GRANTED,
    GIVEN_UP
  }

  /** Waits for the turn. */
  private static final class Waiter extends AtomicReference<State> {
    private static final long serialVersionUID = 1L;

    private final transient Runnable granted;

    Waiter(Runnable granted) {
      super(State.WAITING);
      this.granted = granted;
    }

    /** Returns whether the state was changed; otherwise the other side was faster. */
    boolean become(State state) {
      return compareAndSet(State.WAITING, state);
    }
  }

  private final AtomicBoolean taken = new AtomicBoolean();
  private final Queue<Waiter> waiters = new ConcurrentLinkedQueue<>();

  /** The thread that has the turn; null if an asynchronous operation has it, or nobody. */
  private @Nullable Thread owner;

  private int holds;

  /** How long the thread or operation that has the turn waited for it, in ns. */
  private long waited;

  /**
   * Waits until this thread has the turn.
   *
   * @param type the type of the request, for error messages
   * @param name the variable, or a phrase for the request, for error messages
   * @param timeoutNanos the longest wait, in ns; 0 for no limit
   * @throws CrossComTimeoutException if the wait was too long
   * @throws CrossComConnectionLostException if the thread was interrupted, whose flag stays set
   */
  void acquire(MessageType type, String name, long timeoutNanos) throws CrossComException {
    Thread me = Thread.currentThread();
    if (owner == me) { // only this thread sets it to itself
      holds++;
      return;
    }
    if (waiters.isEmpty() && taken.compareAndSet(false, true)) {
      waited = 0;
    } else {
      waited = await(me, type, name, timeoutNanos);
    }
    owner = me;
    holds = 1;
  }

  private long await(Thread me, MessageType type, String name, long timeoutNanos)
      throws CrossComException {
    long start = System.nanoTime();
    Waiter waiter = new Waiter(() -> LockSupport.unpark(me));
    waiters.add(waiter);
    grantIfFree();
    while (waiter.get() != State.GRANTED) {
      long left = timeoutNanos - (System.nanoTime() - start);
      boolean interrupted = me.isInterrupted();
      if ((interrupted || (timeoutNanos > 0 && left <= 0)) && waiter.become(State.GIVEN_UP)) {
        waiters.remove(waiter);
        String what = Connection.what(type, name);
        throw interrupted ? interrupted(what) : late(what, timeoutNanos);
      }
      if (timeoutNanos > 0) {
        LockSupport.parkNanos(this, left);
      } else {
        LockSupport.park(this);
      }
    }
    return System.nanoTime() - start;
  }

  /** Returns the failure of an access whose thread was interrupted before it began. */
  static CrossComException interrupted(String what) {
    return new CrossComConnectionLostException(
        "the thread was interrupted before the " + what + "; nothing was sent", null, false);
  }

  /** Returns the failure of an access that waited for its turn until its time-out. */
  static CrossComException late(String what, long timeoutNanos) {
    return new CrossComTimeoutException(
        "the "
            + what
            + " waited "
            + timeoutNanos / 1_000_000
            + " ms for other accesses to end; nothing was sent",
        null,
        false);
  }

  /**
   * Calls an operation when it has the turn, in this thread or in the one that releases it. The
   * operation releases it later, by {@link #releaseAsync}.
   */
  void acquireAsync(Runnable operation) {
    long start = System.nanoTime();
    waiters.add(
        new Waiter(
            () -> {
              waited = System.nanoTime() - start;
              operation.run();
            }));
    grantIfFree();
  }

  /** Returns how long the thread that has the turn waited for it, in ns. */
  long waited() {
    return waited;
  }

  /** Releases the turn of this thread. */
  void release() {
    if (--holds == 0) {
      owner = null;
      pass();
    }
  }

  /** Releases the turn of an asynchronous operation. */
  void releaseAsync() {
    pass();
  }

  private void pass() {
    if (!grantNext()) {
      taken.set(false);
      grantIfFree(); // someone may have begun to wait meanwhile
    }
  }

  private void grantIfFree() {
    while (!waiters.isEmpty() && taken.compareAndSet(false, true)) {
      if (grantNext()) {
        return;
      }
      taken.set(false);
    }
  }

  private boolean grantNext() {
    Waiter next = waiters.poll();
    while (next != null) {
      if (next.become(State.GRANTED)) {
        next.granted.run();
        return true;
      }
      next = waiters.poll();
    }
    return false;
  }
}
