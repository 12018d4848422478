/**
 * The client for KUKAVARPROXY and C3 Bridge: {@link no.hials.crosscom.CrossComClient}, its values
 * and its exceptions.
 *
 * <p>One exchange is one request and its answer, under one lock, because the server serves one
 * request at a time. Every failure is a {@link no.hials.crosscom.CrossComException}; none becomes a
 * value, except in the original's {@code simpleRead}, {@code simpleWrite} and {@code sendRequest}.
 */
@NullMarked
package no.hials.crosscom;

import org.jspecify.annotations.NullMarked;
