package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.lang.Statement.TimeBlockPart;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.ExternalTarget;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSegment;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.ConstantSpeed;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Sections;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Spline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Timed;
import no.hials.crosscom.simulator.internal.motion.MotionProblem;
import no.hials.crosscom.simulator.internal.motion.PathPoint;
import no.hials.crosscom.simulator.internal.motion.SplineSegment;
import no.hials.crosscom.simulator.internal.motion.SplineSegment.Shape;
import no.hials.crosscom.simulator.internal.program.BlockOrder;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import org.jspecify.annotations.Nullable;

/** Resolves spline blocks, as {@link MotionResolver} does single motions. */
final class BlockResolver {
  private final MotionSettings settings;
  private final MotionResolver motions;

  BlockResolver(SystemVariableAccess access, MotionResolver motions) {
    this.settings = new MotionSettings(access);
    this.motions = motions;
  }

  /**
   * Resolves a block. The settings of the block are those of the controller meanwhile.
   *
   * @param start where it starts
   */
  MotionCommand plan(long id, MotionOrder order, BlockOrder block, Joints start)
      throws KrlExecutionException {
    Sections sections = new Sections(times(block), constants(block));
    if (!block.pointToPoint()) {
      return new Spline(
          id,
          segments(block, start),
          sections,
          motions.tool(),
          motions.pathApproximation(order.approximations()));
    }
    List<AxisSegment> segments = new ArrayList<>();
    Joints at = start;
    for (MotionOrder segment : block.segments()) {
      Joints from = at;
      AxisSegment resolved =
          settings.with(
              segment.settings(),
              () ->
                  new AxisSegment(
                      motions.axesOf(segment, from),
                      motions.speeds().axes(),
                      motions.externalTarget(segment, from.external())));
      segments.add(resolved);
      at = new Joints(resolved.target(), resolved.external().axes());
    }
    return new AxisSpline(
        id, segments, sections, motions.tool(), motions.pathApproximation(order.approximations()));
  }

  /**
   * Returns the segments of the path of the block's tool. A segment with another tool ends where
   * that tool is at its point (assumed).
   */
  private List<SplineSegment> segments(BlockOrder block, Joints start)
      throws KrlExecutionException {
    Frame tool = motions.tool();
    List<SplineSegment> segments = new ArrayList<>();
    Frame at = motions.tcp(start.robot());
    Axis external = start.external();
    for (MotionOrder segment : block.segments()) {
      Frame from = at;
      Axis externalFrom = external;
      SplineSegment resolved =
          settings.with(
              segment.settings(), () -> segment(segment, tool, from, externalFrom, start));
      segments.add(resolved);
      at = resolved.target();
      external = resolved.external().axes();
    }
    return segments;
  }

  private SplineSegment segment(
      MotionOrder order, Frame tool, Frame from, Axis external, Joints start)
      throws KrlExecutionException {
    ExternalTarget end = motions.externalTarget(order, external);
    Frame target = frame(order, order.target(), tool, from, start);
    KrlStruct auxiliary = order.auxiliary();
    return new SplineSegment(
        shape(order),
        auxiliary == null ? null : frame(order, auxiliary, tool, from, start),
        target,
        order.circularAngle(),
        motions.speeds().path(),
        motions.orientation(),
        end);
  }

  private static Shape shape(MotionOrder order) {
    return switch (order.kind()) {
      case CIRC, CIRC_REL -> Shape.CIRCLE;
      default -> order.form() == MotionOrder.Form.THROUGH ? Shape.THROUGH : Shape.LINE;
    };
  }

  /** Returns a point of the path of the block's tool, in the root at the start of the block. */
  private Frame frame(MotionOrder order, KrlStruct target, Frame tool, Frame from, Joints start)
      throws KrlExecutionException {
    Frame toTool = Frames.product(Frames.inverse(motions.tool()), tool);
    if (PositionValues.isAxes(target)) {
      if (order.kind().relative()) {
        throw new KrlExecutionException(
            KrlExecutionException.WRONG_TYPE, "a segment needs a Cartesian increment");
      }
      return Frames.product(motions.tcp(PositionValues.toAxes(target, start.robot())), toTool);
    }
    Frame base = motions.baseInRoot(start.external());
    Frame fromInBase = Frames.product(Frames.inverse(base), from, Frames.inverse(toTool));
    Frame inBase = MotionResolver.inBase(order, target, fromInBase);
    return Frames.product(base, inBase, toTool);
  }

  // sections

  private static List<ConstantSpeed> constants(BlockOrder block) throws KrlExecutionException {
    List<ConstantSpeed> sections = new ArrayList<>();
    PathPoint from = null;
    for (BlockOrder.ConstantVelocityLine line : block.constants()) {
      if (line.end() == (from == null)) {
        throw refused("CONST_VEL START and CONST_VEL END must alternate");
      }
      if (from != null) {
        sections.add(new ConstantSpeed(from, line.at()));
      }
      from = line.end() ? null : line.at();
    }
    if (from != null) {
      throw refused("CONST_VEL START needs CONST_VEL END");
    }
    return sections;
  }

  /** Returns the sections of the time blocks, each with its part of the time of its block. */
  private static List<Timed> times(BlockOrder block) throws KrlExecutionException {
    List<Timed> sections = new ArrayList<>();
    List<BlockOrder.TimeLine> parts = new ArrayList<>();
    BlockOrder.@Nullable TimeLine start = null;
    for (BlockOrder.TimeLine line : block.times()) {
      if ((line.part() == TimeBlockPart.START) != (start == null)) {
        throw refused("TIME_BLOCK START and TIME_BLOCK END must alternate");
      }
      if (start == null) {
        start = line;
        parts.clear();
      } else if (line.part() == TimeBlockPart.PART) {
        parts.add(line);
      } else {
        add(sections, start.point(), parts, line);
        start = null;
      }
    }
    if (start != null) {
      throw refused("TIME_BLOCK START needs TIME_BLOCK END");
    }
    return sections;
  }

  private static void add(
      List<Timed> sections, int start, List<BlockOrder.TimeLine> parts, BlockOrder.TimeLine end)
      throws KrlExecutionException {
    double sum = 0;
    for (BlockOrder.TimeLine part : parts) {
      sum += part.value();
    }
    boolean whole = parts.isEmpty();
    boolean endsThere = whole || parts.get(parts.size() - 1).point() == end.point();
    if (!(end.value() > 0) || !(whole || sum > 0) || !endsThere) {
      throw refused(
          "TIME_BLOCK needs a time above 0 s, shares above 0 and no segment after its last PART");
    }
    if (whole) {
      sections.add(new Timed(start, end.point(), end.value()));
    }
    int from = start;
    for (BlockOrder.TimeLine part : parts) {
      if (!(part.value() > 0)) {
        throw refused("TIME_BLOCK PART must be above 0, is " + part.value());
      }
      sections.add(new Timed(from, part.point(), end.value() * part.value() / sum));
      from = part.point();
    }
  }

  private static KrlExecutionException refused(String text) {
    return new KrlExecutionException(MotionProblem.BAD_MOTION, text);
  }
}
