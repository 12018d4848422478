package no.hials.crosscom.control;

import static no.hials.crosscom.kinematics.Frames.angle;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * A space of positions, Cartesian or joint, with its limited quantities.
 *
 * @param <P> the type of position
 */
abstract sealed class Space<P> {
  final Channel channel;

  /** The variable that the program follows, and its kind. */
  final Target followed;

  /** Whether the law returns velocities. */
  final boolean isVelocity;

  private final Command<P> command;

  /** The period of the loop, s. */
  private final double period;

  /** The variable with the position of the robot. */
  final KRLVariable feedback;

  /** The variable with the position in the other space. */
  final KRLVariable otherFeedback;

  final List<Quantity> quantities;

  /** The names of the numbers of a position, as in the variables. */
  final List<String> names;

  /**
   * A limited quantity.
   *
   * @param name {@code path}, {@code rotation}, or {@code A1} to {@code A6}
   * @param unit mm or degrees
   * @param limits its limits
   */
  record Quantity(String name, String unit, MotionLimits limits) {}

  /** Calls a law. */
  @FunctionalInterface
  private interface Command<P> {
    /** Returns the desired position at the end of a period of this number of seconds. */
    P position(State state, P actual, double period) throws Exception;
  }

  private Space(
      Channel channel,
      LoopConfig config,
      Target standard,
      boolean isVelocity,
      Command<P> command,
      KRLVariable feedback,
      KRLVariable otherFeedback,
      List<Quantity> quantities,
      List<String> names) {
    this.channel = channel;
    this.followed = config.target() == null ? standard : config.target();
    this.isVelocity = isVelocity;
    this.command = command;
    this.period = config.period().toNanos() / 1e9;
    this.feedback = feedback;
    this.otherFeedback = otherFeedback;
    this.quantities = quantities;
    this.names = names;
  }

  /** Returns the space of the law, whose target is that of the configuration or of {@code krl}. */
  static Space<?> of(Law law, LoopConfig config, Channel channel) {
    Checks.holds(
        Stream.of(Law.class.getPermittedSubclasses()).filter(it -> it.isInstance(law)).count() == 1,
        "a law must implement one kind of law, "
            + law.getClass().getName()
            + " implements several");
    if (law instanceof Law.CartesianPosition position) {
      return new Cartesian(
          channel,
          config,
          Target.absolute("JOV_POS"),
          false,
          (state, actual, period) -> position.position(state));
    }
    if (law instanceof Law.CartesianVelocity velocity) {
      return new Cartesian(
          channel,
          config,
          Target.increment("MYPOS"),
          true,
          (state, actual, period) -> velocity.velocity(state).move(actual, period));
    }
    if (law instanceof Law.JointPosition position) {
      return new Joint(
          channel,
          config,
          Target.absolute("JOV_AXIS"),
          false,
          (state, actual, period) -> position.position(state));
    }
    if (law instanceof Law.JointVelocity velocity) {
      return new Joint(
          channel,
          config,
          Target.increment("MYAXIS"),
          true,
          (state, actual, period) -> moved(actual, velocity.velocity(state), period));
    }
    throw new IllegalArgumentException("a law of an unknown kind: " + law.getClass().getName());
  }

  private static Axis moved(Axis actual, Axis speed, double period) {
    double[] numbers = actual.toArray();
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] += speed.get(i) * period;
    }
    return Axis.of(numbers);
  }

  /**
   * Returns whether the override applies to increments: otherwise the robot would need too long for
   * the steps that are planned when it is told to stand.
   */
  final boolean scalesIncrements() {
    return isVelocity && followed.increment();
  }

  /** Returns the variable that the program follows. */
  abstract KRLVariable target();

  abstract P actual() throws ControlRefusedException;

  /** Checks the last position read in the other space. */
  abstract void checkOther(Guard guard) throws ControlRefusedException;

  abstract void check(Guard guard, P place, boolean actual) throws ControlRefusedException;

  /** Calls the law and returns the desired position. */
  final P ask(State state, P actual) throws Exception {
    return command.position(state, actual, period);
  }

  /** Computes the distance of two positions, for each quantity. */
  abstract void differences(P from, P to, double[] into);

  /** Returns the numbers of a position. */
  abstract double[] numbers(P place);

  /** Sets the variable that the program follows. */
  abstract void setTarget(double[] numbers);

  /** Returns the numbers of an increment that is a part of the difference of two positions. */
  abstract double[] increment(P from, P to, double part);

  /**
   * Cuts an increment to the step limits, keeping its direction.
   *
   * @return whether it was cut
   */
  abstract boolean cut(double[] increment);

  /** Positions of the tool. */
  static final class Cartesian extends Space<Frame> {
    private static final int TURN = 3;

    private final KRLFrame target;
    private double lastA5 = Double.NaN;

    Cartesian(
        Channel channel,
        LoopConfig config,
        Target standard,
        boolean isVelocity,
        Command<Frame> command) {
      super(
          channel,
          config,
          standard,
          isVelocity,
          command,
          channel.position,
          channel.axes,
          List.of(
              new Quantity("path", "mm", config.safety().path()),
              new Quantity("rotation", "degrees", config.safety().rotation())),
          List.of("X", "Y", "Z", "A", "B", "C"));
      this.target = new KRLFrame(followed.name());
    }

    @Override
    KRLVariable target() {
      return target;
    }

    @Override
    Frame actual() throws ControlRefusedException {
      return channel.frame();
    }

    @Override
    void checkOther(Guard guard) throws ControlRefusedException {
      Axis joints = channel.joints();
      guard.check(joints, false); // with the margin, since the target of the axes is not known
      guard.checkWrist(joints.a5(), lastA5);
      lastA5 = joints.a5();
    }

    @Override
    void check(Guard guard, Frame place, boolean actual) throws ControlRefusedException {
      guard.check(place, actual);
    }

    @Override
    void differences(Frame from, Frame to, double[] into) {
      into[0] = from.distance(to);
      into[1] = angle(from, to);
    }

    @Override
    double[] numbers(Frame place) {
      return new double[] {place.x(), place.y(), place.z(), place.a(), place.b(), place.c()};
    }

    @Override
    void setTarget(double[] numbers) {
      target.setXToZ(numbers[0], numbers[1], numbers[2]);
      target.setAToC(numbers[TURN], numbers[TURN + 1], numbers[TURN + 2]);
    }

    @Override
    double[] increment(Frame from, Frame to, double part) {
      Frame turn = Rotations.part(Rotations.leading(from, to), part);
      return new double[] {
        part * (to.x() - from.x()),
        part * (to.y() - from.y()),
        part * (to.z() - from.z()),
        turn.a(),
        turn.b(),
        turn.c()
      };
    }

    @Override
    boolean cut(double[] increment) {
      double way = Math.hypot(Math.hypot(increment[0], increment[1]), increment[2]);
      double maxWay = quantities.get(0).limits().step();
      boolean cut = way > maxWay;
      if (cut) {
        for (int i = 0; i < TURN; i++) {
          increment[i] *= maxWay / way;
        }
      }
      Frame turn = new Frame(0, 0, 0, increment[TURN], increment[TURN + 1], increment[TURN + 2]);
      double angle = angle(Frame.IDENTITY, turn);
      double maxAngle = quantities.get(1).limits().step();
      if (angle > maxAngle) {
        Frame part = Rotations.part(turn, maxAngle / angle);
        increment[TURN] = part.a();
        increment[TURN + 1] = part.b();
        increment[TURN + 2] = part.c();
        return true;
      }
      return cut;
    }
  }

  /** Positions of the axes. */
  static final class Joint extends Space<Axis> {
    private final KRLAxis target;

    Joint(
        Channel channel,
        LoopConfig config,
        Target standard,
        boolean isVelocity,
        Command<Axis> command) {
      super(
          channel,
          config,
          standard,
          isVelocity,
          command,
          channel.axes,
          channel.position,
          quantities(config.safety().axes()),
          List.of("A1", "A2", "A3", "A4", "A5", "A6"));
      this.target = new KRLAxis(followed.name());
    }

    private static List<Quantity> quantities(MotionLimits limits) {
      List<Quantity> axes = new ArrayList<>();
      for (int i = 1; i <= 6; i++) {
        axes.add(new Quantity("A" + i, "degrees", limits));
      }
      return List.copyOf(axes);
    }

    @Override
    KRLVariable target() {
      return target;
    }

    @Override
    Axis actual() throws ControlRefusedException {
      return channel.joints();
    }

    @Override
    void checkOther(Guard guard) throws ControlRefusedException {
      guard.check(
          channel.frame(), false); // with the margin, since the target of the tool is not known
    }

    @Override
    void check(Guard guard, Axis place, boolean actual) throws ControlRefusedException {
      guard.check(place, actual);
    }

    @Override
    void differences(Axis from, Axis to, double[] into) {
      for (int i = 0; i < into.length; i++) {
        into[i] = Math.abs(to.get(i) - from.get(i));
      }
    }

    @Override
    double[] numbers(Axis place) {
      return place.toArray();
    }

    @Override
    void setTarget(double[] numbers) {
      target.setA1ToA6(numbers);
    }

    @Override
    double[] increment(Axis from, Axis to, double part) {
      double[] increment = to.minus(from).toArray();
      for (int i = 0; i < increment.length; i++) {
        increment[i] *= part;
      }
      return increment;
    }

    @Override
    boolean cut(double[] increment) {
      double largest = 0;
      for (double part : increment) {
        largest = Math.max(largest, Math.abs(part));
      }
      double step = quantities.get(0).limits().step();
      if (largest <= step) {
        return false;
      }
      for (int i = 0; i < increment.length; i++) {
        increment[i] *= step / largest;
      }
      return true;
    }
  }
}
