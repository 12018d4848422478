package no.hials.crosscom.cli.base;

import java.util.Arrays;
import java.util.Map;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.OutputException;

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

  private static final Map<Class<?>, ExitCode> OF_EXCEPTIONS =
      Map.of(
          CannotListenException.class, NOT_CONNECTED,
          FileException.class, USAGE,
          NotSentException.class, NOT_SENT,
          OtherValueException.class, REFUSED,
          StoppedException.class, STOPPED,
          OutputException.class, OUTPUT_LOST);

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

  /** Returns the exit code of a command that ended with an exception. */
  public static ExitCode of(Exception e) {
    if (e instanceof CrossComException failed) {
      return ofFailedRead(failed);
    }
    return OF_EXCEPTIONS.getOrDefault(e.getClass(), INTERNAL_ERROR);
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
