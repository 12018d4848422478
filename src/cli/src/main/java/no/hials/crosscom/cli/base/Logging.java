package no.hials.crosscom.cli.base;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import org.slf4j.LoggerFactory;

/** Sets how much is logged; {@link LogConfigurator} sets the destination and the format. */
public final class Logging {
  private Logging() {}

  /** Omits the warnings of a class, which a command prints itself, unless the output is verbose. */
  public static void leaveOut(Class<?> source, boolean verbose) {
    ((Logger) LoggerFactory.getLogger(source)).setLevel(verbose ? null : Level.ERROR);
  }

  /**
   * Sets the level.
   *
   * @param verbosity 0 for warnings, 1 for debug, more for trace
   */
  static void setVerbosity(int verbosity) {
    Logger root = (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.setLevel(verbosity == 0 ? Level.WARN : verbosity == 1 ? Level.DEBUG : Level.TRACE);
  }
}
