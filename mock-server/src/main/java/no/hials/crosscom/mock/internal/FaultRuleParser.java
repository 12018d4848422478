package no.hials.crosscom.mock.internal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.FaultRule;
import no.hials.crosscom.protocol.Tail;
import org.jspecify.annotations.Nullable;

/** Parses the text form of one {@link FaultRule}. */
public final class FaultRuleParser {
  /** The faults without an argument; the others are in {@link #fault}. */
  private static final Map<String, Fault> PLAIN =
      Stream.of(Fault.Simple.values())
          .collect(
              Collectors.toMap(
                  fault -> fault.name().replace("_", "").toLowerCase(Locale.ROOT), fault -> fault));

  private static final String NAMES =
      "none, raw, answer, failure, emptyAnswer, drop, dropAnswer, closeBefore, resetBefore,"
          + " closeDuring, closeAfter, delay, split, oneByteAtATime, answerTwice, glueToNext,"
          + " wrongId, wrongFunction, wrongLength, truncate or garbage";

  /** A length beyond any answer. */
  private static final int MANY = 1_000_000;

  private static final Pattern NUMBER = Pattern.compile("[+-]?\\d{1,9}");
  private static final Pattern NUMBERS = Pattern.compile("(\\d{1,18})(?:(-)(\\d{1,18})?)?");
  private static final Pattern VARIABLE = Pattern.compile("[$_A-Za-z][^\\s@%]*");
  private static final Pattern PROBABILITY = Pattern.compile("\\d(\\.\\d{1,17})?|\\.\\d{1,17}");

  private final String text;
  private final long seed;
  private int position;

  /** Creates the parser of a text. */
  public FaultRuleParser(String text, long seed) {
    this.text = text;
    // so that two rules with the same seed do not choose the same requests
    this.seed = seed ^ text.hashCode();
  }

  /**
   * A piece of the text.
   *
   * @param text without the backslashes
   * @param start the index of its first character
   */
  private record Argument(String text, int start) {}

  /** Parses the text, once. */
  public FaultRule parse() {
    Argument name = until(":@%");
    Argument argument = at(':') ? until("@%") : null;
    Fault plain = PLAIN.get(name.text().toLowerCase(Locale.ROOT));
    if (plain != null && argument != null) {
      throw error(argument.start(), "no argument of " + name.text(), argument.text());
    }
    FaultRule rule = FaultRule.of(plain != null ? plain : fault(name, argument));
    boolean numbered = false;
    while (at('@')) {
      Argument where = until("@%");
      boolean number = !where.text().isEmpty() && Character.isDigit(where.text().charAt(0));
      if (number ? numbered : !rule.variable().isEmpty()) {
        throw error(where.start(), "one @NUMBERS and one @NAME at most", where.text());
      }
      numbered |= number;
      rule = number ? onRequests(rule, where) : onVariable(rule, where);
    }
    if (at('%')) {
      rule = withProbability(rule, until(""));
    }
    return rule;
  }

  // the parts

  /** Skips a sign if it is next. */
  private boolean at(char sign) {
    boolean there = position < text.length() && text.charAt(position) == sign;
    if (there) {
      position++;
    }
    return there;
  }

  /** Returns the text up to the next of these signs. A backslash escapes a sign. */
  private Argument until(String signs) {
    int start = position;
    StringBuilder taken = new StringBuilder();
    while (position < text.length() && signs.indexOf(text.charAt(position)) < 0) {
      if (text.charAt(position) == '\\' && position + 1 < text.length()) {
        position++;
      }
      taken.append(text.charAt(position));
      position++;
    }
    return new Argument(taken.toString(), start);
  }

  private FaultRule onRequests(FaultRule rule, Argument where) {
    Matcher matcher = NUMBERS.matcher(where.text());
    if (matcher.matches()) {
      long first = Long.parseLong(matcher.group(1));
      long last = first;
      if (matcher.group(2) != null) {
        last = matcher.group(3) == null ? Long.MAX_VALUE : Long.parseLong(matcher.group(3));
      }
      if (first >= 1 && last >= first) {
        return rule.onRequests(first, last);
      }
    }
    throw error(where.start(), "a number from 1, FIRST-LAST or FIRST-", where.text());
  }

  private FaultRule onVariable(FaultRule rule, Argument where) {
    if (!VARIABLE.matcher(where.text()).matches()) {
      throw error(where.start(), "a request's number or a variable's name", where.text());
    }
    return rule.onVariable(where.text());
  }

  private FaultRule withProbability(FaultRule rule, Argument chance) {
    if (PROBABILITY.matcher(chance.text()).matches()) {
      double probability = Double.parseDouble(chance.text());
      if (probability <= 1) {
        return rule.withProbability(probability, seed);
      }
    }
    throw error(chance.start(), "a probability from 0 to 1", chance.text());
  }

  // the faults with an argument

  private Fault fault(Argument name, @Nullable Argument given) {
    Argument argument = given == null ? new Argument("", position) : given;
    return switch (name.text().toLowerCase(Locale.ROOT)) {
      case "raw" -> raw(argument);
      case "answer" -> {
        if (given == null) {
          throw error(position, ":VALUE", "");
        }
        yield answer(argument, Tail.SUCCESS);
      }
      case "failure" -> answer(argument, Tail.FAILURE);
      case "closeduring" -> Fault.closeDuring(number(argument, 0, MANY));
      case "delay" -> Fault.delay(time(argument));
      case "split" -> split(argument);
      case "onebyteatatime" ->
          given == null ? Fault.oneByteAtATime() : Fault.oneByteAtATime(time(argument));
      case "wrongid" -> given == null ? Fault.wrongId() : new Fault.WrongId(difference(argument));
      case "wrongfunction" -> Fault.wrongFunction(number(argument, 0, 0xFF));
      case "wronglength" -> Fault.wrongLength(difference(argument));
      case "truncate" -> Fault.truncate(number(argument, 0, MANY));
      case "garbage" -> Fault.garbage(seed, number(argument, 0, MANY));
      default -> throw error(name.start(), NAMES, name.text());
    };
  }

  private Fault raw(Argument argument) {
    try {
      String[] segments = argument.text().split(",", -1);
      if (Arrays.stream(segments).noneMatch(String::isBlank)) {
        return Fault.raw(segments);
      }
    } catch (IllegalArgumentException e) {
      // reported below
    }
    throw error(argument.start(), "pairs of hexadecimal digits", argument.text());
  }

  private Fault answer(Argument argument, Tail tail) {
    try {
      return Fault.answer(argument.text(), tail);
    } catch (IllegalArgumentException e) {
      throw error(argument.start(), String.valueOf(e.getMessage()), argument.text());
    }
  }

  private Fault split(Argument argument) {
    List<Integer> sizes = new ArrayList<>();
    Duration pause = Duration.ZERO;
    String[] items = argument.text().split(",", -1);
    int start = argument.start();
    for (int i = 0; i < items.length; i++) {
      Optional<Duration> time = DurationParser.parse(items[i]);
      boolean isSize = NUMBER.matcher(items[i]).matches(); // not a time without its unit
      if (i > 0 && i == items.length - 1 && time.isPresent() && !isSize) {
        pause = time.get();
      } else {
        sizes.add(number(new Argument(items[i], start), 1, MANY));
      }
      start += items[i].length() + 1;
    }
    return new Fault.Split(sizes, pause);
  }

  private int difference(Argument argument) {
    return number(argument, -0xFFFF, 0xFFFF);
  }

  private int number(Argument argument, int min, int max) {
    if (NUMBER.matcher(argument.text()).matches()) {
      int number = Integer.parseInt(argument.text());
      if (number >= min && number <= max) {
        return number;
      }
    }
    throw error(argument.start(), "a number from " + min + " to " + max, argument.text());
  }

  private Duration time(Argument argument) {
    return DurationParser.parse(argument.text())
        .orElseThrow(
            () ->
                error(
                    argument.start(),
                    "a time up to an hour such as 200us, 1.5ms or 2s",
                    argument.text()));
  }

  private IllegalArgumentException error(int at, String expected, String found) {
    return new IllegalArgumentException(
        "fault '%s', column %d: expected %s, found %s"
            .formatted(text, at + 1, expected, found.isEmpty() ? "nothing" : "'" + found + "'"));
  }
}
