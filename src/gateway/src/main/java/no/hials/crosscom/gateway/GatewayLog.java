package no.hials.crosscom.gateway;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ConfiguratorRank;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.spi.ContextAwareBase;
import ch.qos.logback.core.status.NopStatusListener;
import java.util.List;

/**
 * Configures logback: messages for the operator go to stderr, one line each. Text from outside
 * cannot start a new line. Logback finds this class as a service, and prefers it to the file {@code
 * logback.xml} of a library.
 */
@ConfiguratorRank(ConfiguratorRank.CUSTOM_HIGH_PRIORITY)
public final class GatewayLog extends ContextAwareBase implements Configurator {
  private static final String PATTERN =
      "%d{yyyy-MM-dd'T'HH:mm:ss.SSSXXX} %-5level %replace(%msg){'\\p{Cntrl}', '?'}%n";

  /** Loggers that print a stack trace for each refused client or damaged message, or many lines. */
  private static final List<String> OF_REFUSED_CLIENTS =
      List.of(
          "io.netty.channel",
          "io.netty.util.ReferenceCountUtil",
          "org.eclipse.milo.opcua.sdk.server.diagnostics",
          "org.eclipse.milo.opcua.stack.core.util.TaskQueue",
          "org.eclipse.milo.opcua.stack.transport.server");

  /** A logger that warns of each request that the server does not know. */
  private static final String OF_UNKNOWN_REQUESTS = "org.eclipse.milo.opcua.sdk.server.OpcUaServer";

  /** Called by the service loader. */
  public GatewayLog() {}

  @Override
  public ExecutionStatus configure(LoggerContext context) {
    if (System.getProperty("logback.configurationFile") != null) { // the operator's own
      return ExecutionStatus.INVOKE_NEXT_IF_ANY;
    }
    // logback would print its own messages to stdout
    context.getStatusManager().add(new NopStatusListener());

    PatternLayoutEncoder encoder = new PatternLayoutEncoder();
    encoder.setContext(context);
    encoder.setPattern(PATTERN);
    encoder.start();

    ConsoleAppender<ILoggingEvent> stderr = new ConsoleAppender<>();
    stderr.setContext(context);
    stderr.setTarget("System.err");
    stderr.setEncoder(encoder);
    stderr.start();

    Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.setLevel(Level.WARN);
    root.addAppender(stderr);
    context.getLogger("no.hials.crosscom").setLevel(Level.INFO);
    for (String each : OF_REFUSED_CLIENTS) {
      context.getLogger(each).setLevel(Level.OFF);
    }
    context.getLogger(OF_UNKNOWN_REQUESTS).setLevel(Level.ERROR);
    return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
  }
}
