package no.hials.crosscom.simulator;

/** Breaks a simulation on purpose. */
public final class BrokenVariable {
  private BrokenVariable() {}

  /** Makes each write to MYINT fail with an error that is not the controller's. */
  public static void breakMyInt(VariableTable variables) {
    variables
        .scope()
        .guard(
            "MYINT",
            (path, value) -> {
              throw new UnsupportedOperationException("broken on purpose");
            });
  }
}
