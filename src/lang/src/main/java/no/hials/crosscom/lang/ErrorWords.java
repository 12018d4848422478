package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.lang.Expression.BinaryOperator;
import no.hials.crosscom.lang.Expression.UnaryOperator;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.IntervalSet;

/** Describes in KRL's words what the parser expected and what it found. */
final class ErrorWords {
  /** The operators, whose tokens have their names; {@code +} and {@code -} are also signs. */
  private static final Set<Integer> OPERATORS =
      IntStream.rangeClosed(1, KrlGrammarParser.VOCABULARY.getMaxTokenType())
          .filter(type -> type == KrlGrammarParser.COLON || isOperator(tokenName(type)))
          .boxed()
          .collect(Collectors.toSet());

  private static final BitSet OPERATOR_BITS = new BitSet();

  static {
    OPERATORS.forEach(OPERATOR_BITS::set);
  }

  private static final Set<Integer> NAMES = firstTokens(KrlGrammarParser.RULE_name);

  /** The tokens that can begin a value. */
  private static final Set<Integer> VALUES = firstTokens(KrlGrammarParser.RULE_primary);

  /** The tokens that can follow any name. */
  private static final Set<Integer> CONTINUATIONS =
      Set.of(
          KrlGrammarParser.DOT, KrlGrammarParser.LEFT_BRACKET, KrlGrammarParser.LEFT_PARENTHESIS);

  private static final int MAX_LENGTH = 40;

  private ErrorWords() {}

  static boolean isOperator(Token token) {
    return token.getType() > 0 && OPERATOR_BITS.get(token.getType());
  }

  private static boolean isOperator(String name) {
    return Stream.of(BinaryOperator.values(), UnaryOperator.values())
        .flatMap(Stream::of)
        .anyMatch(operator -> operator.name().equals(name));
  }

  private static Set<Integer> firstTokens(int rule) {
    return KrlGrammarParser._ATN.nextTokens(KrlGrammarParser._ATN.ruleToStartState[rule]).toSet();
  }

  /** Returns the name of a token in the grammar. */
  static String tokenName(int type) {
    return KrlGrammarParser.VOCABULARY.getSymbolicName(type);
  }

  /** Reports the error that ended the parse of a line. */
  static void report(RecognitionException e, Line line, Errors errors) {
    Token found = e.getOffendingToken();
    int type = found.getType();
    if (type == KrlGrammarParser.OPEN_TEXT) {
      errors.add(found, "expected \" at the end of the text, found the end of the line");
    } else if (type == KrlGrammarParser.WRONG_BITS) {
      errors.add(
          found, "expected 'B' and binary or 'H' and hexadecimal digits, found " + found(found));
    } else if (found == line.first()) {
      errors.add(found, "expected a statement or a declaration, found " + found(found));
    } else {
      errors.add(
          place(found, line, errors),
          "expected " + expected(e.getExpectedTokens()) + ", found " + found(found));
    }
  }

  /** Reports an unknown statement. */
  static void reportUnknown(Line line, Errors errors) {
    String hint =
        isName(line.second())
            ? "; a type needs DECL before it"
            : ": expected = or ( after it, found " + found(line.second());
    errors.add(line.first(), "unknown statement " + found(line.first()) + hint);
  }

  /** Reports a statement that is not supported. */
  static void reportUnsupported(Line line, Errors errors) {
    errors.add(line.keyword(), upper(line.keyword()) + " is not supported");
  }

  static boolean isName(Token token) {
    return NAMES.contains(token.getType());
  }

  /** Returns the position of a token; the end of a line is right after its last token. */
  private static Position place(Token token, Line line, Errors errors) {
    int index = line.tokens().indexOf(token);
    if (index != line.tokens().size() - 1) {
      return errors.at(token);
    }
    Token last = line.tokens().get(index - 1);
    Position position = errors.at(last);
    return new Position(
        position.file(), position.line(), position.column() + last.getText().length());
  }

  static String found(Token token) {
    return switch (token.getType()) {
      case Token.EOF -> "the end of the file";
      case KrlGrammarParser.NEWLINE -> "the end of the line";
      case KrlGrammarParser.UNKNOWN -> character(token.getText().codePointAt(0));
      default -> shorten(token.getText());
    };
  }

  static String upper(Token token) {
    return token.getText().toUpperCase(Locale.ROOT);
  }

  /** Shortens text from the file, to keep messages readable. */
  static String shorten(String text) {
    return text.length() > MAX_LENGTH ? text.substring(0, MAX_LENGTH) + "..." : text;
  }

  private static String character(int code) {
    return Character.isISOControl(code)
            || !Character.isDefined(code)
            || Character.isWhitespace(code)
        ? String.format(Locale.ROOT, "the character U+%04X", code)
        : "the character " + Character.toString(code);
  }

  private static String expected(IntervalSet tokens) {
    Set<Integer> left = new TreeSet<>(tokens.toSet());
    List<String> words = new ArrayList<>();
    left.remove(Token.EOF);
    if (left.contains(KrlGrammarParser.STRUC)) {
      return "a declaration";
    }
    if (left.contains(KrlGrammarParser.INT)) {
      words.add("a value");
      left.removeAll(VALUES);
      left.removeAll(OPERATORS);
    } else if (left.contains(KrlGrammarParser.MULTIPLY)) {
      left.removeAll(OPERATORS);
    }
    if (left.contains(KrlGrammarParser.NAME)) {
      words.add("a name");
      left.removeAll(NAMES);
    }
    if (!CONTINUATIONS.containsAll(left)) {
      boolean orCall =
          left.contains(KrlGrammarParser.ASSIGN)
              && left.contains(KrlGrammarParser.LEFT_PARENTHESIS);
      left.removeAll(CONTINUATIONS);
      if (orCall) {
        left.add(KrlGrammarParser.LEFT_PARENTHESIS);
      }
    }
    left.forEach(type -> words.add(word(type)));
    return join(words);
  }

  private static String word(int type) {
    return switch (type) {
      case KrlGrammarParser.NEWLINE -> "the end of the line";
      case KrlGrammarParser.COMMA -> "a comma";
      case KrlGrammarParser.ENUM_VALUE -> "#BASE, #TOOL";
      default -> keyword(type);
    };
  }

  static String keyword(int type) {
    return KrlGrammarParser.VOCABULARY.getDisplayName(type).replace("'", "");
  }

  private static String join(List<String> words) {
    int last = words.size() - 1;
    return last == 0
        ? words.get(0)
        : String.join(", ", words.subList(0, last)) + " or " + words.get(last);
  }
}
