package no.hials.crosscom.cell;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.toml.TomlFactory;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** A table of a TOML file whose errors contain file, line and key. */
public final class TomlTable {
  /** The rule for a text. */
  public static final String TEXT = "must be a text in quotes";

  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final Path file;
  private final TomlLines lines;
  private final List<String> path;
  private final Map<?, ?> values;

  private TomlTable(Path file, TomlLines lines, List<String> path, Map<?, ?> values) {
    this.file = file;
    this.lines = lines;
    this.path = path;
    this.values = values;
  }

  /**
   * Returns the text of a file.
   *
   * @throws FileException if it cannot be read or is not in UTF-8
   */
  public static String textOf(Path file) throws FileException {
    try {
      String text = Files.readString(file);
      // as Windows editors write it
      return text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
    } catch (CharacterCodingException e) {
      throw new FileException("cannot read " + file + ": it must be UTF-8", e);
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
  }

  /**
   * Reads the text of a file.
   *
   * @param file its name for errors
   */
  public static TomlTable parse(Path file, String text) throws FileException {
    try (JsonParser parser = new TomlFactory().createParser(text)) {
      parser.nextToken();
      return new TomlTable(file, new TomlLines(text), List.of(), readTable(parser));
    } catch (JacksonException e) {
      String place = e.getLocation() == null ? "" : ":" + line(text, e);
      throw new FileException(file + place + ": invalid TOML: " + e.getOriginalMessage(), e);
    } catch (IOException e) {
      throw new FileException("cannot read " + file + ": " + e.getMessage(), e);
    }
  }

  /** Returns the line of an error; the parser finds a duplicate key at the next key or the end. */
  private static int line(String text, JacksonException e) {
    JsonLocation place = e.getLocation();
    int line = place.getLineNr();
    if (e.getOriginalMessage().equals("Duplicate key")) {
      List<String> lines = text.lines().toList();
      line -= place.getColumnNr() == 1 ? 1 : 0;
      while (lines.get(line - 1).matches("\\s*(#.*)?")) {
        line--;
      }
    }
    return line;
  }

  private static Map<String, Object> readTable(JsonParser parser) throws IOException {
    Map<String, Object> table = new LinkedHashMap<>();
    while (parser.nextToken() == JsonToken.FIELD_NAME) {
      String key = parser.currentName();
      table.put(key, readValue(parser, parser.nextToken()));
    }
    return table;
  }

  private static Object readValue(JsonParser parser, JsonToken token) throws IOException {
    return switch (token) {
      case START_OBJECT -> readTable(parser);
      case VALUE_STRING -> parser.getText();
      case VALUE_NUMBER_INT -> parser.getNumberValue();
      case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      case START_ARRAY -> readArray(parser);
      case VALUE_TRUE, VALUE_FALSE -> parser.getBooleanValue();
      default -> {
        // unused here; its type is refused later
        parser.skipChildren();
        yield List.of();
      }
    };
  }

  private static List<Object> readArray(JsonParser parser) throws IOException {
    List<Object> elements = new ArrayList<>();
    for (JsonToken token = parser.nextToken();
        token != JsonToken.END_ARRAY;
        token = parser.nextToken()) {
      elements.add(readValue(parser, token));
    }
    return elements;
  }

  /** Returns the last part of the table's name. */
  public String name() {
    return path.get(path.size() - 1);
  }

  /** Refuses all keys but these. */
  public void allow(String... keys) throws FileException {
    for (Object key : values.keySet()) {
      if (!List.of(keys).contains(key)) {
        throw error(String.valueOf(key), "no such key; known: " + String.join(", ", keys));
      }
    }
  }

  /** Returns the tables in a table; empty if the key is absent. */
  public List<TomlTable> tables(String key) throws FileException {
    List<TomlTable> tables = new ArrayList<>();
    TomlTable outer = table(key);
    for (Object name : outer.values.keySet()) {
      tables.add(outer.table(String.valueOf(name)));
    }
    return tables;
  }

  /** Returns whether the table has a key. */
  public boolean has(String key) {
    return values.containsKey(key);
  }

  /** Returns a table in this one; empty if the key is absent. */
  public TomlTable table(String key) throws FileException {
    Object value = values.containsKey(key) ? values.get(key) : Map.of();
    if (value instanceof Map<?, ?> table) {
      return new TomlTable(file, lines, pathOf(key), table);
    }
    throw error(key, "must be a table");
  }

  /** Returns a text; null if the key is absent. */
  public @Nullable String text(String key) throws FileException {
    Object value = values.get(key);
    if (value == null || value instanceof String) {
      return (String) value;
    }
    throw error(key, TEXT);
  }

  /** Returns a file, relative to the folder of this one; null if the key is absent. */
  public @Nullable Path file(String key) throws FileException {
    return converted(key, file::resolveSibling, TEXT, String.class);
  }

  /** Returns a truth value; false if the key is absent. */
  public boolean flag(String key) throws FileException {
    Object value = values.get(key);
    if (value == null || value instanceof Boolean) {
      return value != null && (Boolean) value;
    }
    throw error(key, "must be true or false, without quotes");
  }

  /** Returns a list of texts; empty if the key is absent. */
  public List<String> texts(String key) throws FileException {
    return list(key, String.class, "must be a list of texts in quotes");
  }

  /** Returns a list of numbers; empty if the key is absent. */
  public List<Double> numbers(String key) throws FileException {
    return list(key, Number.class, "must be a list of numbers").stream()
        .map(Number::doubleValue)
        .toList();
  }

  private <T> List<T> list(String key, Class<T> type, String rule) throws FileException {
    Object value = values.containsKey(key) ? values.get(key) : List.of();
    if (value instanceof List<?> elements && elements.stream().allMatch(type::isInstance)) {
      return elements.stream().map(type::cast).toList();
    }
    throw error(key, rule);
  }

  /** Returns a number; null if the key is absent. */
  public @Nullable Double number(String key) throws FileException {
    return converted(key, Double::valueOf, "must be a number, without quotes", Number.class);
  }

  /**
   * Returns the converted value of a text or number; null if the key is absent.
   *
   * @param rule says in errors which types are allowed
   * @param types the allowed types of the value
   */
  public <T> @Nullable T converted(
      String key, Function<String, T> converter, String rule, Class<?>... types)
      throws FileException {
    Object value = values.get(key);
    if (value == null) {
      return null;
    }
    if (Stream.of(types).noneMatch(type -> type.isInstance(value))) {
      throw error(key, rule);
    }
    try {
      return converter.apply(value.toString());
    } catch (IllegalArgumentException e) {
      throw error(key, String.valueOf(e.getMessage()));
    }
  }

  /** Returns the file and line of the table. */
  public String place() {
    return place(path);
  }

  /** Returns the file and line of a key. */
  public String place(String key) {
    return place(pathOf(key));
  }

  private String place(List<String> keys) {
    int line = lines.find(keys);
    return file + (line == 0 ? "" : ":" + line);
  }

  /** Creates an exception about the table as a whole. */
  public FileException error(String message) {
    return error(path, message);
  }

  /** Creates an exception about a key of the table. */
  public FileException error(String key, String message) {
    return error(pathOf(key), message);
  }

  private FileException error(List<String> keys, String message) {
    return new FileException(place(keys) + ": " + String.join(".", keys) + ": " + message);
  }

  private List<String> pathOf(String key) {
    List<String> inner = new ArrayList<>(path);
    inner.add(key);
    return inner;
  }
}
