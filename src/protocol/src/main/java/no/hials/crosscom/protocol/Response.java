package no.hials.crosscom.protocol;

/** A message from the server to the client. */
public sealed interface Response permits TypedResponse, EmptyResponse {

  /**
   * Returns the number of the request.
   *
   * @return 0 to 65535
   */
  int id();
}
