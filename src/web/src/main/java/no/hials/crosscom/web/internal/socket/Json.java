package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NullNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/** Parses and prints the messages of a socket, with limits on what a page can send. */
public final class Json {
  static final NullNode NULL = NullNode.getInstance();

  private static final int MAX_DEPTH = 16;
  private static final int MAX_DIGITS = 40;
  private static final int MAX_NAME = 200;

  private static final ObjectMapper MAPPER =
      new ObjectMapper(
          JsonFactory.builder()
              .streamReadConstraints(
                  StreamReadConstraints.builder()
                      .maxNestingDepth(MAX_DEPTH)
                      .maxNumberLength(MAX_DIGITS)
                      .maxNameLength(MAX_NAME)
                      .build())
              .build());

  private Json() {}

  /** Returns an empty object. */
  public static ObjectNode object() {
    return JsonNodeFactory.instance.objectNode();
  }

  /** Returns an event without further fields. */
  public static ObjectNode event(String name) {
    return object().put("event", name);
  }

  /**
   * Parses a text.
   *
   * @throws JsonProcessingException if it is not JSON, or exceeds a limit
   */
  public static JsonNode parse(String text) throws JsonProcessingException {
    return MAPPER.readTree(text);
  }
}
