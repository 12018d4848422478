package no.hials.crosscom.internal.exchange;

import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.Iterator;
import java.util.NoSuchElementException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import org.jspecify.annotations.Nullable;

/**
 * Waits for the items of a publisher. It requests one at a time, so that the others stay in the
 * publisher's buffer.
 *
 * @param <T> the type of the items
 */
public final class SubscriberIterator<T> implements Iterator<T>, Flow.Subscriber<T> {
  /** An item; without one, the end. */
  private record Event<T>(@Nullable T item, @Nullable Throwable failure) {}

  private final BlockingQueue<Event<T>> events = new LinkedBlockingQueue<>();
  private Flow.@Nullable Subscription subscription;

  /** The next event, if it has been waited for. */
  private @Nullable Event<T> next;

  @Override
  public void onSubscribe(Flow.Subscription newSubscription) {
    subscription = newSubscription;
    newSubscription.request(1);
  }

  @Override
  public void onNext(T item) {
    events.add(new Event<>(item, null));
  }

  @Override
  public void onError(Throwable failure) {
    events.add(new Event<>(null, failure));
  }

  @Override
  public void onComplete() {
    events.add(new Event<>(null, null));
  }

  /**
   * Waits for the next item or the end.
   *
   * @throws UncheckedIOException if the thread is interrupted, whose flag stays set
   * @throws IllegalStateException if the publisher has failed
   */
  @Override
  public boolean hasNext() {
    Event<T> event = await();
    if (event.failure != null) {
      throw new IllegalStateException("the samples ended with a failure", event.failure);
    }
    return event.item != null;
  }

  private Event<T> await() {
    Event<T> event = next;
    if (event == null) {
      try {
        event = events.take();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new UncheckedIOException(
            new InterruptedIOException("the thread was interrupted while it waited for a sample"));
      }
      next = event;
    }
    return event;
  }

  @Override
  public T next() {
    if (!hasNext()) {
      throw new NoSuchElementException("the samples have ended");
    }
    T item = await().item;
    Flow.Subscription own = subscription;
    if (item == null || own == null) {
      throw new IllegalStateException("an item comes with a subscription");
    }
    next = null;
    own.request(1);
    return item;
  }
}
