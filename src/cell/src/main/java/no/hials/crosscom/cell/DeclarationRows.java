package no.hials.crosscom.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.DeclarationVisitor;
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
    Lister lister = new Lister();
    return list.declarations().stream().flatMap(each -> each.accept(lister)).toList();
  }

  /** Lists one declaration. */
  private static final class Lister implements DeclarationVisitor<Stream<Row>> {
    @Override
    public Stream<Row> visit(Declaration.Variables group) {
      return group.variables().stream().map(variable -> variable(group, variable));
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

    @Override
    public Stream<Row> visit(Declaration.InitialValue initial) {
      return row(
          initial,
          ExpressionText.of(initial.target()),
          "",
          ExpressionText.of(initial.value()),
          false,
          initial.comment());
    }

    @Override
    public Stream<Row> visit(Declaration.StrucDeclaration struc) {
      String parts =
          struc.components().stream()
              .map(part -> part.type() + " " + declarator(part.declarator()))
              .collect(Collectors.joining(", "));
      return row(struc, struc.name(), "STRUC", parts, struc.global(), struc.comment());
    }

    @Override
    public Stream<Row> visit(Declaration.EnumDeclaration enumeration) {
      String constants = "#" + String.join(", #", enumeration.constants());
      return row(
          enumeration,
          enumeration.name(),
          "ENUM",
          constants,
          enumeration.global(),
          enumeration.comment());
    }

    @Override
    public Stream<Row> visit(Declaration.Signal signal) {
      String wire = text(signal.first());
      String last = signal.last() == null ? "" : " TO " + text(signal.last());
      String wires = wire.isEmpty() ? "FALSE" : wire + last;
      return row(signal, signal.name(), "SIGNAL", wires, signal.global(), signal.comment());
    }

    @Override
    public Stream<Row> visit(Declaration.Channel channel) {
      String settings = ExpressionText.of(channel.settings());
      return row(channel, channel.name(), "CHANNEL", settings, false, channel.comment());
    }

    @Override
    public Stream<Row> visit(Declaration.External external) {
      return row(external, external.name(), "EXTERNAL", external.source(), false, "");
    }

    private static Stream<Row> row(
        Declaration declaration,
        String name,
        String type,
        String value,
        boolean global,
        String comment) {
      int line = declaration.position().line();
      return Stream.of(new Row(name, type, value, words(global), line, comment.strip()));
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
          .map(Lister::text)
          .collect(Collectors.joining(",", declarator.name() + "[", "]"));
    }

    private static String text(@Nullable Expression expression) {
      return expression == null ? "" : ExpressionText.of(expression);
    }
  }
}
