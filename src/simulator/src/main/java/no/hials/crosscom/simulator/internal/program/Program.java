package no.hials.crosscom.simulator.internal.program;

/** A module that can be selected, compiled with all modules it calls. */
public record Program(CompiledRoutine main) {
  /** Returns the name of the module, as written. */
  public String name() {
    return main.module();
  }
}
