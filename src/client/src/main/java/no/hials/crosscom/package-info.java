/**
 * The client for KUKAVARPROXY: {@link no.hials.crosscom.CrossComClient} and what it throws.
 *
 * <p>One exchange is one request and its answer, under one lock, because the server serves one
 * request at a time. Every failure is a {@link no.hials.crosscom.CrossComException}; none becomes a
 * value.
 */
@NullMarked
package no.hials.crosscom;

import org.jspecify.annotations.NullMarked;
