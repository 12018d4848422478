package no.hials.crosscom.lab.bench;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.CrossComValueException;
import org.HdrHistogram.Histogram;

/** The times and failures of accesses. Not thread-safe. */
public final class BenchTally {
  private static final String REFUSED = "refused";

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
    if (e instanceof CrossComAccessException) {
      return REFUSED;
    } else if (e instanceof CrossComTimeoutException) {
      return "timed out";
    } else if (e instanceof CrossComConnectionLostException) {
      return "connection lost";
    } else if (e instanceof CrossComConnectException) {
      return "not connected";
    } else if (e instanceof CrossComValueException) {
      return "not sent";
    }
    return "wrong answer";
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
