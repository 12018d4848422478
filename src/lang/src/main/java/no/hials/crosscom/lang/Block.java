package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
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
          KrlGrammarParser.LOOP, KrlGrammarParser.ENDLOOP);

  /** Creates the statement when its end has been read. */
  interface Finish {
    /**
     * Creates the statement.
     *
     * @param until the condition after {@code UNTIL}; null for all but {@code REPEAT}
     */
    Statement make(Block block, @Nullable Expression until);
  }

  /** A {@code CASE}; the values are null if they contain an error. */
  record Branch(Position position, @Nullable List<Expression> values, List<Statement> body) {}

  private final Token opener;
  private final @Nullable Finish finish;
  private final List<Branch> branches = new ArrayList<>();
  private final List<Statement> body = new ArrayList<>();
  private @Nullable List<Statement> otherwise;
  private List<Statement> current = body;
  private boolean suspect;

  /**
   * Creates an open block.
   *
   * @param finish null if the line that opens the block contains an error
   */
  Block(Token opener, @Nullable Finish finish) {
    this.opener = opener;
    this.finish = finish;
    // A line with an error may be a whole statement, without an end.
    suspect = finish == null;
  }

  Token opener() {
    return opener;
  }

  /** Returns the type of the token that ends the block. */
  int end() {
    return Objects.requireNonNull(ENDS.get(opener.getType()));
  }

  boolean isLoop() {
    return opener.getType() != KrlGrammarParser.IF && !isSwitch();
  }

  boolean isSwitch() {
    return opener.getType() == KrlGrammarParser.SWITCH;
  }

  /** Returns the list that gets the next statement. */
  List<Statement> current() {
    return current;
  }

  /** Returns the statements between the first line and the end or {@code ELSE}. */
  List<Statement> body() {
    return body;
  }

  /** Returns the statements after {@code ELSE} or {@code DEFAULT}; null without either. */
  @Nullable List<Statement> otherwise() {
    return otherwise;
  }

  void beginOtherwise() {
    otherwise = new ArrayList<>();
    current = otherwise;
  }

  List<Branch> branches() {
    return branches;
  }

  void beginBranch(Position position, @Nullable List<Expression> values) {
    Branch branch = new Branch(position, values, new ArrayList<>());
    branches.add(branch);
    current = branch.body();
  }

  /** Returns whether the next line must be the first {@code CASE} of a {@code SWITCH}. */
  boolean awaitsCase() {
    return isSwitch() && current == body;
  }

  /** Notes that a line reported in the block may be its mistyped end. */
  void suspect() {
    suspect = true;
  }

  boolean isSuspect() {
    return suspect;
  }

  @Nullable Statement finish(@Nullable Expression until) {
    return finish == null ? null : finish.make(this, until);
  }
}
