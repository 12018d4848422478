package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.mock.RecordedRequest;
import org.jspecify.annotations.Nullable;

/** The last requests of a server. Safe for use by several threads. */
public final class RequestLog {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition added = lock.newCondition();
  private final @Nullable RecordedRequest[] ring;

  /** The number of the last request. */
  private long last;

  /** The number of the first request after the last {@link #clear}. */
  private long first = 1;

  /** The number of the next request to take. */
  private long next = 1;

  /** Creates a log that keeps this many requests. */
  public RequestLog(int capacity) {
    ring = new RecordedRequest[capacity];
  }

  /** Adds a request. Its number must be the next one. */
  void add(RecordedRequest request) {
    lock.lock();
    try {
      last = request.number();
      if (ring.length > 0) {
        ring[slot(last)] = request;
        added.signal();
      }
    } finally {
      lock.unlock();
    }
  }

  private int slot(long number) {
    return (int) (number % ring.length);
  }

  private long oldest() {
    return Math.max(first, last - ring.length + 1);
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
      for (long number = oldest(); number <= last; number++) {
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
      while (ring.length == 0 || Math.max(next, oldest()) > last) {
        if (left <= 0) {
          return Optional.empty();
        }
        left = added.awaitNanos(left);
      }
      next = Math.max(next, oldest());
      return Optional.ofNullable(ring[slot(next++)]);
    } finally {
      lock.unlock();
    }
  }

  /** Removes all requests. */
  public void clear() {
    lock.lock();
    try {
      first = last + 1;
      Arrays.fill(ring, null);
    } finally {
      lock.unlock();
    }
  }
}
