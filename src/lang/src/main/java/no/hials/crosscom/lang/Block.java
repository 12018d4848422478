package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.lang.internal.PackedList;
import no.hials.crosscom.lang.internal.TreeBytes;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BlockEndContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** A statement of several lines whose end has not yet been read. */
final class Block {
  /** The type of the token that ends a block, by the type of the token that opens it. */
  static final Map<Integer, Integer> ENDS =
      Map.of(
          KrlGrammarParser.IF, KrlGrammarParser.ENDIF,
          KrlGrammarParser.SWITCH, KrlGrammarParser.ENDSWITCH,
          KrlGrammarParser.FOR, KrlGrammarParser.ENDFOR,
          KrlGrammarParser.WHILE, KrlGrammarParser.ENDWHILE,
          KrlGrammarParser.REPEAT, KrlGrammarParser.UNTIL,
          KrlGrammarParser.LOOP, KrlGrammarParser.ENDLOOP,
          KrlGrammarParser.SPLINE, KrlGrammarParser.ENDSPLINE);

  /** Creates the statement when its end has been read. */
  interface Finish {
    /**
     * Creates the statement.
     *
     * @param end the line that ends the block
     */
    Statement make(Block block, BlockEndContext end);
  }

  private final Token opener;
  private final Position position;
  private final @Nullable Finish finish;
  private final List<Statement.Case> cases = new ArrayList<>();
  private final TreeBytes tree;
  private final PackedList<Statement> body;
  private @Nullable PackedList<Statement> otherwise;
  private PackedList<Statement> current;
  private @Nullable String damage;
  private boolean suspect;

  /**
   * Creates an open block.
   *
   * @param tree the tree of the file
   * @param finish null if the line that opens the block contains an error
   */
  Block(TreeBytes tree, Token opener, Position position, @Nullable Finish finish) {
    this.tree = tree;
    body = statements();
    current = body;
    this.opener = opener;
    this.position = position;
    this.finish = finish;
    // A line with an error may be a whole statement, without an end.
    suspect = finish == null;
  }

  private PackedList<Statement> statements() {
    return new PackedList<>(tree, Statement.class);
  }

  Token opener() {
    return opener;
  }

  /** Returns the type of the token that ends the block. */
  int end() {
    return Objects.requireNonNull(ENDS.get(opener.getType()));
  }

  boolean isLoop() {
    return opener.getType() != KrlGrammarParser.IF && !isSwitch() && !isSpline();
  }

  boolean isSpline() {
    return opener.getType() == KrlGrammarParser.SPLINE;
  }

  boolean isSwitch() {
    return opener.getType() == KrlGrammarParser.SWITCH;
  }

  /** Returns the list that gets the next statement. */
  PackedList<Statement> current() {
    return current;
  }

  /** Returns the statements between the first line and the end or {@code ELSE}. */
  PackedList<Statement> body() {
    return body;
  }

  /** Returns the statements after {@code ELSE} or {@code DEFAULT}; null without either. */
  @Nullable PackedList<Statement> otherwise() {
    return otherwise;
  }

  void beginOtherwise() {
    otherwise = statements();
    current = otherwise;
  }

  List<Statement.Case> cases() {
    return List.copyOf(cases);
  }

  void beginCase(Position casePosition, List<Expression> values) {
    current = statements();
    cases.add(new Statement.Case(casePosition, values, current));
  }

  /** Returns whether the next line must be the first {@code CASE} of a {@code SWITCH}. */
  boolean awaitsCase() {
    return isSwitch() && cases.isEmpty() && otherwise == null;
  }

  /** Notes that a line reported in the block may be its mistyped end. */
  void suspect() {
    suspect = true;
  }

  boolean isSuspect() {
    return suspect;
  }

  /** Notes an error without which the block would be another statement. */
  void damage(@Nullable String reason) {
    damage = damage == null ? reason : damage;
  }

  /** Creates the statement when its end has been read. */
  Statement finish(BlockEndContext end) {
    return damage == null && finish != null ? finish.make(this, end) : invalid("");
  }

  /**
   * Creates the statement of a block with an error.
   *
   * @param reason the error, unless there was one before
   */
  Statement invalid(String reason) {
    return new Statement.Invalid(position, damage == null ? reason : damage);
  }
}
