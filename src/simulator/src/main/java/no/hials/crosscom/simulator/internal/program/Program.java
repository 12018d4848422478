package no.hials.crosscom.simulator.internal.program;

/** A module that can be selected, compiled together with all that it calls. */
public final class Program {
  private final CompiledRoutine main;

  Program(CompiledRoutine main) {
    this.main = main;
  }

  /**
   * Gives the name of the module.
   *
   * @return the name as written
   */
  public String name() {
    return main.module();
  }

  CompiledRoutine main() {
    return main;
  }
}
