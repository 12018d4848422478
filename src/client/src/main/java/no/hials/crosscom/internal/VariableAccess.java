package no.hials.crosscom.internal;

import java.util.Objects;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/** Lets the client use methods that {@link KRLVariable} hides from programs. */
public abstract class VariableAccess {
  private static volatile @Nullable VariableAccess instance;

  /** Called by the only implementation, in {@link KRLVariable}. */
  protected VariableAccess() {}

  /** Returns the implementation; it exists once a variable class is loaded. */
  public static VariableAccess get() {
    return Objects.requireNonNull(instance, "no variable class is loaded");
  }

  /**
   * Installs the one implementation.
   *
   * @throws IllegalStateException if there is one
   */
  public static synchronized void set(VariableAccess access) {
    if (instance != null) {
      throw new IllegalStateException("the access to variables is set already");
    }
    instance = access;
  }

  /**
   * Returns the read request of a variable, function 0, with any id, which is encoded once and not
   * to be changed; null if the name is not ASCII.
   */
  public abstract byte @Nullable [] readFrame(KRLVariable variable);

  /** Returns whether a value is or can contain a text or an ENUM. */
  public abstract boolean holdsText(KRLVariable variable);

  /** Returns the type of the value as named in a message: the KRL type, the record or the enum. */
  public abstract String type(KRLVariable variable);

  /** Creates a variable whose type in messages is a Java enum. */
  public abstract KRLEnum newEnum(String name, Class<?> type);

  /** Returns the cause to report for a text that is not a value of a type: of a public class. */
  public abstract IllegalArgumentException cause(IllegalArgumentException failure);

  /**
   * Returns the text that a write of a variable sends. Printing a number or a structure of numbers
   * creates no objects.
   *
   * @return the text, valid until the next call for the variable
   * @throws IllegalStateException if the variable has no value
   */
  public abstract CharSequence writeText(KRLVariable variable);

  /**
   * Sets a variable from text in place, all or nothing.
   *
   * @param scanner at the beginning of the text
   * @param written whether the text is that of a write, which may name some fields only
   * @return false if the class of the variable can only be set from a String
   */
  public abstract boolean scan(KRLVariable variable, KrlScanner scanner, boolean written);

  /** Sets a variable of a class that can only be set from a String. */
  public abstract void setFromString(KRLVariable variable, String text);

  /**
   * Sets one element of an array from text; {@link #acceptElements} makes them the value.
   *
   * @param scanner at the beginning of the element's text
   * @param index from 0
   */
  public abstract void scanElement(KRLArray array, KrlScanner scanner, int index);

  /** Sets the array to the elements set by {@link #scanElement}. */
  public abstract void acceptElements(KRLArray array, int count);

  /** Sets how long the last exchange took, in ns. */
  public abstract void setReadTime(KRLVariable variable, long nanos);
}
