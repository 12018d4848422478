package no.hials.crosscom.internal.exchange;

import no.hials.crosscom.protocol.TypedResponse;

/**
 * A message that the server sent.
 *
 * @param response the message
 * @param nanos how long the exchange took, in ns
 */
public record MessageAnswer(TypedResponse response, long nanos) {}
