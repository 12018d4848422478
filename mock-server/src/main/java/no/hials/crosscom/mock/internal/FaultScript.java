package no.hials.crosscom.mock.internal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;

/** Chooses the fault of each request. Safe for use by several threads. */
public final class FaultScript {
  private static final Fault NONE = Fault.none();

  private final Deque<Fault> queue = new ArrayDeque<>();
  private final List<Function<? super RecordedRequest, Optional<Fault>>> rules =
      new CopyOnWriteArrayList<>();

  /** Adds faults to the queue. */
  public void enqueue(Fault... faults) {
    synchronized (queue) {
      queue.addAll(List.of(faults));
    }
  }

  /** Adds a rule, after the earlier ones. */
  public void add(Function<? super RecordedRequest, Optional<Fault>> rule) {
    rules.add(rule);
  }

  /** Removes all faults. */
  public void clear() {
    rules.clear();
    synchronized (queue) {
      queue.clear();
    }
  }

  /** Returns the first fault in the queue, otherwise the fault of the first rule that has one. */
  Fault next(RecordedRequest request) {
    synchronized (queue) {
      Fault fault = queue.poll();
      if (fault != null) {
        return fault;
      }
    }
    for (Function<? super RecordedRequest, Optional<Fault>> rule : rules) {
      Optional<Fault> fault = rule.apply(request);
      if (fault.isPresent()) {
        return fault.get();
      }
    }
    return NONE;
  }
}
