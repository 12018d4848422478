/**
 * The parts of {@link no.hials.crosscom.mock.MockServer}: connections, faults, discovery and the
 * handlers of both protocols.
 *
 * <p>A {@code ConnectionAcceptor} starts a {@code ClientConnection} for each client, which passes
 * each request to the {@code RequestDispatcher}; this executes one request at a time by a {@code
 * RequestHandler}, and returns a {@code ResponsePlan}.
 */
@NullMarked
package no.hials.crosscom.mock.internal;

import org.jspecify.annotations.NullMarked;
