package no.hials.crosscom.cli.base;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ConfiguratorRank;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxy;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.LayoutBase;
import ch.qos.logback.core.encoder.LayoutWrappingEncoder;
import ch.qos.logback.core.spi.ContextAwareBase;
import ch.qos.logback.core.status.NopStatusListener;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * Configures logback, which finds it as a service: warnings and errors go to stderr, one line each.
 * Written in Java, since starting an XML parser would take longer than a whole read.
 */
@ConfiguratorRank(ConfiguratorRank.CUSTOM_HIGH_PRIORITY)
public final class LogConfigurator extends ContextAwareBase implements Configurator {

  /** Creates the configurator; for the service loader. */
  public LogConfigurator() {}

  @Override
  public ExecutionStatus configure(LoggerContext context) {
    // logback's own notes would go to stdout
    context.getStatusManager().add(new NopStatusListener());

    Lines lines = new Lines();
    lines.setContext(context);
    lines.start();

    LayoutWrappingEncoder<ILoggingEvent> encoder = new LayoutWrappingEncoder<>();
    encoder.setContext(context);
    encoder.setLayout(lines);

    ConsoleAppender<ILoggingEvent> stderr = new ConsoleAppender<>();
    stderr.setContext(context);
    stderr.setName("stderr");
    stderr.setTarget("System.err");
    stderr.setEncoder(encoder);
    encoder.start();
    stderr.start();

    Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.setLevel(Level.WARN);
    root.addAppender(stderr);
    return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
  }

  /**
   * Prints {@code 12:30:59.123 DEBUG Connection: message}. Text from outside cannot begin a line.
   */
  private static final class Lines extends LayoutBase<ILoggingEvent> {
    private static final String OWN_PACKAGE = "no.hials.crosscom.";

    private final DateTimeFormatter time =
        DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

    @Override
    public String doLayout(ILoggingEvent event) {
      String logger = event.getLoggerName();
      StringBuilder line = new StringBuilder(128);
      time.formatTo(Instant.ofEpochMilli(event.getTimeStamp()), line);
      line.append(' ').append(event.getLevel()).append(' ');
      line.append(logger.startsWith(OWN_PACKAGE) ? logger.substring(OWN_PACKAGE.length()) : logger);
      line.append(": ")
          .append(PrintableText.of(event.getFormattedMessage()))
          .append(System.lineSeparator());
      if (event.getThrowableProxy() instanceof ThrowableProxy thrown) {
        line.append(StackTrace.of(thrown.getThrowable()));
      }
      return line.toString();
    }
  }
}
