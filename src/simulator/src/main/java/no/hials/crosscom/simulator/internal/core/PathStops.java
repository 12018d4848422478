package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import org.jspecify.annotations.Nullable;

/**
 * Stops the robot on its path while conditions are true (STOP WHEN PATH). A condition is evaluated
 * when the robot can just stop at its place, and again there in each cycle (assumed).
 */
final class PathStops {
  /** Evaluates the condition of a stop. */
  interface Condition {
    boolean isTrue(MotionOrder.Stop stop) throws KrlExecutionException;
  }

  private record Waiting(long motion, MotionOrder.Stop order) {}

  private final Condition condition;
  private final List<Waiting> waiting = new ArrayList<>();

  /** The stop for which the robot brakes or at which it stands, else null. */
  private @Nullable Waiting planned;

  PathStops(Condition condition) {
    this.condition = condition;
  }

  void add(MotionCommand motion, List<MotionOrder.Stop> orders) {
    orders.forEach(order -> waiting.add(new Waiting(motion.id(), order)));
  }

  void clear() {
    waiting.clear();
    planned = null;
  }

  /** Discards all stops but those of some motions. */
  void retain(Set<Long> motions) {
    waiting.removeIf(stop -> !motions.contains(stop.motion));
    if (planned != null && !motions.contains(planned.motion)) {
      planned = null;
    }
  }

  /** Called before each cycle in which the robot may move. */
  void cycle(Interpolator motion) throws KrlExecutionException {
    if (planned != null) {
      if (!motion.atStop() || condition.isTrue(planned.order)) {
        return;
      }
      motion.passStop();
      planned = null;
    }
    Waiting next = next(motion);
    if (next == null || motion.canStopLater(next.motion, next.order.at())) {
      return;
    }
    waiting.remove(next);
    if (condition.isTrue(next.order) && motion.planStop(next.motion, next.order.at())) {
      planned = next;
    }
  }

  /** Returns the stop whose place comes first; null without one. */
  private @Nullable Waiting next(Interpolator motion) {
    Waiting next = null;
    double soonest = Double.POSITIVE_INFINITY;
    for (Waiting stop : List.copyOf(waiting)) {
      OptionalDouble left = motion.timeTo(stop.motion, stop.order.at());
      if (left.isPresent() && left.getAsDouble() <= 0) {
        waiting.remove(stop);
      } else if (left.isPresent() && left.getAsDouble() < soonest) {
        next = stop;
        soonest = left.getAsDouble();
      }
    }
    return next;
  }
}
