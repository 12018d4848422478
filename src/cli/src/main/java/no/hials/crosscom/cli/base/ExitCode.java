package no.hials.crosscom.cli.base;

import java.util.Arrays;
import java.util.Map;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClosedException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComProtocolException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.OtherValueException;
import no.hials.crosscom.cell.recording.OutputException;

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
  /** The code with which shells report that SIGINT ended a process. */
  STOPPED(130);

  /** The exit codes of all exceptions of the client, and of those of the commands. */
  static final Map<Class<?>, ExitCode> OF_EXCEPTIONS =
      Map.ofEntries(
          Map.entry(CrossComAccessException.class, REFUSED),
          Map.entry(CrossComRefusedException.class, REFUSED),
          Map.entry(CrossComUnsupportedException.class, REFUSED),
          Map.entry(CrossComConnectException.class, NOT_CONNECTED),
          Map.entry(CrossComClosedException.class, LOST),
          Map.entry(CrossComConnectionLostException.class, LOST),
          Map.entry(CrossComProtocolException.class, LOST),
          Map.entry(CrossComTimeoutException.class, LOST),
          Map.entry(CrossComTransferException.class, LOST),
          Map.entry(CrossComValueException.class, LOST),
          Map.entry(CannotListenException.class, NOT_CONNECTED),
          Map.entry(FileException.class, USAGE),
          Map.entry(NotSentException.class, NOT_SENT),
          Map.entry(OtherValueException.class, REFUSED),
          Map.entry(StoppedException.class, STOPPED),
          Map.entry(OutputException.class, OUTPUT_LOST));

  /** The codes above are those of processes that a signal has ended. */
  private static final int FIRST_SIGNAL = 128;

  private final int code;

  ExitCode(int code) {
    this.code = code;
  }

  public int code() {
    return code;
  }

  /** Returns the constant of the code with which another process ended. */
  public static ExitCode of(int code) {
    return Arrays.stream(values())
        .filter(each -> each.code == code)
        .findFirst()
        .orElse(code > FIRST_SIGNAL ? STOPPED : INTERNAL_ERROR);
  }

  public ExitCode orWorse(ExitCode other) {
    return compareTo(other) >= 0 ? this : other;
  }

  /** Returns the exit code of a command that ended with an exception. */
  public static ExitCode of(Exception e) {
    if (e instanceof CrossComValueException value && !value.isSent()) {
      return USAGE;
    }
    return OF_EXCEPTIONS.getOrDefault(e.getClass(), INTERNAL_ERROR);
  }
}
