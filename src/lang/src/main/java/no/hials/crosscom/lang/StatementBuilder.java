package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.lang.Statement.InterruptCommand;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.lang.Statement.SplineKind;
import no.hials.crosscom.lang.Statement.TimeBlockPart;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ActionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.AnalogContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockBeginContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.DefinitionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ExpressionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.InterruptContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.MotionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NameContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NamedContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.PathCommandContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.PulseContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.SimpleStatementContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.SplineEndContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.SplineMotionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.StepsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.TriggerContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.WithContext;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;

/** Builds the records of statements. */
final class StatementBuilder {
  private final Errors errors;
  private final ExpressionBuilder expressions;
  private final DeclarationBuilder declarations;

  StatementBuilder(Errors errors, ExpressionBuilder expressions, DeclarationBuilder declarations) {
    this.errors = errors;
    this.expressions = expressions;
    this.declarations = declarations;
  }

  /** Returns the statement on a line, or null if it is a declaration or part of a block. */
  @Nullable Statement build(ContentContext content) {
    ParseTree first = content.getChild(0);
    if (first instanceof MotionContext motion) {
      return motion(motion);
    } else if (first instanceof NamedContext named) {
      return named(named);
    } else if (first instanceof SimpleStatementContext simple) {
      return simple(simple);
    } else if (first instanceof SplineMotionContext motion) {
      return splineMotion(motion);
    } else if (first instanceof PathCommandContext command) {
      return pathCommand(command);
    } else if (first instanceof PulseContext pulse) {
      return pulse(pulse);
    } else if (first instanceof TriggerContext trigger) {
      return trigger(trigger);
    } else if (first instanceof AnalogContext analog) {
      return analog(analog);
    }
    DefinitionContext definition = content.definition();
    return definition == null || definition.interrupt() == null
        ? null
        : interrupt(content, definition.interrupt());
  }

  private @Nullable Statement named(NamedContext context) {
    Position position = expressions.at(context);
    if (context.COLON() != null) {
      return new Statement.Label(position, declarations.declared(context.name()));
    }
    if (context.arguments() != null) {
      return new Statement.CallStatement(
          position, context.name().getText(), expressions.arguments(context.arguments()));
    }
    return context.steps() == null
        ? null
        : assignment(context.name(), context.steps(), context.expression());
  }

  private Statement.AssignmentStatement assignment(
      NameContext name, StepsContext steps, ExpressionContext value) {
    return new Statement.AssignmentStatement(
        expressions.at(name), expressions.variable(name, steps), expressions.build(value));
  }

  private Statement simple(SimpleStatementContext context) {
    Position position = expressions.at(context);
    return switch (context.getStart().getType()) {
      case KrlGrammarParser.EXIT -> new Statement.Exit(position);
      case KrlGrammarParser.GOTO -> new Statement.Goto(position, context.name().getText());
      case KrlGrammarParser.RETURN ->
          new Statement.Return(position, expressions.buildOptional(context.expression()));
      case KrlGrammarParser.HALT -> new Statement.Halt(position);
      case KrlGrammarParser.CONTINUE -> new Statement.Continue(position);
      case KrlGrammarParser.RESUME -> new Statement.Resume(position);
      case KrlGrammarParser.BRAKE -> new Statement.Brake(position, context.F() != null);
      case KrlGrammarParser.ON_ERROR_PROCEED -> new Statement.OnErrorProceed(position);
      case KrlGrammarParser.CONFIRM ->
          new Statement.Confirm(position, expressions.build(context.expression()));
      default -> {
        Expression value = expressions.build(context.expression());
        yield context.FOR() != null
            ? new Statement.WaitFor(position, value)
            : new Statement.WaitSec(position, value);
      }
    };
  }

  private Statement interrupt(ContentContext content, InterruptContext context) {
    if (context.action() != null) {
      return new Statement.InterruptDeclaration(
          declarations.begin(content, false, false),
          DeclarationBuilder.isGlobal(content),
          expressions.build(context.expression(0)),
          expressions.build(context.expression(1)),
          action(context.action()));
    }
    if (!content.modifier().isEmpty()) {
      errors.add(content.getStart(), content.getStart().getText() + " is not allowed here");
    }
    Token command = ((TerminalNode) context.getChild(1)).getSymbol();
    return new Statement.Interrupt(
        expressions.at(context),
        InterruptCommand.valueOf(ErrorWords.upper(command)),
        expressions.buildOptional(context.expression(0)));
  }

  private Statement.Action action(ActionContext context) {
    if (context.pulse() != null) {
      return pulse(context.pulse());
    }
    Position position = expressions.at(context);
    return context.arguments() != null
        ? new Statement.CallStatement(
            position, context.name().getText(), expressions.arguments(context.arguments()))
        : assignment(context.name(), context.steps(), context.expression());
  }

  private Statement.Pulse pulse(PulseContext context) {
    return new Statement.Pulse(
        expressions.at(context),
        expressions.variable(context.variable()),
        expressions.build(context.expression(0)),
        expressions.build(context.expression(1)));
  }

  private Statement trigger(TriggerContext context) {
    return new Statement.Trigger(
        expressions.at(context),
        context.PATH() != null,
        expressions.build(context.distance),
        context.ONSTART() != null,
        expressions.buildOptional(context.delay),
        action(context.action()),
        expressions.buildOptional(context.priority));
  }

  private Statement motion(MotionContext context) {
    List<ExpressionContext> points = context.expression();
    boolean circle = points.size() > 1;
    return new Statement.MotionStatement(
        expressions.at(context),
        MotionKind.valueOf(ErrorWords.upper(context.getStart())),
        circle ? expressions.build(points.get(0)) : null,
        expressions.build(points.get(circle ? 1 : 0)),
        expressions.buildOptional(points.size() > 2 ? points.get(2) : null),
        approximations(context),
        coordinates(context.ENUM_VALUE()));
  }

  private Statement splineMotion(SplineMotionContext context) {
    List<ExpressionContext> points = context.expression();
    boolean circle = points.size() > 1;
    SplineEndContext end = context.splineEnd();
    return new Statement.SplineMotion(
        expressions.at(context),
        SplineKind.valueOf(ErrorWords.upper(context.getStart())),
        circle ? expressions.build(points.get(0)) : null,
        expressions.build(points.get(circle ? 1 : 0)),
        expressions.buildOptional(points.size() > 2 ? points.get(2) : null),
        with(end == null ? null : end.with()),
        end != null && end.splineApproximation() != null,
        coordinates(context.ENUM_VALUE()));
  }

  private List<Statement.AssignmentStatement> with(@Nullable WithContext context) {
    return context == null
        ? List.of()
        : context.assignment().stream()
            .map(each -> assignment(each.name(), each.steps(), each.expression()))
            .toList();
  }

  private Statement pathCommand(PathCommandContext context) {
    Position position = expressions.at(context);
    boolean onStart = context.ONSTART() != null;
    Expression value = expressions.buildOptional(context.expression(0));
    if (context.TIME_BLOCK() != null) {
      String part = ErrorWords.upper(((TerminalNode) context.getChild(1)).getSymbol());
      return new Statement.TimeBlock(position, TimeBlockPart.valueOf(part), value);
    }
    Expression distance = Objects.requireNonNull(value);
    return context.CONST_VEL() != null
        ? new Statement.ConstantVelocity(position, context.END() != null, distance, onStart)
        : new Statement.StopOnPath(
            position, distance, onStart, expressions.build(context.expression(1)));
  }

  private Statement analog(AnalogContext context) {
    Position position = expressions.at(context);
    Expression.Variable target = expressions.variable(context.variable());
    return context.ANIN() != null
        ? new Statement.AnalogInput(
            position, target, expressions.buildOptional(context.expression(0)))
        : new Statement.AnalogOutput(
            position,
            target,
            expressions.buildOptional(context.value),
            expressions.buildOptional(context.delay),
            expressions.buildOptional(context.minimum),
            expressions.buildOptional(context.maximum));
  }

  private Set<Approximation> approximations(MotionContext context) {
    Set<Approximation> approximations = EnumSet.noneOf(Approximation.class);
    List<ParserRuleContext> written = new ArrayList<>(context.anyApproximation());
    written.addAll(context.pathApproximation());
    for (ParserRuleContext approximation : written) {
      // KSS itself writes LIN P1 C_DIS C_DIS: the second is for the orientation (assumed)
      approximations.add(Approximation.valueOf(ErrorWords.upper(approximation.getStart())));
    }
    return Collections.unmodifiableSet(approximations);
  }

  private @Nullable String coordinates(@Nullable TerminalNode written) {
    if (written == null) {
      return null;
    }
    String name = ErrorWords.upper(written.getSymbol());
    if (!name.equals("#BASE") && !name.equals("#TOOL")) {
      errors.add(written.getSymbol(), "expected #BASE or #TOOL, found " + written.getText());
    }
    return written.getText();
  }

  /** Returns the code that creates a statement of several lines when its end has been read. */
  Block.Finish begin(BlockBeginContext context) {
    Position position = expressions.at(context);
    List<Expression> values = context.expression().stream().map(expressions::build).toList();
    return switch (context.getStart().getType()) {
      case KrlGrammarParser.IF ->
          (block, end) -> new Statement.If(position, values.get(0), block.body(), otherwise(block));
      case KrlGrammarParser.SWITCH ->
          (block, end) ->
              new Statement.Switch(position, values.get(0), block.cases(), block.otherwise());
      case KrlGrammarParser.FOR -> {
        Expression.Variable counter = expressions.variable(context.variable());
        Expression step = values.size() > 2 ? values.get(2) : null;
        yield (block, end) ->
            new Statement.For(position, counter, values.get(0), values.get(1), step, block.body());
      }
      case KrlGrammarParser.WHILE ->
          (block, end) -> new Statement.While(position, values.get(0), block.body());
      case KrlGrammarParser.REPEAT ->
          (block, end) ->
              new Statement.Repeat(position, block.body(), expressions.build(end.expression()));
      case KrlGrammarParser.SPLINE -> {
        boolean pointToPoint = isPointToPoint(context.getStart());
        List<Statement.AssignmentStatement> with = with(context.with());
        yield (block, end) ->
            new Statement.SplineBlock(
                position,
                pointToPoint,
                with,
                block.body().stream().map(Statement.SplineElement.class::cast).toList(),
                end.splineApproximation() != null);
      }
      default -> (block, end) -> new Statement.Loop(position, block.body());
    };
  }

  private static List<Statement> otherwise(Block block) {
    List<Statement> otherwise = block.otherwise();
    return otherwise == null ? List.of() : otherwise;
  }

  /** Returns whether the first line of a spline block begins a {@code PTP_SPLINE}. */
  static boolean isPointToPoint(Token opener) {
    return ErrorWords.upper(opener).equals("PTP_SPLINE");
  }
}
