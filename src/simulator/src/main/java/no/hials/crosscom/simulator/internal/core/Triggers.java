package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.motion.PathPoint;
import no.hials.crosscom.simulator.internal.program.TriggerOrder;

/**
 * Fires triggers in the first cycle at whose end their time has come. The time of a place on the
 * path is that of the plan, at the present part of its speed.
 */
final class Triggers {
  private static final double MILLIS = 1000;

  /** The maximum that rounding adds to a time, ms. */
  private static final double ROUNDING = 1e-6;

  /** A trigger that waits for its motion, its place on the path, or its time. */
  private static final class Waiting {
    private final TriggerOrder order;
    private final long motion;

    /** The motion in which its place is: one that follows if the place is after the end. */
    private long placed;

    private PathPoint at;
    private boolean begun;

    /** When the robot is at the place, as known, ms. */
    private double there = Double.POSITIVE_INFINITY;

    /** Whether the robot has been there. */
    private boolean passed;

    Waiting(long motion, TriggerOrder order, PathPoint at) {
      this.motion = motion;
      this.order = order;
      this.at = at;
      placed = motion;
    }

    /** Returns whether the place is after the end of the motion. */
    boolean isBeyond() {
      return at.point() == PathPoint.LAST && at.mm() > 0;
    }
  }

  private final Consumer<TriggerOrder> fire;
  private final List<Waiting> waiting = new ArrayList<>();

  Triggers(Consumer<TriggerOrder> fire) {
    this.fire = fire;
  }

  /** Adds the triggers of the motion that was planned last. */
  void add(MotionCommand motion, List<TriggerOrder> orders, Interpolator plan) {
    for (TriggerOrder order : orders) {
      double beyond = plan.beyondEnd(order.at());
      PathPoint at = beyond > 0 ? new PathPoint(PathPoint.LAST, beyond) : order.at();
      waiting.add(new Waiting(motion.id(), order, at));
    }
  }

  void clear() {
    waiting.clear();
  }

  /** Discards all triggers but those of some motions. */
  void retain(Set<Long> motions) {
    waiting.removeIf(trigger -> !motions.contains(trigger.motion));
  }

  void started(MotionCommand motion) {
    for (Waiting trigger : waiting) {
      if (trigger.motion == motion.id()) {
        trigger.begun = true;
      } else if (trigger.placed < 0) {
        trigger.placed = motion.id();
      }
    }
  }

  /**
   * Called when a motion has ended, after a cycle.
   *
   * @param next the number of the motion that has begun instead; -1 if none has
   */
  void passed(MotionCommand motion, long now, long next) {
    for (Waiting trigger : waiting) {
      if (trigger.placed == motion.id() && !trigger.passed) {
        if (trigger.isBeyond()) {
          // it counts on from here, in the next motion
          trigger.at = new PathPoint(0, trigger.at.mm());
          trigger.placed = next;
        } else {
          trigger.there = Math.min(trigger.there, (double) now);
          trigger.passed = true;
        }
      }
    }
  }

  /**
   * Fires the triggers that are due.
   *
   * @param now simulated ms
   * @return whether any was due
   */
  boolean cycle(long now, Interpolator motion) {
    List<Waiting> due = new ArrayList<>();
    for (Waiting trigger : waiting) {
      if (!trigger.passed && trigger.begun && trigger.placed >= 0) {
        approach(trigger, now, motion);
      }
      // nothing fires before its motion starts (assumed)
      double time = trigger.there + trigger.order.delayMillis();
      if (trigger.begun && time <= now + ROUNDING) {
        due.add(trigger);
      }
    }
    waiting.removeAll(due);
    due.forEach(trigger -> fire.accept(trigger.order));
    return !due.isEmpty();
  }

  private static void approach(Waiting trigger, long now, Interpolator motion) {
    OptionalDouble left = motion.timeTo(trigger.placed, trigger.at);
    if (left.isEmpty()) {
      trigger.there = Double.POSITIVE_INFINITY;
      return;
    }
    double rate = motion.rate();
    trigger.passed = left.getAsDouble() <= 0;
    if (rate == 0) {
      trigger.there = trigger.passed ? now : Double.POSITIVE_INFINITY;
    } else {
      trigger.there = now + left.getAsDouble() / rate * MILLIS;
    }
  }
}
