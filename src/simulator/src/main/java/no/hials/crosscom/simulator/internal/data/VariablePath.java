package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;

/**
 * The name of a variable or of a part of it, as clients send it: {@code LOAD_DATA[1].CM.X} has
 * three steps.
 *
 * @param steps at least one
 */
public record VariablePath(List<PathStep> steps) {
  /** The maximum number of dimensions (docs/reference/krl-values.md#arrays). */
  private static final int MAX_DIMENSIONS = 3;

  private static final int MAX_INDEX_DIGITS = 9;

  /**
   * A name with or without an index.
   *
   * @param name in upper case, because KRL ignores case (docs/reference/krl-values.md#names)
   * @param index the index after it
   */
  public record PathStep(String name, Index index) {}

  /** Returns the first step, which names the variable. */
  public PathStep first() {
    return steps.get(0);
  }

  /** Returns whether a step, counted from 0, is the last. */
  public boolean isLast(int step) {
    return step == steps.size() - 1;
  }

  /** Returns the path of an element of an array. The index starts at 1. */
  public static VariablePath element(String array, int index) {
    return new VariablePath(
        List.of(new PathStep(array.toUpperCase(Locale.ROOT), new Index(new int[] {index}, false))));
  }

  /**
   * Returns the path of a part of the part at this path.
   *
   * @param inner the path in that part; its first name is ignored
   */
  public VariablePath then(VariablePath inner) {
    if (inner.steps.size() == 1 && inner.first().index().isNone()) {
      return this;
    }
    int last = steps.size() - 1;
    List<PathStep> all = new ArrayList<>(steps.subList(0, last));
    all.add(
        new PathStep(steps.get(last).name(), steps.get(last).index().then(inner.first().index())));
    all.addAll(inner.steps.subList(1, inner.steps.size()));
    return new VariablePath(all);
  }

  /**
   * Parses a name such as {@code LOAD_DATA[1].CM.X}.
   *
   * @throws RefusedException if it is not a name
   */
  public static VariablePath parse(String text) throws RefusedException {
    return new Parser(text.strip()).path();
  }

  /** Returns the value of an index. */
  @FunctionalInterface
  public interface IndexValue<E extends Exception> {
    int of(Expression index) throws E;
  }

  /** Returns the path of an expression. */
  public static <E extends Exception> VariablePath of(
      Expression.Variable variable, IndexValue<E> value) throws E {
    List<PathStep> steps = new ArrayList<>(variable.steps().size());
    for (Expression.Step step : variable.steps()) {
      int[] numbers = new int[step.indices().size()];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = value.of(step.indices().get(i));
      }
      steps.add(new PathStep(Scope.key(step.name()), new Index(numbers, step.open())));
    }
    return new VariablePath(List.copyOf(steps));
  }

  /** Returns the path of a whole variable. */
  public static VariablePath of(String name) {
    return new VariablePath(List.of(new PathStep(name.toUpperCase(Locale.ROOT), Index.NONE)));
  }

  /** Returns this path without {@code []} at its end. */
  public VariablePath withoutBrackets() {
    PathStep last = steps.get(steps.size() - 1);
    if (!last.index().isWhole()) {
      return this;
    }
    List<PathStep> all = new ArrayList<>(steps.subList(0, steps.size() - 1));
    all.add(new PathStep(last.name(), Index.NONE));
    return new VariablePath(all);
  }

  /** Returns this path of an array with {@code []} after it. */
  public VariablePath whole() {
    return then(new VariablePath(List.of(new PathStep(first().name(), Index.WHOLE))));
  }

  @Override
  public String toString() {
    StringBuilder out = new StringBuilder();
    for (PathStep step : steps) {
      out.append(out.length() > 0 ? "." : "").append(step.name()).append(step.index());
    }
    return out.toString();
  }

  /** Returns whether a text is a name of KRL. */
  public static boolean isName(String text) {
    if (text.isEmpty() || !isNameStart(text.charAt(0))) {
      return false;
    }
    for (int i = 1; i < text.length(); i++) {
      if (!isNamePart(text.charAt(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean isNameStart(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$';
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }

  private static boolean isNamePart(char c) {
    return isNameStart(c) || isDigit(c);
  }

  /** Parses a name from left to right. */
  private static final class Parser {
    private final String text;
    private int pos;

    Parser(String text) {
      this.text = text;
    }

    VariablePath path() throws RefusedException {
      PathStep first = step();
      if (pos == text.length()) {
        return new VariablePath(List.of(first));
      }
      List<PathStep> steps = new ArrayList<>();
      steps.add(first);
      while (pos < text.length()) {
        if (text.charAt(pos) != '.') {
          throw noName();
        }
        pos++;
        steps.add(step());
      }
      return new VariablePath(steps);
    }

    private RefusedException noName() {
      return new RefusedException(Refusal.UNKNOWN_VARIABLE, "'" + text + "' is not a name");
    }

    private PathStep step() throws RefusedException {
      int start = pos;
      while (pos < text.length() && isNamePart(text.charAt(pos))) {
        pos++;
      }
      if (start == pos || !isNameStart(text.charAt(start))) {
        throw noName();
      }
      String name = text.substring(start, pos).toUpperCase(Locale.ROOT);
      boolean bracket = pos < text.length() && text.charAt(pos) == '[';
      return new PathStep(name, bracket ? index() : Index.NONE);
    }

    private Index index() throws RefusedException {
      pos++;
      int[] numbers = new int[MAX_DIMENSIONS];
      int count = 0;
      while (true) {
        skipBlanks();
        if (pos < text.length() && text.charAt(pos) == ']') {
          pos++;
          return new Index(Arrays.copyOf(numbers, count), true);
        }
        if (count == MAX_DIMENSIONS) {
          throw noName();
        }
        numbers[count++] = number();
        skipBlanks();
        if (pos == text.length()) {
          throw noName();
        }
        char c = text.charAt(pos++);
        if (c == ']') {
          return new Index(Arrays.copyOf(numbers, count), false);
        }
        if (c != ',') {
          throw noName();
        }
      }
    }

    private int number() throws RefusedException {
      int start = pos;
      int value = 0;
      while (pos < text.length() && isDigit(text.charAt(pos))) {
        if (pos - start == MAX_INDEX_DIGITS) {
          throw new RefusedException(Refusal.BAD_INDEX, "index too large in " + text);
        }
        value = value * 10 + (text.charAt(pos) - '0');
        pos++;
      }
      if (pos == start) {
        throw noName();
      }
      return value;
    }

    private void skipBlanks() {
      while (pos < text.length() && text.charAt(pos) == ' ') {
        pos++;
      }
    }
  }
}
