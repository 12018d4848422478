package no.hials.crosscom.web.internal.variables;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.web.internal.socket.CommandException;

/**
 * Variables that are watched together.
 *
 * <p>Its text has one name per line, like the lists of JOpenShowVar 0.2.2. A line that begins with
 * {@code #} is a comment; {@code # period 250 ms} sets the period.
 *
 * @param periodMillis the time between two readings, 20 to 60,000 ms
 * @param names the names of the variables, at most 500
 */
record WatchList(int periodMillis, List<String> names) {
  static final int MIN_PERIOD = 20;
  static final int MAX_PERIOD = 60_000;
  static final int MAX_NAMES = 500;
  private static final int DEFAULT_PERIOD = 250;
  private static final int MAX_CHARACTERS = 255;
  private static final Pattern PERIOD =
      Pattern.compile("#\\s*period\\s+(\\d{1,6})\\s*ms\\s*", Pattern.CASE_INSENSITIVE);

  WatchList {
    names = List.copyOf(names);
  }

  /**
   * Returns a list with these names in capitals, each once.
   *
   * @throws CommandException if a name or their number is not allowed
   */
  static WatchList of(int periodMillis, List<String> names) throws CommandException {
    List<String> all = new ArrayList<>();
    for (String name : names) {
      String key = name.strip().toUpperCase(Locale.ROOT);
      if (key.isEmpty()
          || key.startsWith("#")
          || key.length() > MAX_CHARACTERS
          || key.chars().anyMatch(Character::isISOControl)) {
        throw new CommandException(
            "a name must have 1 to "
                + MAX_CHARACTERS
                + " characters, no control characters, and not begin with #: "
                + shortened(key));
      }
      if (!all.contains(key)) {
        all.add(key);
      }
    }
    if (all.size() > MAX_NAMES) {
      throw new CommandException(
          "a list can have at most " + MAX_NAMES + " variables, has " + all.size());
    }
    if (periodMillis < MIN_PERIOD || periodMillis > MAX_PERIOD) {
      throw new CommandException(
          "the period must be " + MIN_PERIOD + " to " + MAX_PERIOD + " ms, is " + periodMillis);
    }
    return new WatchList(periodMillis, all);
  }

  private static String shortened(String text) {
    String line = text.replaceAll("\\p{Cntrl}", "?");
    return line.length() <= 40 ? line : line.substring(0, 40) + "...";
  }

  /** Returns the list that a text describes. */
  static WatchList parse(String text) throws CommandException {
    int period = DEFAULT_PERIOD;
    List<String> names = new ArrayList<>();
    for (String line : text.replace("\uFEFF", "").lines().toList()) {
      String word = line.strip();
      Matcher comment = PERIOD.matcher(word);
      if (comment.matches()) {
        period = Integer.parseInt(comment.group(1));
      } else if (!word.isEmpty() && !word.startsWith("#")) {
        names.add(word);
      }
    }
    return of(period, names);
  }

  /** Returns the text that {@link #parse} reads. */
  String text() {
    StringBuilder text = new StringBuilder("# period " + periodMillis + " ms\n");
    names.forEach(name -> text.append(name).append('\n'));
    return text.toString();
  }
}
