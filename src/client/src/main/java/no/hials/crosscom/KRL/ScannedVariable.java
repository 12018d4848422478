package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;

/** The base class of the client's scalars, strings and arrays, which are read in place. */
abstract class ScannedVariable extends KRLVariable {
  ScannedVariable(String name) {
    super(name);
  }

  /** Reads the whole text; sets the value only if the text is valid. */
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

  /** Adds the brackets of a whole array to a name. */
  static String wholeArray(String name) {
    String trimmed = name.strip();
    return trimmed.isEmpty() || trimmed.endsWith("]") ? trimmed : trimmed + "[]";
  }
}
