package no.hials.crosscom.simulator;

/** Breaks a simulation on purpose. */
public final class BrokenVariable {
  private BrokenVariable() {}

  /** An error that cannot be printed before memory is free again. */
  private static final class NoMemory extends OutOfMemoryError {
    private static final long serialVersionUID = 1;

    private int failures = 2;

    @Override
    public String getMessage() {
      if (failures-- > 0) {
        throw this;
      }
      return "no memory";
    }
  }

  /** Makes each write to MYINT fail for lack of memory, which cannot be printed at first. */
  public static void exhaustMemory(VariableTable variables) {
    NoMemory error = new NoMemory();
    variables
        .scope()
        .guard(
            "MYINT",
            (path, value) -> {
              throw error;
            });
  }

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
