package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockMiddleContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BracketsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.FunctionBeginContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.RoutineBeginContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Builds the tree of the lines from {@code DEF} to {@code END}. */
final class RoutineBuilder {
  /** Deeper than any real program; code that walks the tree is recursive. */
  static final int MAX_BLOCKS = 100;

  /** The type of the token that opens a block, by the type of the token that ends it. */
  private static final Map<Integer, Integer> OPENERS =
      Block.ENDS.entrySet().stream()
          .collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));

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
  private List<Routine.Parameter> parameters = List.of();
  private final List<Declaration> declarations = new ArrayList<>();
  private final List<Statement> body = new ArrayList<>();
  private final List<Block> open = new ArrayList<>();
  private boolean hasStatements;
  private boolean lateReported;
  private boolean inSpline;
  private boolean tooDeep;
  private boolean suspect;
  private int unknownLines;

  RoutineBuilder(Line line, Errors errors) {
    this.errors = errors;
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
    BracketsContext brackets = function.brackets();
    returnType = function.name(0).getText() + (brackets == null ? "" : brackets.getText());
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
    if (inSpline) {
      inSpline = !UnsupportedStatements.endSpline(line);
    } else if (UnsupportedStatements.contain(line)) {
      UnsupportedStatements.report(line, errors);
      inSpline = UnsupportedStatements.beginSpline(line);
      hasStatements = true;
    } else if (line.isUnknown()) {
      ErrorWords.reportUnknown(line, errors);
      suspect(line);
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
    if (content.blockBegin() != null) {
      begin(line, statements.begin(content.blockBegin()));
    } else if (content.blockMiddle() != null) {
      middle(line, content.blockMiddle());
    } else if (content.blockEnd() != null) {
      end(line.first(), expressions.buildOptional(content.blockEnd().expression()));
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
    if (declaration != null) {
      declarations.add(declaration);
    }
    if (hasStatements && !lateReported) {
      errors.add(line.first(), "a declaration must precede the first statement");
      lateReported = true;
    }
  }

  private void execute(Line line, Statement statement) {
    boolean declaresInterrupt = statement instanceof Statement.InterruptDeclaration;
    hasStatements |= !declaresInterrupt;
    lateReported &= declaresInterrupt;
    awaitCase(line.first());
    check(statement);
    current().add(statement);
  }

  private void check(Statement statement) {
    if (statement instanceof Statement.Exit
        && unknownLines == 0
        && open.stream().noneMatch(Block::isLoop)) {
      errors.add(statement.position(), "EXIT outside a loop");
    } else if (statement instanceof Statement.Return result) {
      checkReturn(result);
    } else if (statement instanceof Statement.Label label) {
      jumps.label(label, around());
    } else if (statement instanceof Statement.Goto jump) {
      jumps.jump(jump, around());
    }
  }

  private void checkReturn(Statement.Return result) {
    if (isFunction() && result.value() == null) {
      errors.add(result.position(), "RETURN without a value in a DEFFCT");
    } else if (!isFunction() && result.value() != null) {
      errors.add(result.position(), "RETURN with a value in a DEF");
    }
  }

  private List<Statement> current() {
    return open.isEmpty() ? body : innermost().current();
  }

  private List<List<Statement>> around() {
    return open.stream().map(Block::current).toList();
  }

  private Block innermost() {
    return open.get(open.size() - 1);
  }

  private void awaitCase(Token found) {
    if (!open.isEmpty() && innermost().awaitsCase() && !innermost().isSuspect()) {
      errors.add(found, "expected CASE, found " + found.getText());
      innermost().suspect();
    }
  }

  private void begin(Line line, Block.@Nullable Finish finish) {
    hasStatements = true;
    lateReported = false;
    awaitCase(line.first());
    open.add(new Block(line.first(), finish));
    if (open.size() > MAX_BLOCKS) {
      errors.add(line.first(), "blocks nested deeper than " + MAX_BLOCKS);
      tooDeep = true;
    }
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
      if (unknownLines == 0) {
        errors.add(
            found, "expected " + ErrorWords.keyword(block.end()) + ", found " + found.getText());
      }
    } else if (found.getType() == KrlGrammarParser.CASE) {
      List<Expression> values =
          context == null ? null : context.expression().stream().map(expressions::build).toList();
      block.beginBranch(errors.at(found), values);
    } else {
      awaitCase(found);
      block.beginOtherwise();
    }
  }

  private void end(Token found, @Nullable Expression until) {
    if (!closeUpTo(found, Objects.requireNonNull(OPENERS.get(found.getType())))) {
      return;
    }
    awaitCase(found);
    Block block = open.remove(open.size() - 1);
    boolean understood = block.end() != KrlGrammarParser.UNTIL || until != null;
    Statement statement = understood ? block.finish(until) : null;
    if (statement != null) {
      current().add(statement);
    }
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
        open.remove(open.size() - 1);
      }
    } else if (unknownLines > 0) {
      // A mistyped first line has one end, perhaps after an ELSE or several CASEs.
      unknownLines -= OPENERS.containsKey(found.getType()) ? 1 : 0;
    } else if (open.isEmpty()) {
      errors.add(found, found.getText() + " without " + ErrorWords.keyword(opener));
    } else {
      reportMissingEnd(found);
      innermost().suspect();
    }
    return isOpen;
  }

  private void reportMissingEnd(Token found) {
    Block block = innermost();
    if (!block.isSuspect()) {
      errors.add(
          found,
          "expected "
              + ErrorWords.keyword(block.end())
              + " of the "
              + ErrorWords.keyword(block.opener().getType())
              + " in line "
              + block.opener().getLine()
              + ", found "
              + ErrorWords.found(found));
    }
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
      Position place = errors.at(line.first());
      jumps.label(new Statement.Label(place, line.first().getText()), around());
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
    if (!tooDeep) {
      jumps.check();
    }
    return name == null
        ? null
        : new Routine(
            position,
            global,
            returnType,
            name,
            parameters,
            List.copyOf(declarations),
            List.copyOf(body),
            errors.at(found));
  }
}
