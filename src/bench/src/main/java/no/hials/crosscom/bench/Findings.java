package no.hials.crosscom.bench;

import java.io.PrintStream;
import java.util.EnumMap;
import java.util.Map;
import java.util.TreeMap;

/** The findings of a trial. Safe for use by several threads. */
final class Findings {
  private static final int PRINTED = 20;

  /** The kinds of findings. */
  enum Defect {
    WRONG_VALUE("wrong values"),
    REPEATED_WRITE("writes sent twice"),
    FOREIGN_EXCEPTION("exceptions that are not the client's"),
    UNUSABLE("clients that stayed unusable"),
    HANG("calls that did not return"),
    THREAD("threads left after closing"),
    SOCKET("sockets left after closing");

    private final String title;

    Defect(String title) {
      this.title = title;
    }
  }

  private final PrintStream out;
  private final Map<Defect, Integer> defects = new EnumMap<>(Defect.class);
  private final Map<String, Long> counts = new TreeMap<>();
  private int printed;

  Findings(PrintStream out) {
    this.out = out;
  }

  /** Counts something that may happen. */
  synchronized void count(String title, long number) {
    counts.merge(title, number, Long::sum);
  }

  /** Counts a defect; the first ones are printed. */
  synchronized void add(Defect defect, String detail) {
    defects.merge(defect, 1, Integer::sum);
    if (printed++ < PRINTED) {
      out.println(defect + ": " + detail);
    }
  }

  synchronized boolean isClean() {
    return defects.isEmpty();
  }

  synchronized void print() {
    counts.forEach((title, number) -> out.printf("  %-58s %,12d%n", title, number));
    for (Defect defect : Defect.values()) {
      out.printf("  %-58s %,12d%n", defect.title, defects.getOrDefault(defect, 0));
    }
  }
}
