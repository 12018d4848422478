package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/** A robot whose motions take as many cycles as the test says, or end when the test says. */
final class FakeRobot implements ProgramEnvironment {
  static final long CYCLE_MILLIS = 12;

  /** Why a program has stopped. */
  record Fault(int number, String text, Position position) {}

  private final Scope globals;
  private final Deque<Deque<MotionOrder>> aside = new ArrayDeque<>();
  private Deque<MotionOrder> motions = new ArrayDeque<>();
  private boolean underWay;
  private long time;

  /** Everything that was asked of the robot. */
  final List<String> log = new ArrayList<>();

  final List<MotionOrder> orders = new ArrayList<>();
  private final MessageWindow messages =
      new MessageWindow((message, handle) -> log.add(message.type() + " " + message.fullText()));

  /** The numbers that $ERR got. */
  final List<Integer> errors = new ArrayList<>();

  final List<Fault> faults = new ArrayList<>();

  /** Whether kinematics have an answer. */
  boolean reaches = true;

  /** Whether kinematics fail with an error that is not the program's. */
  boolean broken;

  /** Whether a motion is refused. */
  boolean refuses;

  FakeRobot(Scope globals) {
    this.globals = globals;
  }

  /** Lets a cycle pass: the next motion begins if none is under way. */
  void cycle() {
    time += CYCLE_MILLIS;
    underWay = !motions.isEmpty();
  }

  /** Ends the motion that is under way. */
  MotionOrder endMotion() {
    underWay = false;
    return motions.removeFirst();
  }

  @Override
  public long time() {
    return time;
  }

  @Override
  public int advance() {
    try {
      return ((KrlInt) globals.read(VariablePath.parse("$ADVANCE"))).value();
    } catch (RefusedException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public int motionsAhead() {
    return motions.size() - (underWay ? 1 : 0);
  }

  @Override
  public Map<String, KrlValue> settings() {
    return Map.of();
  }

  @Override
  public void restore(Map<String, KrlValue> settings) {}

  @Override
  public boolean motionFinished() {
    return motions.isEmpty();
  }

  @Override
  public void move(MotionOrder order) throws KrlExecutionException {
    if (refuses) {
      throw new KrlExecutionException(1234, "the target is out of reach");
    }
    motions.addLast(order);
    orders.add(order);
    log.add(order.kind() + " " + order.target().printShort());
  }

  @Override
  public void holdMotion(boolean maximum) {
    log.add(maximum ? "hold hard" : "hold");
    aside.push(motions);
    motions = new ArrayDeque<>();
    underWay = false;
  }

  @Override
  public void releaseMotion() {
    log.add("release");
    motions = aside.pop();
  }

  @Override
  public void discardMotion(int holds) {
    log.add("discard " + holds);
    for (int i = 0; i < holds; i++) {
      aside.pop();
    }
    motions.clear();
    underWay = false;
  }

  @Override
  public void pulse(int output, boolean level, double seconds) {
    log.add("pulse " + output + " " + level + " " + seconds);
  }

  @Override
  public Optional<KrlStruct> forward(KrlStruct axes) {
    if (broken) {
      throw new UnsupportedOperationException("broken on purpose");
    }
    return reaches ? answer("{E6POS: X 1.5}") : Optional.empty();
  }

  @Override
  public Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start) {
    return reaches ? answer("{E6AXIS: A1 2.5}") : Optional.empty();
  }

  private static Optional<KrlStruct> answer(String text) {
    return Optional.of((KrlStruct) KrlValue.parse(text));
  }

  @Override
  public MessageWindow messages() {
    return messages;
  }

  @Override
  public void error(int number) {
    errors.add(number);
  }

  @Override
  public void fault(KrlExecutionException fault, Position position) {
    faults.add(new Fault(fault.number(), String.valueOf(fault.getMessage()), position));
  }
}
