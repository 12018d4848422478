package no.hials.crosscom.simulator.internal.program;

/** An interrupt or a trigger that interrupts a program. */
final class Interruption {
  private final int priority;
  private final CallFrame owner;
  private final CompiledCode action;
  private final boolean trigger;
  private boolean holding;

  /**
   * @param priority lower numbers are more urgent
   * @param owner the frame of its declaration, whose variables it uses
   * @param action the action
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

  /** Returns whether it has suspended the motions of the robot. */
  boolean holding() {
    return holding;
  }

  void setHolding() {
    holding = true;
  }
}
