package no.hials.crosscom.examples;

/** Tells what the arguments of an example name. */
final class Arguments {
  private Arguments() {}

  /**
   * Tells whether the arguments name a controller. What is neither {@code HOST PORT} nor nothing is
   * refused: somebody who meant a robot would see the numbers of a simulated one.
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
