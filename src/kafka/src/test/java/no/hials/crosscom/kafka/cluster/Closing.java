package no.hials.crosscom.kafka.cluster;

import org.jspecify.annotations.Nullable;

/** Closes all parts of a cluster, even if closing one of them fails. */
final class Closing {
  private Closing() {}

  static void all(@Nullable AutoCloseable... parts) throws Exception {
    Exception failure = null;
    for (AutoCloseable part : parts) {
      try {
        if (part != null) {
          part.close();
        }
      } catch (Exception e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
