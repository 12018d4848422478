package no.hials.crosscom.gateway.internal.mqtt;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import no.hials.crosscom.gateway.internal.broker.CommandQueue;
import no.hials.crosscom.gateway.internal.broker.Publication;
import no.hials.crosscom.gateway.internal.broker.Received;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import org.jspecify.annotations.Nullable;

/** The commands on plain topics and the messages of their results. Thread-safe. */
final class TopicCommands {
  /** The number of commands whose identity is remembered, so that none is executed twice. */
  private static final int REMEMBERED = 1000;

  private static final int LONGEST_PAYLOAD = 10_000;

  /** The maximum length of a text in an answer, in characters. */
  private static final int LONGEST_TEXT = 1000;

  /** The maximum length of the topics with the correlation data, in bytes. */
  private static final int LONGEST_ADDRESS = 1000;

  private static final JsonFactory JSON = new JsonFactory();

  private final Topics topics;
  private final int qos;
  private final CommandQueue commands;
  private final Consumer<Publication> results;
  private final Map<Identity, Boolean> known =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Identity, Boolean> eldest) {
          return size() > REMEMBERED;
        }
      };

  /** The identity of a command: two messages with the same one are one command. */
  private record Identity(String topic, String responseTopic, ByteBuffer correlation) {}

  /**
   * Creates the receiver of commands.
   *
   * @param results publishes a result; called on any thread
   */
  TopicCommands(MqttSettings settings, CommandQueue commands, Consumer<Publication> results) {
    this.topics = new Topics(settings.topic());
    this.qos = settings.qos();
    this.commands = commands;
    this.results = results;
  }

  /** Handles a message. Does not block. */
  void receive(Received message) {
    List<String> target = topics.target(message.topic());
    if (target == null) {
      return;
    }
    String robot = target.get(0);
    String variable = target.get(1).toUpperCase(Locale.ROOT);
    String who = "mqtt:" + (message.sender().isEmpty() ? "unknown" : message.sender());
    String text = UTF_8.decode(message.payload().duplicate()).toString();
    String refusal = refusal(message);
    if (refusal == null) {
      try {
        String value = value(text);
        commands.execute(
            who,
            robot,
            variable,
            value,
            message.expiry(),
            result -> answer(message, value, result));
        return;
      } catch (IllegalArgumentException e) {
        refusal = String.valueOf(e.getMessage());
      }
    }
    String result = commands.refused(who, robot, beginning(variable), refusal);
    if (hasShortAddress(message)) {
      answer(message, text, result);
    }
  }

  private @Nullable String refusal(Received message) {
    if (message.retained()) {
      return "a retained command is not executed: nobody knows how old it is";
    }
    if (message.payload().remaining() > LONGEST_PAYLOAD) {
      return "the command is longer than " + LONGEST_PAYLOAD + " bytes";
    }
    if (!hasShortAddress(message)) {
      return "the topics and the correlation data are longer than " + LONGEST_ADDRESS + " bytes";
    }
    ByteBuffer correlation = message.correlation();
    String responseTopic = message.responseTopic();
    if (correlation != null && responseTopic != null) {
      synchronized (known) {
        if (known.put(new Identity(message.topic(), responseTopic, correlation), true) != null) {
          return "not executed: a command with the same response topic and correlation data was"
              + " received before";
        }
      }
    }
    return null;
  }

  /** Returns whether the topics and the correlation data of many commands fit into the memory. */
  private static boolean hasShortAddress(Received message) {
    String response = message.responseTopic();
    ByteBuffer correlation = message.correlation();
    return bytes(message.topic())
            + (response == null ? 0 : bytes(response))
            + (correlation == null ? 0 : correlation.remaining())
        <= LONGEST_ADDRESS;
  }

  /** Returns the length of a topic as MQTT sends it. */
  private static int bytes(String topic) {
    return topic.getBytes(UTF_8).length;
  }

  /** Returns the value of a command as KRL writes it. */
  private static String value(String text) {
    // in KRL, a structure has a name after the brace, not a quote
    if (!text.strip().matches("(?s)\\{\\s*\".*")) {
      return text;
    }
    String rule = "must be {\"value\": ...} with a number, text or truth value, is " + text;
    try (JsonParser parser = JSON.createParser(text)) {
      parser.nextToken();
      if (!"value".equals(parser.nextFieldName())) {
        throw new IllegalArgumentException(rule);
      }
      String value =
          switch (parser.nextToken()) {
            case VALUE_STRING, VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> parser.getText();
            case VALUE_TRUE -> "TRUE";
            case VALUE_FALSE -> "FALSE";
            default -> throw new IllegalArgumentException(rule);
          };
      if (parser.nextToken() != JsonToken.END_OBJECT || parser.nextToken() != null) {
        throw new IllegalArgumentException(rule);
      }
      return value;
    } catch (IOException e) {
      throw new IllegalArgumentException(rule, e);
    }
  }

  /** Returns a text, or the beginning of a long one: answers must not fill the memory. */
  private static String beginning(String text) {
    return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT) + "...";
  }

  private void answer(Received command, String value, String result) {
    byte[] payload =
        ValueJson.object(
            json -> {
              json.writeStringField("time", ValueJson.time(Instant.now()));
              json.writeStringField("value", beginning(value));
              json.writeStringField("result", beginning(result));
            });
    results.accept(new Publication(Topics.result(command.topic()), payload, qos, false));
    String response = command.responseTopic();
    // an answer on one of these topics could be a command, or the death of a Sparkplug node
    if (response != null
        && !response.startsWith(topics.prefix() + "/")
        && !response.startsWith(SparkplugId.NAMESPACE + "/")) {
      results.accept(
          new Publication(response, ByteBuffer.wrap(payload), qos, false, command.correlation()));
    }
  }
}
