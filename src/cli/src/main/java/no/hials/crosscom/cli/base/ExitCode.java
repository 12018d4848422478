package no.hials.crosscom.cli.base;

import java.util.Arrays;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.CrossComValueException;

/** How a command ended, from the best to the worst. {@link ConsoleCommand} documents them. */
public enum ExitCode {
  DONE(0),
  REFUSED(1),
  USAGE(2),
  NOT_CONNECTED(3),
  LOST(4),
  NOT_SENT(5),
  /** As EX_SOFTWARE of sysexits.h. */
  INTERNAL_ERROR(70),
  /** As EX_IOERR of sysexits.h. */
  OUTPUT_LOST(74),
  /** As shells say that SIGINT ended a process. */
  STOPPED(130);

  private final int code;

  ExitCode(int code) {
    this.code = code;
  }

  public int code() {
    return code;
  }

  /** Returns the one with a code, which one of them has. */
  public static ExitCode of(int code) {
    return Arrays.stream(values()).filter(each -> each.code == code).findFirst().orElseThrow();
  }

  public ExitCode orWorse(ExitCode other) {
    return compareTo(other) >= 0 ? this : other;
  }

  public static ExitCode ofFailedRead(CrossComException e) {
    if (e instanceof CrossComAccessException
        || e instanceof CrossComRefusedException
        || e instanceof CrossComUnsupportedException) {
      return REFUSED;
    }
    return e instanceof CrossComConnectException ? NOT_CONNECTED : LOST;
  }

  public static ExitCode ofFailedWrite(CrossComException e) {
    // it was not sent: it is too long
    return e instanceof CrossComValueException ? USAGE : ofFailedRead(e);
  }
}
