package no.hials.crosscom.web.internal.robot;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.Sample.ReadingStatus;
import no.hials.crosscom.Watch;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads what all viewers of a robot watch, each variable once and at the shortest period that a
 * viewer asks for. Several fields of one structure are read as the whole structure. Thread-safe.
 */
public final class Hub implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Hub.class);

  /** The periods of readings in ms. Other periods are shortened to one of these. */
  private static final List<Integer> PERIODS =
      List.of(10, 20, 50, 100, 200, 250, 500, 1000, 2000, 5000, 10_000);

  private final CrossComClient client;

  // guarded by this
  private final Set<Subscription> subscriptions = new HashSet<>();
  private final Map<Integer, Poll> polls = new TreeMap<>();

  /** Structures that the controller does not read as a whole. */
  private final Set<String> indivisible = new HashSet<>();

  private boolean closed;

  Hub(CrossComClient client) {
    this.client = client;
  }

  /**
   * Reads variables from now on.
   *
   * @param names the variables, in any case
   * @param period the time from one reading to the next
   * @param listener called with the readings; variables with different periods arrive separately
   * @throws IllegalArgumentException if a name cannot be that of a variable; the readings of others
   *     continue
   */
  public Subscription subscribe(List<String> names, Duration period, Consumer<Readings> listener) {
    Subscription added = new Subscription(names, period, listener);
    synchronized (this) {
      subscriptions.add(added);
      try {
        regroup();
      } catch (IllegalArgumentException e) {
        subscriptions.remove(added);
        throw e;
      }
    }
    return added;
  }

  /**
   * Checks a name as {@link #subscribe} does.
   *
   * @throws IllegalArgumentException if it cannot be that of a variable
   */
  public static void checkName(String name) {
    WatchConfig unused = WatchConfig.create(List.of(key(name)), cfg -> {});
  }

  /** The variables of one viewer. */
  public final class Subscription implements AutoCloseable {
    private final Set<String> names = new TreeSet<>();
    private final int period;
    private final Consumer<Readings> listener;

    /** When each poll was last passed on, by {@link System#nanoTime}; guarded by the hub. */
    private final Map<Integer, Long> before = new HashMap<>();

    private boolean paused; // guarded by the hub

    Subscription(List<String> names, Duration period, Consumer<Readings> listener) {
      names.forEach(name -> this.names.add(key(name)));
      this.period = classOf(period);
      this.listener = listener;
    }

    /** Stops or resumes this share of the readings. */
    public void pause(boolean value) {
      synchronized (Hub.this) {
        paused = value;
        regroup();
      }
    }

    @Override
    public void close() {
      synchronized (Hub.this) {
        subscriptions.remove(this);
        regroup();
      }
    }

    /** Returns whether a sample of a poll is due, and if so records that it is passed on. */
    private boolean takes(Poll poll) {
      if (paused) {
        return false;
      }
      long now = System.nanoTime();
      Long last = before.get(poll.period);
      // the readings are one period of the poll apart, so the nearest may be half a period early
      boolean due = last == null || now - last >= (period - poll.period / 2.0) * 1e6;
      if (due) {
        before.put(poll.period, now);
      }
      return due;
    }
  }

  /** Returns a name as the hub uses it, since KRL ignores case. */
  public static String key(String name) {
    return name.strip().toUpperCase(Locale.ROOT);
  }

  private static int classOf(Duration period) {
    return PERIODS.stream().filter(it -> it <= period.toMillis()).reduce(PERIODS.get(0), Math::max);
  }

  /**
   * Starts and ends polls, so that they read what the subscriptions need.
   *
   * @throws IllegalArgumentException if a name cannot be that of a variable; no poll has changed
   */
  private void regroup() {
    Map<Integer, SortedSet<String>> wanted = closed ? Map.of() : wanted();
    Map<Integer, Poll> missing = new TreeMap<>();
    wanted.forEach(
        (period, names) -> {
          Poll poll = polls.get(period);
          if (poll == null || !poll.isFor(names)) {
            missing.put(period, new Poll(period, names));
          }
        });
    for (Poll poll : List.copyOf(polls.values())) {
      if (!poll.isFor(wanted.get(poll.period))) {
        polls.remove(poll.period);
        poll.end();
      }
    }
    missing.forEach(
        (period, poll) -> {
          polls.put(period, poll);
          poll.begin();
        });
  }

  /** Returns the variables to read, by the period. */
  private Map<Integer, SortedSet<String>> wanted() {
    Map<String, Integer> periods = new TreeMap<>();
    for (Subscription one : subscriptions) {
      if (!one.paused) {
        one.names.forEach(name -> periods.merge(name, one.period, Math::min));
      }
    }
    Map<String, Integer> fields = new HashMap<>();
    periods
        .keySet()
        .forEach(name -> structure(name).ifPresent(it -> fields.merge(it, 1, Integer::sum)));
    Map<String, Integer> reads = new TreeMap<>();
    periods.forEach(
        (name, period) -> {
          String read =
              structure(name)
                  .filter(it -> fields.getOrDefault(it, 0) > 1 || periods.containsKey(it))
                  .orElse(name);
          reads.merge(read, period, Math::min);
        });
    Map<Integer, SortedSet<String>> result = new TreeMap<>();
    reads.forEach(
        (name, period) -> result.computeIfAbsent(period, it -> new TreeSet<>()).add(name));
    return result;
  }

  /** Returns the structure of a field, if it can be read as a whole. */
  private Optional<String> structure(String name) {
    int dot = name.indexOf('.');
    return dot <= 0 || name.indexOf('[', dot) >= 0
        ? Optional.empty()
        : Optional.of(name.substring(0, dot)).filter(it -> !indivisible.contains(it));
  }

  /** The variables that are read at one period. */
  private final class Poll {
    private final int period;
    private final SortedSet<String> names;
    private final WatchConfig config;
    private volatile boolean ended;
    private @Nullable Watch watch;

    Poll(int period, SortedSet<String> names) {
      this.period = period;
      this.names = names;
      this.config =
          WatchConfig.create(
              List.copyOf(names),
              cfg -> cfg.period(Duration.ofMillis(period)).missedSamples(true).bufferSize(4));
    }

    /** Starts the readings. */
    void begin() {
      try {
        watch = client.watch(config, this::sampled);
      } catch (IOException e) {
        LOG.debug("the client is closed", e);
      }
    }

    boolean isFor(@Nullable SortedSet<String> others) {
      return names.equals(others);
    }

    /** Ends the readings. */
    void end() {
      ended = true;
      if (watch != null) {
        watch.close();
      }
    }

    private void sampled(Sample sample) {
      List<Subscription> due = new ArrayList<>();
      synchronized (Hub.this) {
        if (ended || forgetIndivisible(sample)) {
          return;
        }
        for (Subscription one : subscriptions) {
          if (isAbout(one) && one.takes(this)) {
            due.add(one);
          }
        }
      }
      Map<Set<String>, Readings> shared = new HashMap<>();
      for (Subscription one : due) {
        Readings readings = shared.computeIfAbsent(one.names, it -> readings(it, sample));
        if (!readings.values().isEmpty()) {
          one.listener.accept(readings);
        }
      }
    }

    private boolean isAbout(Subscription one) {
      return one.names.stream().anyMatch(name -> names.contains(name) || isFieldOfOurs(name));
    }

    private boolean isFieldOfOurs(String name) {
      int dot = name.indexOf('.');
      return dot >= 0 && names.contains(name.substring(0, dot));
    }

    /**
     * Makes the hub read the fields one by one if the controller refuses their structure and nobody
     * asked for the whole. Returns whether there was such a structure.
     */
    private boolean forgetIndivisible(Sample sample) {
      boolean found = false;
      for (String name : names) {
        Reading reading = sample.readings().get(name);
        boolean refused =
            reading != null
                && (reading.failure() instanceof CrossComAccessException
                    || reading.failure() instanceof CrossComValueException);
        if (refused && subscriptions.stream().noneMatch(it -> it.names.contains(name))) {
          found |= indivisible.add(name);
        }
      }
      if (found) {
        regroup();
      }
      return found;
    }

    private Readings readings(Set<String> wanted, Sample sample) {
      Map<String, ReadOutcome> values = new LinkedHashMap<>();
      for (String name : wanted) {
        int dot = name.indexOf('.');
        if (names.contains(name)) {
          values.put(name, outcome(sample, name));
        } else if (isFieldOfOurs(name)) {
          values.put(name, field(outcome(sample, name.substring(0, dot)), name.substring(dot + 1)));
        }
      }
      return new Readings(sample.time(), sample.duration(), values);
    }
  }

  private static ReadOutcome outcome(Sample sample, String name) {
    Reading reading = Objects.requireNonNull(sample.readings().get(name), name);
    CrossComException failure = reading.failure();
    return new ReadOutcome(
        reading.value(),
        failure == null ? "" : String.valueOf(failure.getMessage()),
        reading.status() == ReadingStatus.MISSED);
  }

  /** Returns the result of a field from that of its structure. */
  private static ReadOutcome field(ReadOutcome structure, String path) {
    if (structure.value() == null) {
      return structure;
    }
    KrlValue value = structure.value();
    for (String step : path.split("\\.", -1)) {
      value = value instanceof KrlStruct struct ? struct.get(step).orElse(null) : null;
    }
    return value == null
        ? new ReadOutcome(null, "the controller has no value of it", false)
        : new ReadOutcome(value, "", false);
  }

  @Override
  public synchronized void close() {
    closed = true;
    regroup();
  }
}
