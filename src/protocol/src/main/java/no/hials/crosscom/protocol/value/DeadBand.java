package no.hials.crosscom.protocol.value;

import java.util.stream.IntStream;

/**
 * Tells changed values from noise.
 *
 * @param width the difference up to which a REAL counts as unchanged, in its own unit, also if the
 *     controller prints one of the two values as an INT
 * @param isReal whether numbers are REALs even if the controller prints both values as INTs
 */
public record DeadBand(double width, boolean isReal) {
  /** Returns whether a value, or a part of it, differs by more than the dead band. */
  public boolean differs(KrlValue before, KrlValue now) {
    return now.accept(new Comparison(before));
  }

  /** Compares each kind of value with the value before. */
  private final class Comparison implements KrlVisitor<Boolean> {
    private final KrlValue before;

    Comparison(KrlValue before) {
      this.before = before;
    }

    @Override
    public Boolean visit(KrlInt number) {
      if (before instanceof KrlReal old) {
        return isBeyond(old.value(), number.value());
      }
      if (isReal && before instanceof KrlInt old) {
        return isBeyond(old.value(), number.value());
      }
      return !number.equals(before);
    }

    @Override
    public Boolean visit(KrlReal number) {
      if (before instanceof KrlInt old) {
        return isBeyond(old.value(), number.value());
      }
      return !(before instanceof KrlReal old) || isBeyond(old.value(), number.value());
    }

    private boolean isBeyond(double old, double number) {
      return Math.abs(old - number) > width;
    }

    @Override
    public Boolean visit(KrlBool bool) {
      return !bool.equals(before);
    }

    @Override
    public Boolean visit(KrlString string) {
      return !string.equals(before);
    }

    @Override
    public Boolean visit(KrlEnum constant) {
      return !constant.equals(before);
    }

    @Override
    public Boolean visit(KrlStruct struct) {
      return !(before instanceof KrlStruct old)
          || old.fields().size() != struct.fields().size()
          || struct.fields().stream()
              .anyMatch(
                  field ->
                      old.get(field.name())
                          .map(value -> differs(value, field.value()))
                          .orElse(true));
    }

    @Override
    public Boolean visit(KrlArray array) {
      int size = array.elements().size();
      return !(before instanceof KrlArray old)
          || old.elements().size() != size
          || IntStream.range(0, size)
              .anyMatch(i -> differs(old.elements().get(i), array.elements().get(i)));
    }
  }
}
