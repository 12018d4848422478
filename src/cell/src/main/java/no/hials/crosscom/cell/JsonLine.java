package no.hials.crosscom.cell;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * Prints a variable as one line of JSON, such as <code>
 * {"name":"$OV_PRO","type":"INT","value":100}</code>. The help of {@code read} describes it.
 */
public final class JsonLine {
  // escaped text does not depend on the charset of stdout
  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

  private JsonLine() {}

  /** Prints the text of a variable, as {@link #of(String, String, String)} without a robot. */
  public static String of(String name, String text) {
    return of("", name, text);
  }

  /** Prints a variable, as {@link #of(String, String, KrlValue)} without a robot. */
  public static String of(String name, KrlValue value) {
    return of("", name, value);
  }

  /**
   * Prints the text of a variable.
   *
   * @param robot the robot of the variable; left out if empty
   * @param text the text of the variable; a text that is not a KRL value, such as the {@code PONG}
   *     of {@code PING}, becomes a string of the type UNKNOWN
   */
  public static String of(String robot, String name, String text) {
    KrlValue value;
    try {
      value = KrlValue.parse(text);
    } catch (KrlSyntaxException e) {
      return line(
          robot,
          name,
          json -> {
            json.writeStringField("type", "UNKNOWN");
            json.writeStringField("value", text);
          });
    }
    return of(robot, name, value);
  }

  /** Prints a variable; {@code robot} is left out if it is empty. */
  public static String of(String robot, String name, KrlValue value) {
    boolean whole = Leaf.isWholeArray(name);
    KrlValue shown = whole && Leaf.isElement(value) ? new KrlArray(List.of(value)) : value;
    return line(
        robot,
        name,
        json -> {
          json.writeStringField("type", type(shown, whole));
          if (shown instanceof KrlStruct struct) {
            json.writeStringField("struc", struct.typeName());
          }
          json.writeFieldName("value");
          write(json, shown);
        });
  }

  /** Writes the fields of an object. */
  @FunctionalInterface
  public interface JsonFields {
    void write(JsonGenerator json) throws IOException;
  }

  private static String line(String robot, String name, JsonFields content) {
    return object(
        json -> {
          if (!robot.isEmpty()) {
            json.writeStringField("robot", robot);
          }
          json.writeStringField("name", name);
          content.write(json);
        });
  }

  /** Returns an object on one line. */
  public static String object(JsonFields content) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = FACTORY.createGenerator(text)) {
      json.writeStartObject();
      content.write(json);
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  private static String type(KrlValue value, boolean whole) {
    if (value instanceof KrlInt) {
      return "INT";
    } else if (value instanceof KrlReal) {
      return "REAL";
    } else if (value instanceof KrlBool) {
      return "BOOL";
    } else if (value instanceof KrlEnum) {
      return "ENUM";
    } else if (value instanceof KrlString string) {
      return whole || string.text().length() != 1 ? "CHAR[]" : "CHAR";
    } else if (value instanceof KrlArray array) {
      return type(array.elements().get(0), false) + "[]";
    } else if (value instanceof KrlStruct) {
      return "STRUC";
    }
    throw new AssertionError(value);
  }

  static void write(JsonGenerator json, KrlValue value) throws IOException {
    if (value instanceof KrlInt number) {
      json.writeNumber(number.value());
    } else if (value instanceof KrlReal number) {
      // keeps the controller's digits, which a double would lose
      json.writeNumber(number.print());
    } else if (value instanceof KrlBool bool) {
      json.writeBoolean(bool.value());
    } else if (value instanceof KrlString string) {
      json.writeString(string.text());
    } else if (value instanceof KrlEnum constant) {
      json.writeString(constant.print());
    } else if (value instanceof KrlArray array) {
      json.writeStartArray();
      for (KrlValue element : array.elements()) {
        write(json, element);
      }
      json.writeEndArray();
    } else if (value instanceof KrlStruct struct) {
      json.writeStartObject();
      for (KrlStruct.Field field : struct.fields()) {
        json.writeFieldName(field.name());
        write(json, field.value());
      }
      json.writeEndObject();
    } else {
      throw new AssertionError(value);
    }
  }
}
