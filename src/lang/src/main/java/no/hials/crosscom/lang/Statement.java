package no.hials.crosscom.lang;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** A statement of a routine. */
public sealed interface Statement {

  /** Returns the position of the first token. */
  Position position();

  /**
   * A line that cannot be parsed, or a block whose beginning or end cannot be parsed. The result of
   * the parse has its error; a program that reaches it must stop.
   *
   * @param position where it begins
   * @param reason the message of the error
   */
  record Invalid(Position position, String reason) implements Statement {}

  /** A statement that an interrupt or trigger can execute. */
  sealed interface Action extends Statement permits AssignmentStatement, CallStatement, Pulse {}

  /**
   * {@code A = B}.
   *
   * @param position where it begins
   * @param target the variable that gets the value
   * @param value the value
   */
  record AssignmentStatement(Position position, Expression.Variable target, Expression value)
      implements Action {}

  /**
   * A call of a subprogram.
   *
   * @param position where it begins
   * @param name the subprogram's name as written
   * @param arguments the arguments; null for an omitted argument
   */
  record CallStatement(Position position, String name, List<@Nullable Expression> arguments)
      implements Action {}

  /**
   * {@code PULSE($OUT[1],TRUE,0.5)}.
   *
   * @param position where it begins
   * @param signal the output
   * @param level its value during the pulse
   * @param seconds the length of the pulse
   */
  record Pulse(Position position, Expression.Variable signal, Expression level, Expression seconds)
      implements Action {}

  /**
   * {@code IF}.
   *
   * @param position where it begins
   * @param condition the condition
   * @param then the statements if it is true
   * @param otherwise the statements if it is false; empty without {@code ELSE}
   */
  record If(
      Position position, Expression condition, List<Statement> then, List<Statement> otherwise)
      implements Statement {}

  /**
   * {@code SWITCH}.
   *
   * @param position where it begins
   * @param selector the value that selects the branch
   * @param cases the branches in the order of the file
   * @param otherwise {@code DEFAULT}; null without one
   */
  record Switch(
      Position position, Expression selector, List<Case> cases, @Nullable List<Statement> otherwise)
      implements Statement {}

  /**
   * A {@code CASE}.
   *
   * @param position where it begins
   * @param values at least one
   * @param body the statements in it
   */
  record Case(Position position, List<Expression> values, List<Statement> body) {}

  /**
   * {@code FOR}.
   *
   * @param position where it begins
   * @param counter the loop variable
   * @param from its first value
   * @param to its last value
   * @param step the increment; null for 1
   * @param body the statements in it
   */
  record For(
      Position position,
      Expression.Variable counter,
      Expression from,
      Expression to,
      @Nullable Expression step,
      List<Statement> body)
      implements Statement {}

  /**
   * {@code WHILE}.
   *
   * @param position where it begins
   * @param condition tested before each iteration
   * @param body the statements in it
   */
  record While(Position position, Expression condition, List<Statement> body)
      implements Statement {}

  /**
   * {@code REPEAT ... UNTIL}.
   *
   * @param position where it begins
   * @param body the statements in it
   * @param until tested after each iteration; true ends the loop
   */
  record Repeat(Position position, List<Statement> body, Expression until) implements Statement {}

  /**
   * {@code LOOP}.
   *
   * @param position where it begins
   * @param body the statements in it
   */
  record Loop(Position position, List<Statement> body) implements Statement {}

  /**
   * {@code EXIT}: leaves the innermost loop.
   *
   * @param position where it is
   */
  record Exit(Position position) implements Statement {}

  /**
   * {@code GOTO}.
   *
   * @param position where it begins
   * @param label the target
   */
  record Goto(Position position, String label) implements Statement {}

  /**
   * {@code NAME:}.
   *
   * @param position where it is
   * @param name the label
   */
  record Label(Position position, String name) implements Statement {}

  /**
   * {@code RETURN}.
   *
   * @param position where it begins
   * @param value the result of a function; null in a subprogram
   */
  record Return(Position position, @Nullable Expression value) implements Statement {}

  /**
   * {@code HALT}.
   *
   * @param position where it is
   */
  record Halt(Position position) implements Statement {}

  /**
   * {@code CONTINUE}: keeps the next statement from stopping the advance run.
   *
   * @param position where it is
   */
  record Continue(Position position) implements Statement {}

  /**
   * {@code WAIT FOR}.
   *
   * @param position where it begins
   * @param condition the condition that ends the wait
   */
  record WaitFor(Position position, Expression condition) implements Statement {}

  /**
   * {@code WAIT SEC}.
   *
   * @param position where it begins
   * @param seconds the length of the wait
   */
  record WaitSec(Position position, Expression seconds) implements Statement {}

  /**
   * {@code INTERRUPT DECL 3 WHEN A==B DO C()}.
   *
   * @param position where it begins
   * @param global whether it is {@code GLOBAL}
   * @param priority the priority, which is also the number of the interrupt
   * @param condition triggers on its rising edge
   * @param action the action
   */
  record InterruptDeclaration(
      Position position, boolean global, Expression priority, Expression condition, Action action)
      implements Statement {}

  /** The commands for a declared interrupt. */
  enum InterruptCommand {
    /** Activates the interrupt. */
    ON,
    /** Deactivates the interrupt. */
    OFF,
    /** Enables the interrupt. */
    ENABLE,
    /** Disables the interrupt; a detected event is stored. */
    DISABLE
  }

  /**
   * {@code INTERRUPT ON 3}.
   *
   * @param position where it begins
   * @param command the command
   * @param priority the number of the interrupt; null for all
   */
  record Interrupt(Position position, InterruptCommand command, @Nullable Expression priority)
      implements Statement {}

  /**
   * {@code RESUME}.
   *
   * @param position where it is
   */
  record Resume(Position position) implements Statement {}

  /**
   * {@code BRAKE}.
   *
   * @param position where it is
   * @param maximum whether it is {@code BRAKE F}
   */
  record Brake(Position position, boolean maximum) implements Statement {}

  /** The kinds of motion. */
  enum MotionKind {
    /** Point to point. */
    PTP,
    /** Linear. */
    LIN,
    /** Circular. */
    CIRC,
    /** Point to point, relative to the last target. */
    PTP_REL,
    /** Linear, relative to the last target. */
    LIN_REL,
    /** Circular, relative to the last target. */
    CIRC_REL;

    /** Returns whether the target is relative: true for the kinds with {@code _REL}. */
    public boolean relative() {
      return this == PTP_REL || this == LIN_REL || this == CIRC_REL;
    }
  }

  /** The criteria of approximate positioning. */
  enum Approximation {
    /** By {@code $APO.CPTP}. */
    C_PTP,
    /** By {@code $APO.CDIS}. */
    C_DIS,
    /** By {@code $APO.CVEL}. */
    C_VEL,
    /** By {@code $APO.CORI}. */
    C_ORI
  }

  /**
   * A motion.
   *
   * @param position where it begins
   * @param kind the kind
   * @param auxiliary the auxiliary point of a circular motion; null for the others
   * @param target the target
   * @param circularAngle {@code CA}, in degrees; null without it
   * @param approximations empty for exact positioning
   * @param coordinates {@code #BASE} or {@code #TOOL} of a relative linear or circular motion; null
   *     without it
   */
  record MotionStatement(
      Position position,
      MotionKind kind,
      @Nullable Expression auxiliary,
      Expression target,
      @Nullable Expression circularAngle,
      Set<Approximation> approximations,
      @Nullable String coordinates)
      implements Statement {}

  /** The kinds of spline motions and segments. */
  enum SplineKind {
    /** Point to point. */
    SPTP,
    /** Linear. */
    SLIN,
    /** Circular. */
    SCIRC,
    /** A segment through a point, only in a block. */
    SPL,
    /** Point to point, relative to the last target. */
    SPTP_REL,
    /** Linear, relative to the last target. */
    SLIN_REL,
    /** Circular, relative to the last target. */
    SCIRC_REL,
    /** A segment through a point, relative to the last target. */
    SPL_REL;

    /** Returns whether the target is relative: true for the kinds with {@code _REL}. */
    public boolean relative() {
      return this == SPTP_REL || this == SLIN_REL || this == SCIRC_REL || this == SPL_REL;
    }

    /** Returns whether it is {@code SPTP} or {@code SPTP_REL}. */
    public boolean pointToPoint() {
      return this == SPTP || this == SPTP_REL;
    }
  }

  /** A statement that is allowed in a spline block. */
  sealed interface SplineElement extends Statement
      permits SplineMotion, Trigger, TimeBlock, ConstantVelocity, StopOnPath {}

  /**
   * A spline motion, or a segment of a spline block.
   *
   * @param position where it begins
   * @param kind the kind
   * @param auxiliary the auxiliary point of a circular motion; null for the others
   * @param target the target
   * @param circularAngle {@code CA}, in degrees; null without it
   * @param with the assignments to system variables after {@code WITH}; they hold for this motion
   *     only. Empty without {@code WITH}
   * @param approximate whether it has {@code C_SPL} or {@code C_DIS}
   * @param coordinates {@code #BASE} or {@code #TOOL} of a relative motion; null without it
   */
  record SplineMotion(
      Position position,
      SplineKind kind,
      @Nullable Expression auxiliary,
      Expression target,
      @Nullable Expression circularAngle,
      List<AssignmentStatement> with,
      boolean approximate,
      @Nullable String coordinates)
      implements SplineElement {}

  /**
   * {@code SPLINE ... ENDSPLINE} or {@code PTP_SPLINE ... ENDSPLINE}. A block with an error is
   * {@link Invalid} as a whole, because it is one motion.
   *
   * @param position where it begins
   * @param pointToPoint whether it is {@code PTP_SPLINE}, whose segments are all {@code SPTP}
   * @param with the assignments to system variables after {@code WITH}; they hold for the segments
   *     without an assignment to the same variable. Empty without {@code WITH}
   * @param elements the segments, and what happens on them
   * @param approximate whether it ends with {@code C_SPL} or {@code C_DIS}
   */
  record SplineBlock(
      Position position,
      boolean pointToPoint,
      List<AssignmentStatement> with,
      List<SplineElement> elements,
      boolean approximate)
      implements Statement {}

  /** The lines of a time block. */
  enum TimeBlockPart {
    /** Begins the block. */
    START,
    /** Ends a part of the block. */
    PART,
    /** Ends the block. */
    END
  }

  /**
   * {@code TIME_BLOCK} in a spline block.
   *
   * @param position where it begins
   * @param part which line it is
   * @param value for {@code PART} its share of the time, for {@code END} the time of the block in
   *     s; null for {@code START}
   */
  record TimeBlock(Position position, TimeBlockPart part, @Nullable Expression value)
      implements SplineElement {}

  /**
   * {@code CONST_VEL} in a spline block: begins or ends a section of constant speed.
   *
   * @param position where it begins
   * @param end whether it is {@code CONST_VEL END}
   * @param distance in mm from the next point, or from the last with {@code ONSTART}
   * @param onStart whether it has {@code ONSTART}
   */
  record ConstantVelocity(Position position, boolean end, Expression distance, boolean onStart)
      implements SplineElement {}

  /**
   * {@code STOP WHEN PATH=50 IF A}: stops the robot on the path while a condition is true.
   *
   * @param position where it begins
   * @param distance in mm from the next point, or from the last with {@code ONSTART}
   * @param onStart whether it has {@code ONSTART}
   * @param condition the condition
   */
  record StopOnPath(Position position, Expression distance, boolean onStart, Expression condition)
      implements SplineElement {}

  /**
   * {@code ON_ERROR_PROCEED}: an error of the next statement does not stop the program.
   *
   * @param position where it is
   */
  record OnErrorProceed(Position position) implements Statement {}

  /**
   * {@code CONFIRM}: confirms a message.
   *
   * @param position where it begins
   * @param message the number of the message
   */
  record Confirm(Position position, Expression message) implements Statement {}

  /**
   * {@code ANIN ON A = 2*$ANIN[1]+1}: reads an analogue input in cycles; {@code ANIN OFF A}.
   *
   * @param position where it begins
   * @param target the variable that gets the value after {@code ON}; the name after {@code OFF}
   * @param value the value, which is evaluated in cycles; null for {@code OFF}
   */
  record AnalogInput(Position position, Expression.Variable target, @Nullable Expression value)
      implements Statement {}

  /**
   * {@code ANOUT ON $ANOUT[1] = 2*V+1 DELAY=0.5 MINIMUM=0 MAXIMUM=1}: writes an analogue output in
   * cycles; {@code ANOUT OFF $ANOUT[1]}.
   *
   * @param position where it begins
   * @param target the output
   * @param value the value, which is evaluated in cycles; null for {@code OFF}
   * @param delay in s; null without it
   * @param minimum the lower limit; null without it
   * @param maximum the upper limit; null without it
   */
  record AnalogOutput(
      Position position,
      Expression.Variable target,
      @Nullable Expression value,
      @Nullable Expression delay,
      @Nullable Expression minimum,
      @Nullable Expression maximum)
      implements Statement {}

  /**
   * {@code TRIGGER WHEN DISTANCE=0 DELAY=20 DO ...}.
   *
   * @param position where it begins
   * @param onPath whether it has {@code PATH} instead of {@code DISTANCE}
   * @param distance 0 for the start and 1 for the end of the next motion; with {@code PATH} in mm
   *     from the next point, or from the last with {@code ONSTART}
   * @param onStart whether it has {@code ONSTART}
   * @param delay in ms; null for 0
   * @param action the action
   * @param priority the number after {@code PRIO}; null without it
   */
  record Trigger(
      Position position,
      boolean onPath,
      Expression distance,
      boolean onStart,
      @Nullable Expression delay,
      Action action,
      @Nullable Expression priority)
      implements SplineElement {}
}
