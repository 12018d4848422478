package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.program.TriggerOrder;

/**
 * Finds the moments at which triggers fire. The place of a trigger is known to one cycle, and that
 * of a shift in time to lower values is estimated by the present speed.
 */
final class Triggers {
  private static final double MM_PER_M = 1000;

  /** A trigger that waits for its motion, for its place on it, or for its time. */
  private static final class Waiting {
    private final long motion;
    private final TriggerOrder order;
    private boolean begun;

    /** When it fires; negative if that is not known yet. */
    private long due = -1;

    /** How far the robot has to go behind the end of the motion, mm. */
    private double behind = -1;

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

  /** Forgets all but those of some motions. */
  void retain(Set<Long> motions) {
    waiting.removeIf(trigger -> !motions.contains(trigger.motion));
  }

  void started(MotionCommand motion, long now) {
    for (Waiting trigger : waiting) {
      if (trigger.motion == motion.id()) {
        trigger.begun = true;
        if (!trigger.order.onPath() && trigger.order.distance() == 0) {
          // before the start there is nothing to fire in: a negative delay is none (assumed)
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
        }
      }
    }
  }

  void passed(MotionCommand motion, long now) {
    for (Waiting trigger : waiting) {
      if (trigger.motion == motion.id() && trigger.due < 0) {
        if (trigger.order.onPath() && trigger.order.distance() > 0) {
          trigger.behind = trigger.order.distance();
        } else {
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
        }
      }
    }
  }

  /**
   * Fires what is due.
   *
   * @param now simulated ms
   * @param left mm to the end of the motion under way
   * @param velocity m/s
   * @param cycle s since the last call
   */
  void cycle(long now, long current, double left, double velocity, double cycle) {
    double mmPerMilli = velocity; // m/s are mm/ms
    for (Iterator<Waiting> it = waiting.iterator(); it.hasNext(); ) {
      Waiting trigger = it.next();
      if (trigger.behind >= 0) {
        trigger.behind -= velocity * MM_PER_M * cycle;
        if (trigger.behind <= 0) {
          trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
          trigger.behind = -1;
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

  /** Looks whether the robot has come to a place ahead of the end of its motion. */
  private static void approach(Waiting trigger, long now, double left, double mmPerMilli) {
    double ahead = trigger.order.onPath() ? -trigger.order.distance() : 0;
    double early = Math.max(0, -trigger.order.delayMillis()) * mmPerMilli;
    if (ahead + early > 0 && left <= ahead + early) {
      trigger.due = now + Math.max(0, Math.round(trigger.order.delayMillis()));
    }
  }
}
