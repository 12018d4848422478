package no.hials.crosscom.internal;

import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.Request;

/** Encodes frames in the form of the original's API. */
public final class BoxedFrame {
  private BoxedFrame() {}

  /** Encodes a request. */
  public static Byte[] of(Request request) {
    byte[] frame = Codec.encode(request);
    Byte[] boxed = new Byte[frame.length];
    for (int i = 0; i < frame.length; i++) {
      boxed[i] = frame[i];
    }
    return boxed;
  }
}
