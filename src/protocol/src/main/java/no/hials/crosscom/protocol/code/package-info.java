/**
 * The codes and flags in the messages of C3 Bridge (docs/reference/c3-messages.md#constants), and
 * enumerations of KRL.
 *
 * <p>An unknown number is kept: {@link no.hials.crosscom.protocol.code.Code} and {@link
 * no.hials.crosscom.protocol.code.Flags} hold the number, and return the constant if there is one.
 */
@NullMarked
package no.hials.crosscom.protocol.code;

import org.jspecify.annotations.NullMarked;
