package no.hials.crosscom.internal.exchange;

import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.MalformedFrameException;

/**
 * The answer to an exchange, and how long the exchange took.
 *
 * <p>Each connection has one, and the next exchange changes it, so that an exchange creates no
 * objects. The turn of the connection guards it.
 */
public final class ExchangeAnswer {
  private final AnswerFrame frame = new AnswerFrame();
  private long nanos;

  /** Sets the answer to the one at the beginning of a buffer. */
  public void set(byte[] buffer, int length, long exchangeNanos) throws MalformedFrameException {
    nanos = exchangeNanos;
    frame.wrap(buffer, length);
  }

  /** Returns the frame; if it answers a read or write, its value is open. */
  public AnswerFrame frame() {
    return frame;
  }

  /** Returns the time from sending the request to having the answer. */
  public long nanos() {
    return nanos;
  }

  /** Returns a copy of the value. */
  public TextAnswer toText() {
    return new TextAnswer(frame.toString(), nanos);
  }
}
