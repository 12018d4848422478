package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.lang.Statement.TimeBlockPart;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.motion.PathPoint;

/** Collects the values of a spline motion or block while its statement is being evaluated. */
final class SplineBuilder {
  private final ProgramEnvironment environment;
  private final Map<String, KrlValue> outside;
  private Map<String, KrlValue> block;
  private final List<MotionOrder> segments = new ArrayList<>();
  private final List<BlockOrder.TimeLine> times = new ArrayList<>();
  private final List<BlockOrder.ConstantVelocityLine> constants = new ArrayList<>();

  SplineBuilder(ProgramEnvironment environment) {
    this.environment = environment;
    outside = environment.settings();
    block = outside;
  }

  /** Ends the WITH of the block: it holds for the segments. */
  void beginSegments() {
    block = environment.settings();
  }

  /** Returns the settings of the motion. */
  Map<String, KrlValue> settings() {
    return environment.settings();
  }

  void add(MotionOrder segment) {
    segments.add(segment);
    environment.restore(block);
  }

  void add(TimeBlockPart part, double value) {
    times.add(new BlockOrder.TimeLine(segments.size(), part, value));
  }

  void addConstantVelocity(boolean end, PathPoint at) {
    constants.add(new BlockOrder.ConstantVelocityLine(end, at));
  }

  /** Returns a place that counts from the next point, or from the last one. */
  PathPoint at(boolean onStart, double mm) {
    return new PathPoint(segments.size() + (onStart ? 0 : 1), mm);
  }

  List<MotionOrder> segments() {
    return segments;
  }

  BlockOrder block(boolean pointToPoint) {
    return new BlockOrder(
        pointToPoint, List.copyOf(segments), List.copyOf(times), List.copyOf(constants));
  }

  /** Sets the variables to their values before the statement. */
  void restore() {
    environment.restore(outside);
  }
}
