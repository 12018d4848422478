package no.hials.crosscom.simulator.internal.program;

/** A module that can be selected, compiled with all modules it calls. */
public final class Program {
  private final CompiledRoutine main;

  Program(CompiledRoutine main) {
    this.main = main;
  }

  /** Returns the name of the module, as written. */
  public String name() {
    return main.module();
  }

  CompiledRoutine main() {
    return main;
  }
}
