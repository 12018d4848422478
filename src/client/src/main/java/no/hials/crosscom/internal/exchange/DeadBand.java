package no.hials.crosscom.internal.exchange;

import java.util.stream.IntStream;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * Compares values.
 *
 * @param width the difference up to which a REAL counts as unchanged, in its own unit
 */
public record DeadBand(double width) {
  /** Returns whether a value, or a part of it, differs by more than the dead band. */
  public boolean differs(KrlValue before, KrlValue now) {
    if (before instanceof KrlReal a && now instanceof KrlReal b) {
      return Math.abs((double) a.value() - b.value()) > width;
    }
    if (before instanceof KrlStruct a && now instanceof KrlStruct b) {
      return a.fields().size() != b.fields().size()
          || b.fields().stream()
              .anyMatch(f -> a.get(f.name()).map(old -> differs(old, f.value())).orElse(true));
    }
    if (before instanceof KrlArray a && now instanceof KrlArray b) {
      int size = a.elements().size();
      return size != b.elements().size()
          || IntStream.range(0, size)
              .anyMatch(i -> differs(a.elements().get(i), b.elements().get(i)));
    }
    return !before.equals(now);
  }
}
