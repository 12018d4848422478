package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers a function that the server does not support: {@code id, 00 00} and nothing more.
 *
 * @param id u16, of the request
 */
public record EmptyResponse(int id) implements Response {
  /** Checks the range. */
  public EmptyResponse {
    Ranges.u16("id", id);
  }
}
