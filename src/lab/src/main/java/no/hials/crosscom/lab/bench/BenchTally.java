package no.hials.crosscom.lab.bench;

import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClosedException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComProtocolException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.CrossComValueException;
import org.HdrHistogram.Histogram;

/** The times and failures of accesses. Not thread-safe. */
public final class BenchTally {
  private static final String REFUSED = "refused";
  private static final String WRONG_ANSWER = "wrong answer";

  /** The kind of each exception of the client. */
  static final Map<Class<?>, String> KINDS =
      Map.of(
          CrossComAccessException.class,
          REFUSED,
          CrossComRefusedException.class,
          REFUSED,
          CrossComUnsupportedException.class,
          "not supported",
          CrossComTimeoutException.class,
          "timed out",
          CrossComConnectionLostException.class,
          "connection lost",
          CrossComConnectException.class,
          "not connected",
          CrossComClosedException.class,
          "closed",
          CrossComValueException.class,
          WRONG_ANSWER,
          CrossComProtocolException.class,
          WRONG_ANSWER,
          CrossComTransferException.class,
          WRONG_ANSWER);

  /** With a resolution of 100 ns and three significant digits. */
  private final Histogram times = new Histogram(100, 1_000_000, 3);

  private final Map<String, Long> failures = new TreeMap<>();

  BenchTally() {
    times.setAutoResize(true);
  }

  void add(long nanos) {
    times.recordValue(nanos);
  }

  void addFailure(String kind) {
    failures.merge(kind, 1L, Long::sum);
  }

  void add(BenchTally other) {
    times.add(other.times);
    other.failures.forEach((kind, count) -> failures.merge(kind, count, Long::sum));
  }

  /** Returns the times, in ns. */
  public Histogram times() {
    return times;
  }

  /** Returns the number of failed accesses for each kind of failure. */
  public Map<String, Long> failures() {
    return failures;
  }

  public long failureCount() {
    return failures.values().stream().mapToLong(Long::longValue).sum();
  }

  /** Returns the kind of a failure in one to two words. */
  static String kind(CrossComException e) {
    return e instanceof CrossComValueException value && !value.isSent()
        ? "not sent"
        : Objects.requireNonNull(KINDS.get(e.getClass()));
  }

  /** Returns whether all failures are refusals by the controller. */
  public static boolean isRefused(Set<String> kinds) {
    return kinds.stream().allMatch(kind -> kind.equals(REFUSED));
  }

  /** Returns whether the connection can still be used after a failure. */
  static boolean keepsConnection(CrossComException e) {
    return e instanceof CrossComAccessException || e instanceof CrossComValueException;
  }
}
