package no.hials.crosscom.lang;

import org.jspecify.annotations.Nullable;

/**
 * Handles each kind of declaration; {@link Declaration#accept} calls the method for the kind.
 *
 * @param <R> the result
 */
public interface DeclarationVisitor<R extends @Nullable Object> {
  /** Handles variables of one type. */
  R visit(Declaration.Variables group);

  /** Handles a structure type. */
  R visit(Declaration.StrucDeclaration struc);

  /** Handles an enumeration type. */
  R visit(Declaration.EnumDeclaration enumeration);

  /** Handles a signal. */
  R visit(Declaration.Signal signal);

  /** Handles a channel. */
  R visit(Declaration.Channel channel);

  /** Handles a line that sets an element or a component. */
  R visit(Declaration.InitialValue initial);

  /** Handles a reference to another module. */
  R visit(Declaration.External external);
}
