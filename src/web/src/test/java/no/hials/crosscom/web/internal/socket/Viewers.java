package no.hials.crosscom.web.internal.socket;

import java.time.Clock;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.Tokens;

/** Creates viewers without a socket. */
public final class Viewers {
  private Viewers() {}

  /** Returns a viewer of a browser that may jog. */
  public static Viewer create(Commands commands, Sockets sockets) {
    Tokens tokens = new Tokens(Clock.systemUTC());
    String unused = tokens.open(tokens.newLink(Role.JOG)).orElseThrow();
    return new Viewer(tokens.browsers().get(0), commands, Runnable::run, sockets);
  }
}
