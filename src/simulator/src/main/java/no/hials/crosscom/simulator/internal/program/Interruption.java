package no.hials.crosscom.simulator.internal.program;

/** Why and with what right a program is interrupted: an interrupt or a trigger that has come. */
final class Interruption {
  private final int priority;
  private final CallFrame owner;
  private final CompiledCode action;
  private final boolean trigger;
  private boolean holding;

  /**
   * @param priority lower numbers go first
   * @param owner the frame that has declared it, whose variables it uses
   * @param action what is executed
   * @param trigger whether it is a trigger
   */
  Interruption(int priority, CallFrame owner, CompiledCode action, boolean trigger) {
    this.priority = priority;
    this.owner = owner;
    this.action = action;
    this.trigger = trigger;
  }

  int priority() {
    return priority;
  }

  CallFrame owner() {
    return owner;
  }

  CompiledCode action() {
    return action;
  }

  boolean isTrigger() {
    return trigger;
  }

  /** Says whether it has put the robot's motions aside. */
  boolean holding() {
    return holding;
  }

  void setHolding() {
    holding = true;
  }
}
