package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The triggers, stops and settings that statements have set for the next motion. */
final class NextMotion {
  private final List<TriggerOrder> triggers = new ArrayList<>();
  private final List<MotionOrder.Stop> stops = new ArrayList<>();

  /** The spline motion or block that is being evaluated, else null. */
  private @Nullable SplineBuilder spline;

  /** The numbers of triggers and stops before its statement. */
  private int triggersBefore;

  private int stopsBefore;

  void clear() {
    triggers.clear();
    stops.clear();
    endSpline();
  }

  /** Removes what a statement has set that is executed again. */
  void forgetStatement() {
    if (spline != null) {
      triggers.subList(triggersBefore, triggers.size()).clear();
      stops.subList(stopsBefore, stops.size()).clear();
      endSpline();
    }
  }

  void add(TriggerOrder trigger) {
    triggers.add(trigger);
  }

  void add(MotionOrder.Stop stop) {
    stops.add(stop);
  }

  /** Removes and returns the triggers. */
  List<TriggerOrder> takeTriggers() {
    triggersBefore = 0;
    return taken(triggers);
  }

  /** Removes and returns the stops. */
  List<MotionOrder.Stop> takeStops() {
    stopsBefore = 0;
    return taken(stops);
  }

  private static <T> List<T> taken(List<T> all) {
    List<T> taken = List.copyOf(all);
    all.clear();
    return taken;
  }

  /** Begins to evaluate a spline motion or block. */
  void beginSpline(ProgramEnvironment environment) {
    endSpline();
    spline = new SplineBuilder(environment);
    triggersBefore = triggers.size();
    stopsBefore = stops.size();
  }

  SplineBuilder spline() {
    return Objects.requireNonNull(spline);
  }

  /** Ends the evaluation; the settings of the program hold again. */
  void endSpline() {
    if (spline != null) {
      spline.restore();
      spline = null;
    }
  }
}
