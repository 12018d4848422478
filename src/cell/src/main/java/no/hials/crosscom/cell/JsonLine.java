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
import no.hials.crosscom.protocol.value.KrlVisitor;

/**
 * Prints a variable as one line of JSON, such as <code>
 * {"name":"$OV_PRO","type":"INT","value":100,"text":"100"}</code>. The help of {@code read}
 * describes it.
 */
public final class JsonLine {
  // escaped text does not depend on the charset of stdout, and is safe on a terminal
  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

  private static final Printer PRINTER = new Printer();

  private JsonLine() {}

  /** Prints the text of a variable, as {@link #of(String, String, String)} without a robot. */
  public static String of(String name, String text) {
    return of("", name, text);
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
            json.writeStringField("text", text);
          });
    }
    return of(robot, name, value, text);
  }

  /**
   * Prints a variable.
   *
   * @param robot the robot of the variable; left out if empty
   * @param text the text of the value
   */
  public static String of(String robot, String name, KrlValue value, String text) {
    return line(
        robot,
        name,
        json -> {
          writeTyped(json, name, value);
          json.writeStringField("text", text);
        });
  }

  /**
   * Writes the fields {@code type} and {@code value} of a variable, for a structure also {@code
   * struc}, in the form of {@link #of(String, String)}.
   *
   * @param json the generator, within an object
   */
  public static void writeTyped(JsonGenerator json, String name, KrlValue value)
      throws IOException {
    boolean whole = Leaf.isWholeArray(name);
    KrlValue shown = whole && KrlArray.isElement(value) ? new KrlArray(List.of(value)) : value;
    json.writeStringField("type", type(shown, whole));
    if (shown instanceof KrlStruct struct) {
      json.writeStringField("struc", struct.typeName());
    }
    json.writeFieldName("value");
    write(json, shown);
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
    // Jackson does not escape DEL
    return text.toString().replace("\u007F", "\\u007F");
  }

  private static String type(KrlValue value, boolean whole) {
    return value.accept(new TypeName(whole));
  }

  /** Writes a value: a number, text or truth value, a list, or an object with the fields. */
  public static void write(JsonGenerator json, KrlValue value) throws IOException {
    value.accept(PRINTER).write(json);
  }

  /** Returns the name of a value's type; {@code whole} if the name of the variable ends in []. */
  private record TypeName(boolean whole) implements KrlVisitor<String> {
    @Override
    public String visit(KrlInt number) {
      return "INT";
    }

    @Override
    public String visit(KrlReal number) {
      return "REAL";
    }

    @Override
    public String visit(KrlBool bool) {
      return "BOOL";
    }

    @Override
    public String visit(KrlEnum constant) {
      return "ENUM";
    }

    @Override
    public String visit(KrlString string) {
      return whole || string.text().length() != 1 ? "CHAR[]" : "CHAR";
    }

    @Override
    public String visit(KrlArray array) {
      return type(array.elements().get(0), false) + "[]";
    }

    @Override
    public String visit(KrlStruct struct) {
      return "STRUC";
    }
  }

  /** Returns the code that writes a value. */
  private static final class Printer implements KrlVisitor<JsonFields> {
    @Override
    public JsonFields visit(KrlInt number) {
      return json -> json.writeNumber(number.value());
    }

    @Override
    public JsonFields visit(KrlReal number) {
      // of the controller's digits; a float would be printed with fewer
      return json -> json.writeNumber(Double.parseDouble(number.print()));
    }

    @Override
    public JsonFields visit(KrlBool bool) {
      return json -> json.writeBoolean(bool.value());
    }

    @Override
    public JsonFields visit(KrlString string) {
      return json -> json.writeString(string.text());
    }

    @Override
    public JsonFields visit(KrlEnum constant) {
      return json -> json.writeString(constant.print());
    }

    @Override
    public JsonFields visit(KrlArray array) {
      return json -> {
        json.writeStartArray();
        for (KrlValue element : array.elements()) {
          write(json, element);
        }
        json.writeEndArray();
      };
    }

    @Override
    public JsonFields visit(KrlStruct struct) {
      return json -> {
        json.writeStartObject();
        for (KrlStruct.Field field : struct.fields()) {
          json.writeFieldName(field.name());
          write(json, field.value());
        }
        json.writeEndObject();
      };
    }
  }
}
