package no.hials.crosscom.lang;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** A statement of a routine. */
public sealed interface Statement {

  /**
   * Gives the place.
   *
   * @return where it begins
   */
  Position position();

  /** A statement that an interrupt or a trigger can execute. */
  sealed interface Action extends Statement permits Assignment, Call, Pulse {}

  /**
   * {@code A = B}.
   *
   * @param position where it begins
   * @param target what is assigned to
   * @param value the value
   */
  record Assignment(Position position, Expression.Variable target, Expression value)
      implements Action {}

  /**
   * A call of a subprogram.
   *
   * @param position where it begins
   * @param name the subprogram's name as written
   * @param arguments the arguments; null for one that is left out
   */
  record Call(Position position, String name, List<@Nullable Expression> arguments)
      implements Action {}

  /**
   * {@code PULSE($OUT[1],TRUE,0.5)}.
   *
   * @param position where it begins
   * @param signal the output
   * @param level what it becomes for the time
   * @param seconds how long
   */
  record Pulse(Position position, Expression.Variable signal, Expression level, Expression seconds)
      implements Action {}

  /**
   * {@code IF}.
   *
   * @param position where it begins
   * @param condition decides
   * @param then what is executed if it is true
   * @param otherwise what is executed if not; empty without {@code ELSE}
   */
  record If(
      Position position, Expression condition, List<Statement> then, List<Statement> otherwise)
      implements Statement {}

  /**
   * {@code SWITCH}.
   *
   * @param position where it begins
   * @param selector decides
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
   * @param body what is executed
   */
  record Case(Position position, List<Expression> values, List<Statement> body) {}

  /**
   * {@code FOR}.
   *
   * @param position where it begins
   * @param counter the variable that counts
   * @param from its first value
   * @param to its last value
   * @param step what is added; null for 1
   * @param body what is executed
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
   * @param condition looked at before each turn
   * @param body what is executed
   */
  record While(Position position, Expression condition, List<Statement> body)
      implements Statement {}

  /**
   * {@code REPEAT ... UNTIL}.
   *
   * @param position where it begins
   * @param body what is executed
   * @param until looked at behind each turn; true ends
   */
  record Repeat(Position position, List<Statement> body, Expression until) implements Statement {}

  /**
   * {@code LOOP}.
   *
   * @param position where it begins
   * @param body what is executed
   */
  record Loop(Position position, List<Statement> body) implements Statement {}

  /**
   * {@code EXIT}: leaves the innermost loop.
   *
   * @param position where it stands
   */
  record Exit(Position position) implements Statement {}

  /**
   * {@code GOTO}.
   *
   * @param position where it begins
   * @param label where to
   */
  record Goto(Position position, String label) implements Statement {}

  /**
   * {@code NAME:}.
   *
   * @param position where it stands
   * @param name the label
   */
  record Label(Position position, String name) implements Statement {}

  /**
   * {@code RETURN}.
   *
   * @param position where it begins
   * @param value the value of a function; null in a subprogram
   */
  record Return(Position position, @Nullable Expression value) implements Statement {}

  /**
   * {@code HALT}.
   *
   * @param position where it stands
   */
  record Halt(Position position) implements Statement {}

  /**
   * {@code CONTINUE}: keeps the next statement from stopping the advance run.
   *
   * @param position where it stands
   */
  record Continue(Position position) implements Statement {}

  /**
   * {@code WAIT FOR}.
   *
   * @param position where it begins
   * @param condition what is waited for
   */
  record WaitFor(Position position, Expression condition) implements Statement {}

  /**
   * {@code WAIT SEC}.
   *
   * @param position where it begins
   * @param seconds how long
   */
  record WaitSec(Position position, Expression seconds) implements Statement {}

  /**
   * {@code INTERRUPT DECL 3 WHEN A==B DO C()}.
   *
   * @param position where it begins
   * @param global whether it says {@code GLOBAL}
   * @param priority the number
   * @param condition a rising edge of it triggers
   * @param action what is executed
   */
  record InterruptDeclaration(
      Position position, boolean global, Expression priority, Expression condition, Action action)
      implements Statement {}

  /** What {@code INTERRUPT} does to a declared interrupt. */
  enum InterruptCommand {
    /** Makes it look. */
    ON,
    /** Makes it look away. */
    OFF,
    /** Allows it again. */
    ENABLE,
    /** Keeps it in mind but does not run it. */
    DISABLE
  }

  /**
   * {@code INTERRUPT ON 3}.
   *
   * @param position where it begins
   * @param command what
   * @param priority the number; null for all
   */
  record Interrupt(Position position, InterruptCommand command, @Nullable Expression priority)
      implements Statement {}

  /**
   * {@code RESUME}.
   *
   * @param position where it stands
   */
  record Resume(Position position) implements Statement {}

  /**
   * {@code BRAKE}.
   *
   * @param position where it stands
   * @param maximum whether it says {@code F}
   */
  record Brake(Position position, boolean maximum) implements Statement {}

  /** The kinds of motion. */
  enum MotionKind {
    /** Point to point. */
    PTP,
    /** Straight. */
    LIN,
    /** On a circle. */
    CIRC,
    /** Point to point, from the last target on. */
    PTP_REL,
    /** Straight, from the last target on. */
    LIN_REL,
    /** On a circle, from the last target on. */
    CIRC_REL;

    /**
     * Says whether the target is an increment.
     *
     * @return true for the kinds with {@code _REL}
     */
    public boolean relative() {
      return this == PTP_REL || this == LIN_REL || this == CIRC_REL;
    }
  }

  /** What asks for approximate positioning. */
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
   * @param auxiliary the point on the way of a circle; null for the others
   * @param target the end
   * @param circularAngle {@code CA}, in degrees; null without it
   * @param approximations none for exact positioning
   * @param coordinates {@code #BASE} or {@code #TOOL} behind a relative straight motion; null
   *     without it
   */
  record Motion(
      Position position,
      MotionKind kind,
      @Nullable Expression auxiliary,
      Expression target,
      @Nullable Expression circularAngle,
      Set<Approximation> approximations,
      @Nullable String coordinates)
      implements Statement {}

  /**
   * {@code TRIGGER WHEN DISTANCE=0 DELAY=20 DO ...}.
   *
   * @param position where it begins
   * @param onPath whether it says {@code PATH} instead of {@code DISTANCE}
   * @param distance 0 for the start and 1 for the end of the next motion; with {@code PATH} mm from
   *     the end
   * @param delay in ms; null for 0
   * @param action what is executed
   * @param priority the number behind {@code PRIO}; null without it
   */
  record Trigger(
      Position position,
      boolean onPath,
      Expression distance,
      @Nullable Expression delay,
      Action action,
      @Nullable Expression priority)
      implements Statement {}
}
