package no.hials.crosscom.lab.experiment;

import com.sun.management.GarbageCollectionNotificationInfo;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import javax.management.ListenerNotFoundException;
import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.NotificationListener;
import javax.management.openmbean.CompositeData;

/** Records the garbage collection pauses of this process, to a millisecond. */
final class GarbageCollections implements AutoCloseable {
  /** ZGC reports whole collections under this name, during which the process keeps running. */
  private static final String NOT_PAUSES = "Cycles";

  private final LongSupplier clock;
  private final List<Pause> pauses = new ArrayList<>();
  private final List<NotificationEmitter> emitters = new ArrayList<>();
  private final NotificationListener listener = (notification, handback) -> note(notification);

  /** The time of the call of {@link #begin}, ms of the system clock. */
  private long begin = -1;

  /**
   * A pause.
   *
   * @param begin the time since the start of the loop, s
   * @param length the length, s
   */
  record Pause(double begin, double length) {}

  /** Records the pauses by the system clock. */
  GarbageCollections() {
    this(System::currentTimeMillis);
  }

  /**
   * @param clock returns the time of {@link #begin}, ms of the system clock
   */
  GarbageCollections(LongSupplier clock) {
    this.clock = clock;
    for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
      if (bean instanceof NotificationEmitter emitter && !bean.getName().endsWith(NOT_PAUSES)) {
        emitter.addNotificationListener(listener, null, null);
        emitters.add(emitter);
      }
    }
  }

  /** Called at the first cycle of the loop; later calls have no effect. */
  synchronized void begin() {
    if (begin < 0) {
      begin = clock.getAsLong();
    }
  }

  private synchronized void note(Notification notification) {
    if (begin < 0
        || !notification
            .getType()
            .equals(GarbageCollectionNotificationInfo.GARBAGE_COLLECTION_NOTIFICATION)) {
      return;
    }
    long length =
        GarbageCollectionNotificationInfo.from((CompositeData) notification.getUserData())
            .getGcInfo()
            .getDuration();
    // the time stamp is from the end of the pause; the start time in the data uses a clock whose
    // origin differs from that of all other clocks
    pauses.add(new Pause((notification.getTimeStamp() - length - begin) / 1e3, length / 1e3));
  }

  /**
   * Returns the pauses since {@link #begin}.
   *
   * @param past how long the loop had run at the call of {@link #begin}, s
   */
  synchronized List<Pause> seen(double past) {
    return pauses.stream().map(pause -> new Pause(pause.begin() + past, pause.length())).toList();
  }

  /** Returns the total length of the pauses in a period, in ms. */
  static double millisBetween(List<Pause> pauses, double from, double to) {
    double sum = 0;
    for (Pause pause : pauses) {
      double overlap = Math.min(to, pause.begin() + pause.length()) - Math.max(from, pause.begin());
      sum += Math.max(0, overlap) * 1e3;
    }
    return sum;
  }

  @Override
  public void close() {
    for (NotificationEmitter emitter : emitters) {
      try {
        emitter.removeNotificationListener(listener);
      } catch (ListenerNotFoundException e) {
        throw new IllegalStateException("the listener was added", e);
      }
    }
  }
}
