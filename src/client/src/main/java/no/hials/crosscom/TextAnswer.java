package no.hials.crosscom;

/**
 * A value that the server sent.
 *
 * @param text the value as KRL text
 * @param nanos how long the exchange took, in ns
 */
record TextAnswer(String text, long nanos) {}
