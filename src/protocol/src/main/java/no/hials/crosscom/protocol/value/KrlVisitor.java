package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.Nullable;

/**
 * Handles each kind of KRL value; {@link KrlValue#accept} calls the method for the kind.
 *
 * @param <R> the result
 */
public interface KrlVisitor<R extends @Nullable Object> {
  /** Handles an INT. */
  R visit(KrlInt number);

  /** Handles a REAL. */
  R visit(KrlReal number);

  /** Handles a BOOL. */
  R visit(KrlBool bool);

  /** Handles a text. */
  R visit(KrlString string);

  /** Handles a constant of an ENUM. */
  R visit(KrlEnum constant);

  /** Handles an aggregate. */
  R visit(KrlStruct struct);

  /** Handles the elements of an array. */
  R visit(KrlArray array);
}
