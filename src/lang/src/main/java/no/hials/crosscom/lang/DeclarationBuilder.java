package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Declaration.Component;
import no.hials.crosscom.lang.Declaration.Declarator;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BracketsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ChannelContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ComponentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.DeclaratorContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.DefinitionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.EnumerationContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ImportedContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ModifierContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NameContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NamedContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ParameterContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ParametersContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.SignalContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.StrucContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.VariableContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Builds the records of declarations. */
final class DeclarationBuilder {
  /** The maximum length of a name (docs/reference/krl-values.md#names). */
  private static final int MAX_NAME = 24;

  private final Errors errors;
  private final ExpressionBuilder expressions;
  private final boolean dataList;
  private final int maxName;

  /**
   * @param dataList whether initial values are allowed
   */
  DeclarationBuilder(Errors errors, ExpressionBuilder expressions, boolean dataList) {
    this(errors, expressions, dataList, MAX_NAME);
  }

  /**
   * @param dataList whether initial values are allowed
   * @param maxName the maximum length of a name
   */
  DeclarationBuilder(Errors errors, ExpressionBuilder expressions, boolean dataList, int maxName) {
    this.errors = errors;
    this.expressions = expressions;
    this.dataList = dataList;
    this.maxName = maxName;
  }

  /** Returns the declaration on a line, or null if it is something else. */
  @Nullable Declaration build(ContentContext content, String comment) {
    if (content.variables() != null) {
      return variables(
          content, content.variables().name(), content.variables().declarator(), comment);
    }
    NamedContext named = content.named();
    if (named != null && !named.declarator().isEmpty()) {
      return variables(content, named.name(), named.declarator(), comment);
    }
    return content.definition() == null ? null : definition(content, content.definition(), comment);
  }

  private @Nullable Declaration definition(
      ContentContext content, DefinitionContext definition, String comment) {
    if (definition.struc() != null) {
      return struc(content, definition.struc(), comment);
    }
    if (definition.enumeration() != null) {
      return enumeration(content, definition.enumeration(), comment);
    }
    if (definition.signal() != null) {
      return signal(content, definition.signal(), comment);
    }
    if (definition.channel() != null) {
      return channel(content, definition.channel(), comment);
    }
    return external(content, definition);
  }

  private @Nullable Declaration external(ContentContext content, DefinitionContext definition) {
    NameContext name;
    String source = "";
    if (definition.external() != null) {
      name = definition.external().name();
      parameters(definition.external().parameters());
    } else if (definition.externalFunction() != null) {
      name = definition.externalFunction().name(1);
      parameters(definition.externalFunction().parameters());
    } else if (definition.imported() != null) {
      ImportedContext imported = definition.imported();
      name = imported.name(1);
      source = imported.importPath().getText();
    } else {
      return null;
    }
    return new Declaration.External(begin(content, false, false), declared(name), source);
  }

  private Declaration variables(
      ContentContext content,
      NameContext type,
      List<DeclaratorContext> declarators,
      String comment) {
    Position position = begin(content, true, true);
    boolean constant = has(content, KrlGrammarParser.CONST);
    List<Declarator> variables = new ArrayList<>();
    for (DeclaratorContext declarator : declarators) {
      variables.add(declarator(declarator));
    }
    return new Declaration.Variables(
        position, isGlobal(content), constant, type.getText(), List.copyOf(variables), comment);
  }

  private Declarator declarator(DeclaratorContext context) {
    Expression initial = expressions.buildOptional(context.expression());
    if (initial != null && !dataList) {
      errors.note(
          errors.at(context.ASSIGN().getSymbol()),
          "an initial value is allowed only in a data list");
    }
    return new Declarator(
        expressions.at(context),
        declared(context.name()),
        expressions.dimensions(context.brackets()),
        initial);
  }

  private Declaration struc(ContentContext content, StrucContext struc, String comment) {
    Position position = begin(content, true, false);
    String name = declared(struc.name());
    List<Component> components = new ArrayList<>();
    String type = "";
    for (ComponentContext context : struc.component()) {
      if (context.name().size() == 2) {
        type = context.name(0).getText();
      } else if (components.isEmpty()) {
        errors.add(context.getStart(), "expected a type and a name, found " + context.getText());
      }
      NameContext component = context.name(context.name().size() - 1);
      components.add(
          new Component(
              type,
              new Declarator(
                  expressions.at(component),
                  declared(component),
                  expressions.dimensions(context.brackets()),
                  null)));
    }
    return new Declaration.StrucDeclaration(
        position, isGlobal(content), name, List.copyOf(components), comment);
  }

  private Declaration enumeration(
      ContentContext content, EnumerationContext enumeration, String comment) {
    Position position = begin(content, true, false);
    List<String> names = enumeration.name().stream().map(this::declared).toList();
    return new Declaration.EnumDeclaration(
        position, isGlobal(content), names.get(0), names.subList(1, names.size()), comment);
  }

  private Declaration signal(ContentContext content, SignalContext signal, String comment) {
    Position position = begin(content, true, false);
    List<VariableContext> ends = signal.variable();
    return new Declaration.Signal(
        position,
        isGlobal(content),
        declared(signal.name()),
        ends.isEmpty() ? null : expressions.variable(ends.get(0)),
        ends.size() < 2 ? null : expressions.variable(ends.get(1)),
        comment);
  }

  private Declaration channel(ContentContext content, ChannelContext channel, String comment) {
    return new Declaration.Channel(
        begin(content, true, false),
        declared(channel.name(0)),
        channel.name(1).getText(),
        expressions.variable(channel.variable()),
        comment);
  }

  List<Routine.Parameter> parameters(ParametersContext context) {
    List<Routine.Parameter> parameters = new ArrayList<>();
    for (ParameterContext parameter : context.parameter()) {
      parameters.add(
          new Routine.Parameter(
              expressions.at(parameter),
              declared(parameter.name()),
              openDimensions(parameter.brackets()),
              parameter.IN() == null));
    }
    return List.copyOf(parameters);
  }

  /** Returns the number of dimensions in the brackets of a parameter; all must be open. */
  private int openDimensions(@Nullable BracketsContext brackets) {
    List<@Nullable Expression> dimensions = expressions.dimensions(brackets);
    for (@Nullable Expression dimension : dimensions) {
      if (dimension != null) {
        errors.add(
            dimension.position(), "the dimensions of a parameter must be open, as in NAME[]");
      }
    }
    return dimensions.size();
  }

  /** Returns a declared name, and reports a name that is too long. */
  String declared(NameContext context) {
    String name = context.getText();
    if (name.length() > maxName) {
      errors.note(
          errors.at(context.getStart()),
          "a name has at most "
              + maxName
              + " characters, "
              + ErrorWords.shorten(name)
              + " has "
              + name.length());
    }
    return name;
  }

  static boolean isGlobal(ContentContext content) {
    return has(content, KrlGrammarParser.GLOBAL);
  }

  private static boolean has(ContentContext content, int modifier) {
    return content.modifier().stream().anyMatch(m -> m.getStart().getType() == modifier);
  }

  /**
   * Returns the position of a line, and reports modifiers that are not allowed before it.
   *
   * @param decl whether {@code DECL} is allowed
   * @param constant whether {@code CONST} is allowed
   */
  Position begin(ContentContext content, boolean decl, boolean constant) {
    List<Integer> seen = new ArrayList<>();
    for (ModifierContext modifier : content.modifier()) {
      Token token = modifier.getStart();
      int type = token.getType();
      if (seen.contains(type)
          || (type == KrlGrammarParser.DECL && !decl)
          || (type == KrlGrammarParser.CONST && !constant)) {
        errors.add(token, token.getText() + " is not allowed here");
      }
      seen.add(type);
    }
    return expressions.at(content);
  }
}
