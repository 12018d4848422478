package no.hials.crosscom.lang;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Parses lines, and prints trees without positions, to be readable. */
final class Snippets {
  static final String FILE = "T.SRC";

  private Snippets() {}

  /** Parses lines as the contents of {@code DEF T()}, which is line 1. */
  static ParseResult routine(String lines) {
    return KrlParser.parse(FILE, "DEF T()\n" + lines + "\nEND\n");
  }

  /** Parses lines as the contents of {@code DEFDAT T}, which is line 1. */
  static ParseResult dataList(String lines) {
    return KrlParser.parse(FILE, "DEFDAT T\n" + lines + "\nENDDAT\n");
  }

  static Routine onlyRoutine(ParseResult result) {
    if (!result.errors().isEmpty()) {
      throw new AssertionError(result.errors());
    }
    return ((SourceFile) result.file().orElseThrow()).routines().get(0);
  }

  static List<Statement> statements(String lines) {
    return onlyRoutine(routine(lines)).body();
  }

  static List<Declaration> declarations(ParseResult result) {
    if (!result.errors().isEmpty()) {
      throw new AssertionError(result.errors());
    }
    return ((DataList) result.file().orElseThrow()).declarations();
  }

  static Expression expression(String text) {
    return ((Statement.AssignmentStatement) statements("T=" + text).get(0)).value();
  }

  /** Returns the errors as {@code line:column message}. */
  static List<String> errors(ParseResult result) {
    return result.errors().stream()
        .map(e -> e.position().line() + ":" + e.position().column() + " " + e.message())
        .toList();
  }

  /** Prints a tree: {@code AssignmentStatement(A, (B PLUS 1))}. */
  static String show(Object node) {
    if (node == null) {
      return "-";
    } else if (node instanceof Expression.Binary b) {
      return "(" + show(b.left()) + " " + b.operator() + " " + show(b.right()) + ")";
    } else if (node instanceof Expression.Unary u) {
      return "(" + u.operator() + " " + show(u.operand()) + ")";
    } else if (node instanceof Expression.Variable v) {
      return v.steps().stream().map(Snippets::show).collect(Collectors.joining("."));
    } else if (node instanceof Expression.Step s) {
      return s.name() + (s.brackets() ? list(s.indices()) + (s.open() ? "+open" : "") : "");
    } else if (node instanceof Expression.FunctionCall c) {
      return c.name() + "(" + inside(c.arguments()) + ")";
    } else if (node instanceof Expression.EnumLiteral e) {
      return "#" + e.name();
    } else if (node instanceof Expression.ChannelLiteral c) {
      return ":" + c.name();
    } else if (node instanceof Expression.TextLiteral t) {
      return "\"" + t.text() + "\"";
    } else if (node instanceof Expression.Aggregate a) {
      return "{" + (a.type() == null ? "" : a.type() + ": ") + inside(a.fields()) + "}";
    } else if (node instanceof Expression.AggregateField f) {
      return f.name() + " " + show(f.value());
    } else if (node instanceof Expression.IntLiteral i) {
      return Integer.toString(i.value());
    } else if (node instanceof Expression.RealLiteral r) {
      return Double.toString(r.value());
    } else if (node instanceof Expression.BoolLiteral b) {
      return Boolean.toString(b.value());
    } else if (node instanceof Collection<?> c) {
      return list(c);
    } else if (node instanceof Record r) {
      return r.getClass().getSimpleName() + "(" + inside(components(r)) + ")";
    }
    return node.toString();
  }

  private static String list(Collection<?> nodes) {
    return "[" + inside(nodes) + "]";
  }

  private static String inside(Collection<?> nodes) {
    return nodes.stream().map(Snippets::show).collect(Collectors.joining(", "));
  }

  private static List<Object> components(Record node) {
    List<Object> values = new ArrayList<>();
    for (RecordComponent component : node.getClass().getRecordComponents()) {
      if (component.getType() != Position.class && component.getType() != Map.class) {
        try {
          values.add(component.getAccessor().invoke(node));
        } catch (ReflectiveOperationException e) {
          throw new LinkageError(e.getMessage(), e);
        }
      }
    }
    return values;
  }
}
