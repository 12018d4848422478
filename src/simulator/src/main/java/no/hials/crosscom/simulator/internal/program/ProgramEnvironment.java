package no.hials.crosscom.simulator.internal.program;

import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;

/** The controller as a program uses it. */
public interface ProgramEnvironment {

  /** In ms. Its sum with any time is still a time. */
  double LONGEST_WAIT = 1e15;

  /** Returns the simulated time in ms since an arbitrary moment; it never decreases. */
  long time();

  /** Returns the simulated time in ms after a number of seconds, however large. */
  default long timeAfter(double seconds) {
    return time() + Math.round(Math.min(seconds * 1000, LONGEST_WAIT));
  }

  /** Returns {@code $ADVANCE}, the number of motions that may be planned in advance, 0 to 5. */
  int advance();

  /** Returns the number of motions that wait for the current motion to end. */
  int motionsAhead();

  /** Returns whether all motions have ended, except for suspended ones. */
  boolean motionFinished();

  /**
   * Adds a motion, which starts after the motions before it.
   *
   * @throws KrlExecutionException if the motion is not possible; it stops the program
   */
  void move(MotionOrder order) throws KrlExecutionException;

  /** Returns the values of the system variables that determine how a motion is planned. */
  Map<String, KrlValue> settings();

  /** Sets these variables to former values. */
  void restore(Map<String, KrlValue> settings);

  /**
   * Brakes the robot on its path and suspends its motions. Motions that are added later start when
   * the robot stands.
   *
   * @param maximum whether to brake as hard as possible ({@code BRAKE F})
   */
  void holdMotion(boolean maximum);

  /** Continues the motions that the last {@link #holdMotion} has suspended. */
  void releaseMotion();

  /**
   * Brakes the robot and removes the motions that were suspended by the last {@link #holdMotion} or
   * added since.
   *
   * @param holds the number of calls of {@link #holdMotion} to undo, the last first; motions
   *     suspended by earlier calls stay
   */
  void discardMotion(int holds);

  /**
   * Sets an output for a time.
   *
   * @param output the number of the output
   * @param level its value during the pulse
   * @param seconds the length of the pulse
   * @throws KrlExecutionException if it is not possible; it stops the program
   */
  void pulse(int output, boolean level, double seconds) throws KrlExecutionException;

  /**
   * Returns the position of the tool at given axis positions, by {@code $TOOL} and {@code $BASE}.
   *
   * @param axes an AXIS or E6AXIS
   * @return an E6POS; empty if it cannot be calculated
   */
  Optional<KrlStruct> forward(KrlStruct axes);

  /**
   * Returns axis positions for a position of the tool, by {@code $TOOL} and {@code $BASE}.
   *
   * @param position a FRAME, POS or E6POS
   * @param start an AXIS or E6AXIS; the result is close to it
   * @return an E6AXIS; empty if the position cannot be reached
   */
  Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start);

  /** Returns the messages of the programs. */
  MessageWindow messages();

  /**
   * Sets the number of {@code $ERR}, without a message.
   *
   * @param number 0 for no error
   */
  void error(int number);

  /** Called when a fault has stopped the program, with its position. */
  void fault(KrlExecutionException fault, Position position);
}
