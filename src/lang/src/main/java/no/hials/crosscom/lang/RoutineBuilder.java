package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.lang.internal.PackedList;
import no.hials.crosscom.lang.internal.TreeBytes;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockBeginContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockEndContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockMiddleContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.FunctionBeginContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.RoutineBeginContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.jspecify.annotations.Nullable;

/** Builds the tree of the lines from {@code DEF} to {@code END}. */
final class RoutineBuilder {
  /** Deeper than any real program; code that walks the tree is recursive. */
  static final int MAX_BLOCKS = 100;

  /** The type of the token that opens a block, by the type of the token that ends it. */
  private static final Map<Integer, Integer> OPENERS =
      Block.ENDS.entrySet().stream()
          .collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));

  private static final TypeSwitch<RoutineBuilder, Statement, Void, RuntimeException> PLACES =
      TypeSwitch.create(
          Statement.class,
          cases ->
              cases
                  .run(Statement.Exit.class, RoutineBuilder::checkExit)
                  .run(Statement.Return.class, RoutineBuilder::checkReturn)
                  .run(Statement.Label.class, (it, label) -> it.jumps.label(label, it.around()))
                  .run(Statement.Goto.class, (it, jump) -> it.jumps.jump(jump, it.around()))
                  .otherwise(RoutineBuilder::allowAnywhere));

  private final Errors errors;
  private final ExpressionBuilder expressions;
  private final DeclarationBuilder declarationBuilder;
  private final StatementBuilder statements;
  private final Jumps jumps;
  private final Token keyword;
  private final Position position;
  private boolean global;
  private @Nullable String name;
  private @Nullable String returnType;
  private List<@Nullable Expression> returnDimensions = List.of();
  private List<Routine.Parameter> parameters = List.of();
  private final TreeBytes tree;
  private final PackedList<Declaration> declarations;
  private final PackedList<Statement> body;
  private final List<Block> open = new ArrayList<>();
  private boolean hasStatements;
  private boolean lateReported;
  private boolean tooDeep;
  private boolean suspect;
  private int unknownLines;

  RoutineBuilder(Line line, TreeBytes tree, Errors errors) {
    this.tree = tree;
    this.errors = errors;
    declarations = new PackedList<>(tree, Declaration.class);
    body = new PackedList<>(tree, Statement.class);
    expressions = new ExpressionBuilder(errors);
    declarationBuilder = new DeclarationBuilder(errors, expressions, false);
    statements = new StatementBuilder(errors, expressions, declarationBuilder);
    jumps = new Jumps(errors);
    keyword = line.keyword();
    position = errors.at(line.first());
    ContentContext content = line.parse(errors);
    if (content != null) {
      header(content);
    }
  }

  private void header(ContentContext content) {
    declarationBuilder.begin(content, false, false);
    global = DeclarationBuilder.isGlobal(content);
    RoutineBeginContext routine = content.definition().routineBegin();
    if (routine != null) {
      name = declarationBuilder.declared(routine.name());
      parameters = declarationBuilder.parameters(routine.parameters());
      return;
    }
    FunctionBeginContext function = content.definition().functionBegin();
    returnType = function.name(0).getText();
    returnDimensions = expressions.dimensions(function.brackets());
    name = declarationBuilder.declared(function.name(1));
    parameters = declarationBuilder.parameters(function.parameters());
  }

  private boolean isFunction() {
    return keyword.getType() == KrlGrammarParser.DEFFCT;
  }

  /** Adds a line. */
  void add(Line line) {
    if (tooDeep) {
      return;
    }
    errors.beginLine();
    if (StatementWords.isUnsupported(line)) {
      ErrorWords.reportUnsupported(line, errors);
      hasStatements = true;
      invalid(line);
    } else if (line.isUnknown()) {
      ErrorWords.reportUnknown(line, errors);
      suspect(line);
      invalid(line);
    } else {
      ContentContext content = line.parse(errors);
      if (content == null) {
        recover(line);
      } else {
        add(line, content);
      }
    }
  }

  private void add(Line line, ContentContext content) {
    ParseTree first = content.getChild(0);
    if (first instanceof BlockBeginContext begin) {
      begin(line, statements.begin(begin));
    } else if (first instanceof BlockMiddleContext middle) {
      middle(line, middle);
    } else if (first instanceof BlockEndContext end) {
      end(line.first(), end);
    } else {
      Statement statement = statements.build(content);
      if (statement != null) {
        execute(line, statement);
      } else {
        declare(line, content);
      }
    }
  }

  private void declare(Line line, ContentContext content) {
    Declaration declaration = declarationBuilder.build(content, line.comment());
    if (declaration == null) {
      // an alternative of the grammar without a case in a builder
      throw new IllegalStateException("no case for '" + content.getText() + "'");
    }
    if (errors.damage() == null) {
      declarations.append(declaration);
    }
    if (hasStatements && !lateReported) {
      errors.note(errors.at(line.first()), "a declaration must precede the first statement");
      lateReported = true;
    }
  }

  private void execute(Line line, Statement statement) {
    boolean declaresInterrupt = statement instanceof Statement.InterruptDeclaration;
    hasStatements |= !declaresInterrupt;
    lateReported &= declaresInterrupt;
    awaitCase(line.first());
    checkSpline(line.first(), statement);
    if (errors.damage() == null) {
      PLACES.run(this, statement);
    }
    if (errors.damage() == null) {
      current().append(statement);
    } else {
      invalid(line);
    }
  }

  /** Adds a line with an error. */
  private void invalid(Line line) {
    String damage = errors.damage();
    if (damage == null) {
      return;
    }
    if (isInSpline()) {
      innermost().damage(damage);
    } else {
      current().append(new Statement.Invalid(errors.at(line.first()), damage));
    }
  }

  private boolean isInSpline() {
    return !open.isEmpty() && innermost().isSpline();
  }

  /** The case of a statement that may be anywhere in its routine. */
  private void allowAnywhere(Statement statement) {}

  private void checkExit(Statement.Exit exit) {
    if (open.stream().noneMatch(Block::isLoop)) {
      // an unknown line may be the mistyped start of the loop
      errors.add(exit.position(), "EXIT outside a loop", unknownLines == 0);
    }
  }

  /** Reports what is not allowed in a spline block, or only there. */
  private void checkSpline(Token found, Statement statement) {
    String violation =
        isInSpline()
            ? SplineRules.inside(statement, StatementBuilder.isPointToPoint(innermost().opener()))
            : SplineRules.outside(statement);
    // in a block in a spline block, that block is the mistake
    if (violation != null && (isInSpline() || open.stream().noneMatch(Block::isSpline))) {
      errors.add(found, ErrorWords.found(found) + violation);
    }
  }

  private void checkReturn(Statement.Return result) {
    if (isFunction() && result.value() == null) {
      errors.add(result.position(), "RETURN without a value in a DEFFCT");
    } else if (!isFunction() && result.value() != null) {
      errors.add(result.position(), "RETURN with a value in a DEF");
    }
  }

  private PackedList<Statement> current() {
    return open.isEmpty() ? body : innermost().current();
  }

  private List<PackedList<Statement>> around() {
    return Stream.concat(Stream.of(body), open.stream().map(Block::current)).toList();
  }

  private Block innermost() {
    return open.get(open.size() - 1);
  }

  private void awaitCase(Token found) {
    if (!open.isEmpty() && innermost().awaitsCase() && !innermost().isSuspect()) {
      String message = "expected CASE, found " + found.getText();
      errors.note(errors.at(found), message);
      innermost().suspect();
      innermost().damage(message);
    }
  }

  private void begin(Line line, Block.@Nullable Finish finish) {
    hasStatements = true;
    lateReported = false;
    awaitCase(line.first());
    if (isInSpline()) {
      errors.add(
          line.first(), ErrorWords.found(line.first()) + " is not allowed in a spline block");
      innermost().damage(errors.damage());
    }
    Block block = new Block(tree, line.first(), errors.at(line.first()), finish);
    open.add(block);
    if (open.size() > MAX_BLOCKS) {
      errors.add(line.first(), "blocks nested deeper than " + MAX_BLOCKS);
      tooDeep = true;
    }
    block.damage(errors.damage());
  }

  private void middle(Line line, @Nullable BlockMiddleContext context) {
    Token found = line.first();
    boolean isElse = found.getType() == KrlGrammarParser.ELSE;
    int opener = isElse ? KrlGrammarParser.IF : KrlGrammarParser.SWITCH;
    if (!closeUpTo(found, opener)) {
      return;
    }
    Block block = innermost();
    if (block.otherwise() != null) {
      String message = "expected " + ErrorWords.keyword(block.end()) + ", found " + found.getText();
      if (unknownLines == 0) {
        errors.add(found, message);
      }
      block.damage(message);
    } else if (found.getType() == KrlGrammarParser.CASE) {
      List<Expression> values =
          context == null
              ? List.of()
              : context.expression().stream().map(expressions::build).toList();
      block.beginCase(errors.at(found), values);
    } else {
      awaitCase(found);
      block.beginOtherwise();
    }
    block.damage(errors.damage());
  }

  private void end(Token found, @Nullable BlockEndContext context) {
    if (!closeUpTo(found, Objects.requireNonNull(OPENERS.get(found.getType())))) {
      return;
    }
    awaitCase(found);
    Block block = open.remove(open.size() - 1);
    Statement statement = context == null ? null : block.finish(context);
    String damage = errors.damage();
    current()
        .append(
            statement == null || damage != null
                ? block.invalid(String.valueOf(damage))
                : statement);
  }

  /**
   * Closes the blocks inside the innermost block that starts with a keyword.
   *
   * @return false without such a block, which is then reported
   */
  private boolean closeUpTo(Token found, int opener) {
    boolean isOpen = open.stream().anyMatch(block -> block.opener().getType() == opener);
    if (isOpen) {
      if (innermost().opener().getType() != opener) {
        reportMissingEnd(found);
      }
      while (innermost().opener().getType() != opener) {
        drop(found);
      }
    } else if (unknownLines > 0) {
      // A mistyped first line has one end, perhaps after an ELSE or several CASEs.
      unknownLines -= OPENERS.containsKey(found.getType()) ? 1 : 0;
    } else if (open.isEmpty()) {
      String message = found.getText() + " without " + ErrorWords.keyword(opener);
      errors.note(errors.at(found), message);
      body.append(new Statement.Invalid(errors.at(found), message));
    } else {
      reportMissingEnd(found);
      innermost().suspect();
      innermost().damage(missingEnd(found));
    }
    return isOpen;
  }

  private void reportMissingEnd(Token found) {
    if (!innermost().isSuspect()) {
      errors.note(errors.at(found), missingEnd(found));
    }
  }

  private String missingEnd(Token found) {
    Token opener = innermost().opener();
    return "expected "
        + ErrorWords.keyword(innermost().end())
        + " of the "
        + ErrorWords.upper(opener)
        + " in line "
        + opener.getLine()
        + ", found "
        + ErrorWords.found(found);
  }

  /** Closes the innermost block without its end. */
  private void drop(Token found) {
    Statement invalid = innermost().invalid(missingEnd(found));
    open.remove(open.size() - 1);
    current().append(invalid);
  }

  /** Recovers from a line with an error the block or label that later lines need. */
  private void recover(Line line) {
    int type = line.first().getType();
    if (Block.ENDS.containsKey(type)) {
      begin(line, null);
    } else if (OPENERS.containsKey(type)) {
      end(line.first(), null);
    } else if (type == KrlGrammarParser.ELSE
        || type == KrlGrammarParser.CASE
        || type == KrlGrammarParser.DEFAULT) {
      middle(line, null);
    } else if (line.second().getType() == KrlGrammarParser.COLON) {
      Statement.Label label = new Statement.Label(errors.at(line.first()), line.first().getText());
      jumps.label(label, around());
      current().append(label);
      invalid(line);
    } else if (!line.isDeclaration()) {
      invalid(line);
    }
  }

  /** Notes that an unknown statement may be a mistyped start or end of a block. */
  private void suspect(Line line) {
    unknownLines++;
    if (!line.isOneWord()) {
      return;
    }
    if (open.isEmpty()) {
      suspect = true;
    } else {
      innermost().suspect();
    }
  }

  /**
   * Ends the routine.
   *
   * @param found {@code END}, or the token found in its place
   * @return null if the first line contains an error
   */
  @Nullable Routine finish(Token found) {
    int end = isFunction() ? KrlGrammarParser.ENDFCT : KrlGrammarParser.END;
    if (!open.isEmpty() && !tooDeep) {
      reportMissingEnd(found);
    } else if (found.getType() != end && !suspect) {
      errors.add(
          found, "expected " + ErrorWords.keyword(end) + ", found " + ErrorWords.found(found));
    }
    while (!open.isEmpty()) {
      drop(found);
    }
    if (!tooDeep) {
      jumps.check();
    }
    return name == null
        ? null
        : new Routine(
            position,
            global,
            returnType,
            returnDimensions,
            name,
            parameters,
            declarations.trim(),
            body.trim(),
            errors.at(found));
  }
}
