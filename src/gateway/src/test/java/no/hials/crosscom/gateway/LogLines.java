package no.hials.crosscom.gateway;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.LoggerFactory;

/** The lines that are logged until it is closed. Thread-safe. */
public final class LogLines implements AutoCloseable {
  private final Logger logger;
  private final ListAppender<ILoggingEvent> events = new ListAppender<>();

  private LogLines(Logger logger) {
    this.logger = logger;
    events.list = new CopyOnWriteArrayList<>();
    events.start();
    logger.addAppender(events);
  }

  /** Begins to collect the lines of a class. */
  public static LogLines of(Class<?> from) {
    return new LogLines((Logger) LoggerFactory.getLogger(from));
  }

  /** Begins to collect the lines of the classes of the gateway. */
  public static LogLines ofGateway() {
    return new LogLines((Logger) LoggerFactory.getLogger(Gateway.class.getPackageName()));
  }

  /** Returns the lines so far. */
  public List<String> get() {
    return events.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  @Override
  public void close() {
    logger.detachAppender(events);
  }
}
