package no.hials.crosscom.simulator.internal.program;

import java.util.Optional;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.KrlExecutionException;

/** What the interpreter of a program asks of the controller around it. */
public interface ProgramEnvironment {

  /**
   * Gives the simulated time.
   *
   * @return ms since an arbitrary moment; never less than before
   */
  long time();

  /**
   * Gives the value of {@code $ADVANCE}.
   *
   * @return how many motions may be planned ahead, 0 to 5
   */
  int advance();

  /**
   * Counts the motions that were handed over and have not begun.
   *
   * @return how many wait behind the one under way
   */
  int motionsAhead();

  /**
   * Says whether all motions that were handed over have ended, those put aside left out.
   *
   * @return true if the robot has nothing left to do
   */
  boolean motionFinished();

  /**
   * Takes a motion to be executed behind those handed over before.
   *
   * @param order the motion
   * @throws KrlExecutionException if it is not possible; it stops the program
   */
  void move(MotionOrder order) throws KrlExecutionException;

  /**
   * Brakes the robot on its path and puts the motions that were handed over aside. Those handed
   * over from now on begin when it stands.
   *
   * @param maximum whether to brake as hard as possible ({@code BRAKE F})
   */
  void holdMotion(boolean maximum);

  /** Lets the motions go on that the last {@link #holdMotion} put aside. */
  void releaseMotion();

  /**
   * Brakes the robot and forgets all motions handed over since the last {@link #holdMotion}, and
   * those that were put aside.
   *
   * @param holds how many times {@link #holdMotion} is undone, the last first; the motions put
   *     aside by earlier ones stay
   */
  void discardMotion(int holds);

  /**
   * Sets an output for a time.
   *
   * @param output the number of the output
   * @param level what it becomes
   * @param seconds how long
   * @throws KrlExecutionException if it is not possible; it stops the program
   */
  void pulse(int output, boolean level, double seconds) throws KrlExecutionException;

  /**
   * Computes where given axis positions bring the tool, by {@code $TOOL} and {@code $BASE}.
   *
   * @param axes an AXIS or E6AXIS
   * @return an E6POS; nothing if there is none
   */
  Optional<KrlStruct> forward(KrlStruct axes);

  /**
   * Computes axis positions that bring the tool to a position, by {@code $TOOL} and {@code $BASE}.
   *
   * @param position a FRAME, POS or E6POS
   * @param start the AXIS or E6AXIS to which the result is to be close
   * @return an E6AXIS; nothing if there is none
   */
  Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start);

  /**
   * Learns why the program has stopped.
   *
   * @param fault the fault
   * @param position where it is
   */
  void fault(KrlExecutionException fault, Position position);
}
