/**
 * Gives tests with JUnit Jupiter a simulated controller of their own.
 *
 * <p>{@link no.hials.crosscom.mock.junit.KukaController} on a field or parameter starts a {@link
 * no.hials.crosscom.mock.MockServer} and closes it when its test or class has ended, however it
 * ended. Only this package needs JUnit (Jupiter 5.13 or newer), which the user's build brings.
 */
@NullMarked
package no.hials.crosscom.mock.junit;

import org.jspecify.annotations.NullMarked;
