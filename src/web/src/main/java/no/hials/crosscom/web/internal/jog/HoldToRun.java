package no.hials.crosscom.web.internal.jog;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.jspecify.annotations.Nullable;

/**
 * Decides whether a person allows motion now, from presses, beats and releases.
 *
 * <ul>
 *   <li>A press moves nothing. Its answer is a mark, the time here, and a beat that shows a mark of
 *       the last 150 ms proves that the network is fast in both directions. Such a beat allows
 *       motion for 150 ms.
 *   <li>A beat counts only for a hold that is not over, and only with a number larger than the
 *       numbers before it.
 *   <li>A hold is over after its release, after 150 ms without a beat that counts, and for each
 *       other reason. Beats do not continue it: a new press with a larger number is needed.
 *   <li>Each direction has one hold. A second press in it ends the first one and is refused.
 * </ul>
 *
 * <p>Thread-safe. It does not block, and has no thread: the loop asks in each cycle.
 */
final class HoldToRun {
  /** The time without a beat after which the robot stops. */
  static final Duration SILENCE = Duration.ofMillis(150);

  static final int DIRECTIONS = 6;

  private final LongSupplier nanoTime;
  private final long origin;
  private final BiConsumer<Press, String> ended;

  // guarded by this
  private final @Nullable Hold[] holds = new Hold[DIRECTIONS];
  private long lastId;
  private @Nullable String stopped;

  /** The last end in each direction. */
  private final @Nullable End[] ends = new End[DIRECTIONS];

  /** A hold that is not over. */
  private static final class Hold {
    final Press press;
    long lastNanos;
    long lastNumber;
    boolean beating;

    Hold(Press press, long nanos) {
      this.press = press;
      this.lastNanos = nanos;
    }
  }

  /** Why a hold is over. */
  private record End(long id, String reason) {}

  /**
   * The motion that is allowed.
   *
   * @param presses the buttons
   * @param nanoTime the time of the oldest of their last beats
   */
  record Allowed(List<Press> presses, long nanoTime) {}

  /**
   * Creates an object without holds.
   *
   * @param nanoTime the clock, as {@link System#nanoTime}
   * @param ended called with each hold that is over, and the reason; must not block
   */
  HoldToRun(LongSupplier nanoTime, BiConsumer<Press, String> ended) {
    this.nanoTime = nanoTime;
    this.ended = ended;
    origin = nanoTime.getAsLong();
  }

  /** Returns the time of the server in ms, which the next beat must contain. */
  private long mark(long now) {
    return (now - origin) / 1_000_000;
  }

  /**
   * Begins a hold.
   *
   * @return the mark for its first beat
   */
  synchronized long press(Press press) throws CommandException {
    long now = expire();
    if (stopped != null) {
      throw new CommandException(stopped);
    }
    if (press.id() <= lastId) {
      throw new CommandException("hold must be more than " + lastId + ", is " + press.id());
    }
    lastId = press.id();
    Hold other = holds[press.direction()];
    if (other != null) {
      end(other, "two buttons of one direction were held");
      throw new CommandException("the other button of this direction is held: release both");
    }
    holds[press.direction()] = new Hold(press, now);
    return mark(now);
  }

  /**
   * Continues a hold.
   *
   * @param number more than the numbers of the beats before it
   * @param mark the latest mark that the page received
   * @return the mark for the next beat
   * @throws CommandException if the hold is over
   */
  synchronized long beat(long id, long number, long mark) throws CommandException {
    long now = expire();
    Hold hold = find(id);
    if (hold == null) {
      throw new CommandException("the hold is over" + reasonOf(id));
    }
    long age = mark(now) - mark;
    if (number > hold.lastNumber) {
      hold.lastNumber = number;
      if (age >= 0 && age <= SILENCE.toMillis()) {
        hold.lastNanos = now;
        hold.beating = true;
      }
    }
    return mark(now);
  }

  /** Ends a hold. A hold that has not begun yet never begins. */
  synchronized void release(long id) {
    expire();
    Hold hold = find(id);
    if (hold != null) {
      end(hold, "released");
    }
    lastId = Math.max(lastId, id);
  }

  /** Ends a hold whose step is done. */
  synchronized void finish(long id) {
    Hold hold = find(id);
    if (hold != null) {
      end(hold, "the step is done");
    }
  }

  /** Ends all holds and refuses further ones. */
  synchronized void stop(String reason) {
    expire();
    stopped = stopped == null ? reason : stopped;
    for (Hold hold : holds) {
      if (hold != null) {
        end(hold, reason);
      }
    }
  }

  /** Returns the motion that is allowed now; null if the robot must stand. */
  synchronized @Nullable Allowed allowed() {
    long oldest = expire();
    List<Press> presses = new ArrayList<>();
    for (Hold hold : holds) {
      if (hold != null && hold.beating) {
        presses.add(hold.press);
        oldest = hold.lastNanos - oldest < 0 ? hold.lastNanos : oldest;
      }
    }
    return presses.isEmpty() ? null : new Allowed(List.copyOf(presses), oldest);
  }

  private @Nullable Hold find(long id) {
    for (Hold hold : holds) {
      if (hold != null && hold.press.id() == id) {
        return hold;
      }
    }
    return null;
  }

  private String reasonOf(long id) {
    for (End end : ends) {
      if (end != null && end.id() == id) {
        return ": " + end.reason();
      }
    }
    return "";
  }

  /** Ends the holds that are silent for too long; returns the time. */
  private long expire() {
    long now = nanoTime.getAsLong();
    for (Hold hold : holds) {
      if (hold != null && now - hold.lastNanos > SILENCE.toNanos()) {
        end(hold, "no beat for " + SILENCE.toMillis() + " ms");
      }
    }
    return now;
  }

  private void end(Hold hold, String reason) {
    holds[hold.press.direction()] = null;
    ends[hold.press.direction()] = new End(hold.press.id(), reason);
    ended.accept(hold.press, reason);
  }
}
