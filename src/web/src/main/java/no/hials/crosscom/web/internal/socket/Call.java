package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * A command of a page. The fields come from a browser and may contain anything.
 *
 * @param viewer the sender
 * @param message the message, an object
 */
public record Call(Viewer viewer, JsonNode message) {
  private static final int MAX_CHARACTERS = 4096;

  /**
   * The age in ms from which a clock time is too old. A page gives up later: 4 s after the last
   * answer (see socket.js).
   */
  private static final long MAX_AGE = 3500;

  private static final long START = System.nanoTime();

  /** Returns the time of the clock for commands, in ms. */
  public static long now() {
    return TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - START);
  }

  /**
   * Checks that the page received an answer of this server shortly before it sent the command.
   *
   * @throws CommandException if the command has no clock time, or an old one
   */
  public void checkAge() throws CommandException {
    JsonNode clock = message.path("clock");
    long now = now();
    if (!clock.isIntegralNumber() || !clock.canConvertToLong() || clock.longValue() > now) {
      throw new CommandException("clock must be that of an answer");
    }
    if (clock.longValue() < Math.max(0, now - MAX_AGE)) {
      throw new CommandException(
          "not done: it waited too long, in the network or behind other commands");
    }
  }

  /** Returns the time until {@link #checkAge} refuses the command; negative if it is over. */
  public Duration timeLeft() {
    return Duration.ofMillis(message.path("clock").asLong() + MAX_AGE - now());
  }

  /** Returns whether the page had no answer of this time yet when it sent the command. */
  public boolean isFromBefore(long time) {
    JsonNode clock = message.path("clock");
    return clock.isIntegralNumber() && clock.longValue() < time;
  }

  /** Returns whether the page has cancelled what it sent before. */
  public boolean isWithdrawn() {
    return isFromBefore(viewer.withdrawnAt());
  }

  /** Returns a text of at most 4096 characters. */
  public String text(String field) throws CommandException {
    return text(field, MAX_CHARACTERS);
  }

  /** Returns a text. */
  public String text(String field, int maxCharacters) throws CommandException {
    return text(field, message.get(field), maxCharacters);
  }

  /** Returns a text; empty if the message has none. */
  public Optional<String> optionalText(String field) throws CommandException {
    return message.hasNonNull(field) ? Optional.of(text(field)) : Optional.empty();
  }

  private static String text(String field, @Nullable JsonNode node, int max)
      throws CommandException {
    if (node == null || !node.isTextual()) {
      throw new CommandException(field + " must be a text");
    }
    String text = node.textValue();
    if (text.length() > max) {
      throw new CommandException(
          field + " must have at most " + max + " characters, has " + text.length());
    }
    return text;
  }

  /** Returns a list of texts. */
  public List<String> texts(String field, int max) throws CommandException {
    JsonNode list = message.get(field);
    if (list == null || !list.isArray()) {
      throw new CommandException(field + " must be a list");
    }
    if (list.size() > max) {
      throw new CommandException(field + " must have at most " + max + " elements");
    }
    List<String> texts = new ArrayList<>();
    for (JsonNode element : list) {
      texts.add(text(field, element, MAX_CHARACTERS));
    }
    return texts;
  }

  /** Returns a number within a range. */
  public double number(String field, double min, double max) throws CommandException {
    return number(field, min, max, "");
  }

  /** Returns a whole number of milliseconds within a range; a fraction is cut off. */
  public int millis(String field, int min, int max) throws CommandException {
    return (int) number(field, min, max, " ms");
  }

  /** Returns a number within a range; {@code unit} follows the range in a message. */
  private double number(String field, double min, double max, String unit) throws CommandException {
    JsonNode number = message.get(field);
    if (number == null || !number.isNumber()) {
      throw new CommandException(field + " must be a number");
    }
    double value = number.doubleValue();
    if (!(value >= min && value <= max)) {
      throw new CommandException(
          field
              + (" must be " + text(min) + " to " + text(max) + unit)
              + (", is " + number.asText()));
    }
    return value;
  }

  /** Returns the text of a number, without a fraction if it is whole. */
  private static String text(double number) {
    return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
  }

  /** Returns whether a field is true. */
  public boolean flag(String field) throws CommandException {
    JsonNode flag = message.get(field);
    if (flag == null || !flag.isBoolean()) {
      throw new CommandException(field + " must be true or false");
    }
    return flag.booleanValue();
  }

  /** Returns whether a field is true; false if the message does not have it. */
  public boolean optionalFlag(String field) throws CommandException {
    return message.has(field) && flag(field);
  }
}
