package no.hials.crosscom.lab.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.GarbageCollectionNotificationInfo;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.NotificationListener;
import javax.management.openmbean.CompositeData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class GarbageCollectionsTest {
  /** The notification of the collection that the test asks for. */
  private final CompletableFuture<Notification> asked = new CompletableFuture<>();

  private final NotificationListener listener =
      (notification, handback) -> {
        if (info(notification).getGcCause().equals("System.gc()")) {
          asked.complete(notification);
        }
      };

  private static GarbageCollectionNotificationInfo info(Notification notification) {
    return GarbageCollectionNotificationInfo.from((CompositeData) notification.getUserData());
  }

  @Test
  @Timeout(30)
  void notesAPauseAtTheTimeOfItsNotification() throws Exception {
    long begin = System.currentTimeMillis();
    try (GarbageCollections pauses = new GarbageCollections(() -> begin)) {
      pauses.begin();
      for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
        // notified after the listener of the pauses, which was there before
        ((NotificationEmitter) bean).addNotificationListener(listener, null, null);
      }
      System.gc();
      Notification notification = asked.get(30, TimeUnit.SECONDS);
      long length = info(notification).getGcInfo().getDuration();
      double start = (notification.getTimeStamp() - length - begin) / 1e3;

      assertThat(pauses.seen(0)).contains(new GarbageCollections.Pause(start, length / 1e3));
      assertThat(pauses.seen(10)).contains(new GarbageCollections.Pause(start + 10, length / 1e3));
    } finally {
      for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
        ((NotificationEmitter) bean).removeNotificationListener(listener);
      }
    }
  }
}
