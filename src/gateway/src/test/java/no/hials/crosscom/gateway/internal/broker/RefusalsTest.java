package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.exceptions.MqttEncodeException;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.LogLines;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class RefusalsTest {
  private final LogLines lines = LogLines.of(Refusals.class);
  private final Refusals refusals =
      new Refusals("plain", new SessionFigures(new Health(), "plain"), new Culprits("plain"));

  @AfterEach
  void close() {
    lines.close();
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
    assertThat(lines.get())
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

    assertThat(lines.get()).hasSize(20);
    assertThat(lines.get().get(19))
        .isEqualTo(
            "MQTT plain: the broker refuses topic19: too long; all further refusals are only"
                + " counted");
  }
}
