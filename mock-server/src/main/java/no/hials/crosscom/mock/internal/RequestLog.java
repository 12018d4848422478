package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.variable.VariableRequest;
import org.jspecify.annotations.Nullable;

/** The last requests of a server, within a number and a size. Safe for use by several threads. */
public final class RequestLog {
  /** The bytes of a record without its request, of a text and of a number (estimates). */
  private static final int RECORD_COST = 256;

  private static final int TEXT_COST = 64;
  private static final int NUMBER_COST = 20;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition added = lock.newCondition();
  private final @Nullable RecordedRequest[] ring;
  private final int[] costs;
  private final long maxBytes;

  /** The bytes that the kept requests take. */
  private long bytes;

  /** The number of the last request. */
  private long last;

  /** The number of the oldest request that is kept. */
  private long oldest = 1;

  /** The number of the next request to take. */
  private long next = 1;

  private long discarded;

  /**
   * Creates a log.
   *
   * @param capacity the maximum number of requests to keep
   * @param maxBytes the maximum number of bytes that they take, about; the last request is kept in
   *     any case
   */
  public RequestLog(int capacity, long maxBytes) {
    ring = new RecordedRequest[capacity];
    costs = new int[capacity];
    this.maxBytes = maxBytes;
  }

  /**
   * Adds a request. Its number must be the next one.
   *
   * @param frameLength the bytes that the client sent
   */
  void add(RecordedRequest request, int frameLength) {
    lock.lock();
    try {
      last = request.number();
      if (ring.length == 0) {
        oldest = last + 1;
        discarded++;
        return;
      }
      int cost = cost(request, frameLength);
      bytes += cost;
      while (last - oldest >= ring.length || (bytes > maxBytes && oldest < last)) {
        discardOldest();
      }
      ring[slot(last)] = request;
      costs[slot(last)] = cost;
      added.signal();
    } finally {
      lock.unlock();
    }
  }

  private void discardOldest() {
    bytes -= costs[slot(oldest)];
    ring[slot(oldest)] = null;
    oldest++;
    discarded++;
  }

  /** Estimates the memory that a request takes. */
  private static int cost(RecordedRequest recorded, int frameLength) {
    // each name may have a value
    int cost = RECORD_COST + frameLength + 2 * TEXT_COST * recorded.names().size();
    return recorded.request() instanceof VariableRequest.WriteArrayRequest array
        ? cost + NUMBER_COST * array.elements().size()
        : cost;
  }

  private int slot(long number) {
    return (int) (number % ring.length);
  }

  /** Returns how many requests were discarded because others took their place. */
  public long discarded() {
    lock.lock();
    try {
      return discarded;
    } finally {
      lock.unlock();
    }
  }

  /** Returns the number of the last request. */
  public long count() {
    lock.lock();
    try {
      return last;
    } finally {
      lock.unlock();
    }
  }

  /** Returns a copy of the requests. */
  public List<RecordedRequest> all() {
    lock.lock();
    try {
      List<RecordedRequest> all = new ArrayList<>();
      for (long number = oldest; number <= last; number++) {
        RecordedRequest request = ring[slot(number)];
        if (request != null) {
          all.add(request);
        }
      }
      return List.copyOf(all);
    } finally {
      lock.unlock();
    }
  }

  /** Waits for the next request, at most this long. */
  public Optional<RecordedRequest> take(long nanos) throws InterruptedException {
    lock.lockInterruptibly();
    try {
      long left = nanos;
      while (ring.length == 0 || Math.max(next, oldest) > last) {
        if (left <= 0) {
          return Optional.empty();
        }
        left = added.awaitNanos(left);
      }
      next = Math.max(next, oldest);
      return Optional.ofNullable(ring[slot(next++)]);
    } finally {
      lock.unlock();
    }
  }

  /** Removes all requests. */
  public void clear() {
    lock.lock();
    try {
      oldest = last + 1;
      bytes = 0;
      Arrays.fill(ring, null);
    } finally {
      lock.unlock();
    }
  }
}
