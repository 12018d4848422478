package no.hials.crosscom.examples;

/** Checks the arguments of an example. */
final class Arguments {
  private Arguments() {}

  /**
   * Returns whether the arguments name a controller. Anything other than {@code HOST PORT} or no
   * arguments is refused, so that nobody takes the numbers of a simulated robot for those of a real
   * one.
   *
   * @param args the arguments of the example
   * @throws IllegalArgumentException if there are arguments, but not two
   */
  static boolean nameAController(String[] args) {
    if (args.length != 0 && args.length != 2) {
      throw new IllegalArgumentException(
          "the arguments must be HOST PORT or none, are " + String.join(" ", args));
    }
    return args.length == 2;
  }
}
