package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;

/** What the scalars, strings and arrays of the client share: they are read in place. */
abstract class ScannedVariable extends KRLVariable {
  ScannedVariable(String name) {
    super(name);
  }

  /** Reads the whole text; sets the value only if all of it is right. */
  abstract void read(KrlScanner scanner);

  @Override
  protected final boolean setValueFrom(KrlScanner scanner, boolean written) {
    read(scanner);
    return true;
  }

  @Override
  protected void setValueFromString(String strValue) {
    read(new KrlScanner(strValue));
  }

  /** Adds the brackets that KRL wants behind the name of a whole array. */
  static String wholeArray(String name) {
    String trimmed = name.strip();
    return trimmed.isEmpty() || trimmed.endsWith("]") ? trimmed : trimmed + "[]";
  }
}
