package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.program.TriggerOrder;

/**
 * Fires triggers. A position on the path is exact to one cycle; the time of a negative delay is
 * estimated from the current speed.
 */
final class Triggers {
  private static final double MM_PER_M = 1000;

  /** A trigger that waits for its motion, its position on the path, or its time. */
  private static final class Waiting {
    private final long motion;
    private final TriggerOrder order;
    private boolean begun;

    /** The time at which it fires; negative if not yet known. */
    private long due = -1;

    /** The distance that the robot still has to go after the end of the motion, mm. */
    private double beyondEnd = -1;

    Waiting(long motion, TriggerOrder order) {
      this.motion = motion;
      this.order = order;
    }
  }

  private final Consumer<TriggerOrder> fire;
  private final List<Waiting> waiting = new ArrayList<>();

  Triggers(Consumer<TriggerOrder> fire) {
    this.fire = fire;
  }

  void add(MotionCommand motion, List<TriggerOrder> orders) {
    for (TriggerOrder order : orders) {
      waiting.add(new Waiting(motion.id(), order));
    }
  }

  void clear() {
    waiting.clear();
  }

  /** Discards all triggers but those of some motions. */
  void retain(Set<Long> motions) {
    waiting.removeIf(trigger -> !motions.contains(trigger.motion));
  }

  void started(MotionCommand motion, long now) {
    for (Waiting trigger : waiting) {
      if (trigger.motion == motion.id()) {
        trigger.begun = true;
        if (!trigger.order.onPath() && trigger.order.distance() == 0) {
          // nothing fires before the start: a negative delay counts as none (assumed)
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
        }
      }
    }
  }

  void passed(MotionCommand motion, long now) {
    for (Waiting trigger : waiting) {
      if (trigger.motion == motion.id() && trigger.due < 0) {
        if (trigger.order.onPath() && trigger.order.distance() > 0) {
          trigger.beyondEnd = trigger.order.distance();
        } else {
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
        }
      }
    }
  }

  /**
   * Fires the triggers that are due.
   *
   * @param now simulated ms
   * @param left mm to the end of the current motion
   * @param velocity m/s
   * @param cycle s since the last call
   */
  void cycle(long now, long current, double left, double velocity, double cycle) {
    double mmPerMilli = velocity; // m/s are mm/ms
    for (Iterator<Waiting> it = waiting.iterator(); it.hasNext(); ) {
      Waiting trigger = it.next();
      if (trigger.beyondEnd >= 0) {
        trigger.beyondEnd -= velocity * MM_PER_M * cycle;
        if (trigger.beyondEnd <= 0) {
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
          trigger.beyondEnd = -1;
        }
      } else if (trigger.due < 0 && trigger.begun && trigger.motion == current) {
        approach(trigger, now, left, mmPerMilli);
      }
      if (trigger.due >= 0 && trigger.due <= now) {
        it.remove();
        fire.accept(trigger.order);
      }
    }
  }

  /** Sets the time of a trigger before the end of its motion once the robot is close enough. */
  private static void approach(Waiting trigger, long now, double left, double mmPerMilli) {
    double ahead = trigger.order.onPath() ? -trigger.order.distance() : 0;
    double early = Math.max(0, -trigger.order.delayMillis()) * mmPerMilli;
    if (ahead + early > 0 && left <= ahead + early) {
      trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
    }
  }
}
