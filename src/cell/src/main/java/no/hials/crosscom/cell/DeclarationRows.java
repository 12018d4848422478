package no.hials.crosscom.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import org.jspecify.annotations.Nullable;

/** Lists the declarations of a data list as flat rows. */
public final class DeclarationRows {
  private DeclarationRows() {}

  /**
   * A declaration, or the initial value of an element or a field.
   *
   * @param name the name with its dimensions, such as {@code MYPOSITIONS[50]}
   * @param type the name of its type; STRUC and ENUM for types, SIGNAL for signals; empty for an
   *     initial value
   * @param value the initial value, or the parts of a type; empty without a value
   * @param words GLOBAL and CONST if present
   * @param line the line of the declaration
   * @param comment the comment on the line
   */
  public record Row(
      String name, String type, String value, List<String> words, int line, String comment) {}

  public static List<Row> of(DataList list) {
    List<Row> rows = new ArrayList<>();
    for (Declaration declaration : list.declarations()) {
      if (declaration instanceof Declaration.Variables group) {
        group.variables().forEach(variable -> rows.add(variable(group, variable)));
      } else {
        rows.add(other(declaration));
      }
    }
    return rows;
  }

  private static Row variable(Declaration.Variables group, Declaration.Declarator variable) {
    List<String> words = words(group.global());
    if (group.constant()) {
      words.add("CONST");
    }
    return new Row(
        declarator(variable),
        group.type().toUpperCase(Locale.ROOT),
        text(variable.initial()),
        words,
        variable.position().line(),
        group.comment().strip());
  }

  private static Row other(Declaration declaration) {
    int line = declaration.position().line();
    if (declaration instanceof Declaration.InitialValue initial) {
      return new Row(
          ExpressionText.of(initial.target()),
          "",
          ExpressionText.of(initial.value()),
          List.of(),
          line,
          initial.comment().strip());
    } else if (declaration instanceof Declaration.StrucDeclaration struc) {
      String parts =
          struc.components().stream()
              .map(part -> part.type() + " " + declarator(part.declarator()))
              .collect(Collectors.joining(", "));
      return new Row(
          struc.name(), "STRUC", parts, words(struc.global()), line, struc.comment().strip());
    } else if (declaration instanceof Declaration.EnumDeclaration enumeration) {
      return new Row(
          enumeration.name(),
          "ENUM",
          "#" + String.join(", #", enumeration.constants()),
          words(enumeration.global()),
          line,
          enumeration.comment().strip());
    } else if (declaration instanceof Declaration.Signal signal) {
      String wire = text(signal.first());
      String last = signal.last() == null ? "" : " TO " + text(signal.last());
      return new Row(
          signal.name(),
          "SIGNAL",
          wire.isEmpty() ? "FALSE" : wire + last,
          words(signal.global()),
          line,
          signal.comment().strip());
    } else if (declaration instanceof Declaration.External external) {
      return new Row(external.name(), "EXTERNAL", external.source(), List.of(), line, "");
    }
    throw new IllegalArgumentException("unknown declaration: " + declaration);
  }

  private static List<String> words(boolean global) {
    List<String> words = new ArrayList<>();
    if (global) {
      words.add("GLOBAL");
    }
    return words;
  }

  private static String declarator(Declaration.Declarator declarator) {
    if (declarator.dimensions().isEmpty()) {
      return declarator.name();
    }
    return declarator.dimensions().stream()
        .map(DeclarationRows::text)
        .collect(Collectors.joining(",", declarator.name() + "[", "]"));
  }

  private static String text(@Nullable Expression expression) {
    return expression == null ? "" : ExpressionText.of(expression);
  }
}
