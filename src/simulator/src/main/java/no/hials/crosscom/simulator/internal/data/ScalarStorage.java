package no.hials.crosscom.simulator.internal.data;

import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/** A value without parts. */
final class ScalarStorage extends Storage {
  private final Type.Scalar type;
  private final @Nullable KrlValue value;

  ScalarStorage(Type.Scalar type, @Nullable KrlValue value) {
    this.type = type;
    this.value = value;
  }

  @Override
  Type type() {
    return type;
  }

  @Override
  long bytes() {
    return Type.SCALAR_BYTES;
  }

  @Override
  public boolean initialised() {
    return value != null;
  }

  @Override
  public KrlValue value() throws RefusedException {
    if (value == null) {
      throw notInitialised();
    }
    return value;
  }

  @Override
  Storage assign(KrlValue newValue) throws RefusedException {
    KrlValue converted = type.convert(newValue);
    return converted.equals(value) ? this : new ScalarStorage(type, converted);
  }

  @Override
  KrlValue coded(KrlValue newValue) throws RefusedException {
    if (type == Type.Base.INT && newValue instanceof KrlString string) {
      if (string.text().length() == 1) {
        return new KrlInt(CharacterCodes.codeOf(string.text().charAt(0)));
      }
    } else if (type == Type.Base.CHAR && newValue instanceof KrlInt code) {
      return new KrlString(String.valueOf(CharacterCodes.character(code.value())));
    }
    return newValue;
  }

  @Override
  KrlValue rounded(KrlValue given) throws RefusedException {
    KrlValue newValue = coded(given);
    if (type != Type.Base.INT || !(newValue instanceof KrlReal number)) {
      return newValue;
    }
    double nearest = Operators.nearest(number.value());
    if (nearest != (int) nearest) {
      throw new RefusedException(Refusal.OUT_OF_RANGE, "an INT has 32 bits, was given " + number);
    }
    return new KrlInt((int) nearest);
  }
}
