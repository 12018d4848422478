package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.lang.Statement.TimeBlockPart;
import no.hials.crosscom.simulator.internal.motion.PathPoint;

/**
 * The statements of a spline block with their values.
 *
 * @param pointToPoint whether it is {@code PTP_SPLINE}
 * @param segments its segments, without triggers
 * @param times the lines of its time blocks, in their order
 * @param constants where sections of constant speed begin and end, in their order
 */
public record BlockOrder(
    boolean pointToPoint,
    List<MotionOrder> segments,
    List<TimeLine> times,
    List<ConstantVelocityLine> constants) {
  /**
   * A line of a time block.
   *
   * @param point the point before it; 0 is the start of the block
   * @param value the share or the time in s; 0 for {@code START}
   */
  public record TimeLine(int point, TimeBlockPart part, double value) {}

  /** A {@code CONST_VEL}. */
  public record ConstantVelocityLine(boolean end, PathPoint at) {}
}
