package no.hials.crosscom.internal.c3;

import java.util.Objects;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.c3.KeyAction;
import no.hials.crosscom.c3.Pendant;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;

/** Presses keys by messages of type 12. */
public final class C3Pendant implements Pendant {
  private final MessageChannel channel;

  public C3Pendant(MessageChannel channel) {
    this.channel = channel;
  }

  @Override
  public void press(KeyAction key) throws CrossComException {
    send(key, false);
  }

  @Override
  public void release(KeyAction key) throws CrossComException {
    send(key, true);
  }

  private void send(KeyAction key, boolean released) throws CrossComException {
    Objects.requireNonNull(key, "key");
    channel.ask(
        new PendantKeyRequest(0, key.key(), key.number(), key.keyCode(), key.direction(), released),
        ProgramResponse.class,
        (released ? "release of " : "press of ") + key);
  }
}
