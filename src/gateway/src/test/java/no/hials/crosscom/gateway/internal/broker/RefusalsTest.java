package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import com.hivemq.client.mqtt.exceptions.MqttEncodeException;
import no.hials.crosscom.gateway.Health;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

class RefusalsTest {
  private final Logger logger = (Logger) LoggerFactory.getLogger(Refusals.class);
  private final ListAppender<ILoggingEvent> lines = new ListAppender<>();
  private final Refusals refusals =
      new Refusals("plain", new SessionFigures(new Health(), "plain"), new Culprits("plain"));

  @BeforeEach
  void listen() {
    lines.start();
    logger.addAppender(lines);
  }

  @AfterEach
  void close() {
    logger.detachAppender(lines);
  }

  private void refuse(String topic) {
    refusals.add(topic, new MqttEncodeException("too long"));
  }

  @Test
  void aTopicHasOneLineUntilTheNextConnection() {
    refuse("a");
    refuse("a");
    refuse("b");
    refusals.clear();
    refuse("a");

    String rest = ": too long; further refusals of the topic are only counted";
    assertThat(lines.list)
        .extracting(ILoggingEvent::getFormattedMessage)
        .containsExactly(
            "MQTT plain: the broker refuses a" + rest,
            "MQTT plain: the broker refuses b" + rest,
            "MQTT plain: the broker refuses a" + rest);
  }

  @Test
  void manyTopicsHaveAFewLines() {
    for (int i = 0; i < 1000; i++) {
      refuse("topic" + i);
    }

    assertThat(lines.list).hasSize(20);
    assertThat(lines.list.get(19).getFormattedMessage())
        .isEqualTo(
            "MQTT plain: the broker refuses topic19: too long; all further refusals are only"
                + " counted");
  }
}
