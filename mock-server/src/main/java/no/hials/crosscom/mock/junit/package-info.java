/**
 * Starts a simulated controller for a test with JUnit Jupiter.
 *
 * <p>{@link no.hials.crosscom.mock.junit.KukaController} on a field or parameter starts a {@link
 * no.hials.crosscom.mock.MockServer}, and closes it after the test or class in any case. Only this
 * package needs JUnit (Jupiter 5.13 or newer), which the user's build provides.
 */
@NullMarked
package no.hials.crosscom.mock.junit;

import org.jspecify.annotations.NullMarked;
