package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** A statement of several lines whose end has not been read yet. */
final class Block {
  /** Makes the statement when the end has been read. */
  interface Finish {
    /**
     * Makes it.
     *
     * @param until the condition behind {@code UNTIL}; null for all but {@code REPEAT}
     */
    Statement make(Block block, @Nullable Expression until);
  }

  /** A {@code CASE}; without values if they were not understood. */
  record Branch(Position position, @Nullable List<Expression> values, List<Statement> body) {}

  private final Token opener;
  private final @Nullable Finish finish;
  private final List<Branch> branches = new ArrayList<>();
  private final List<Statement> body = new ArrayList<>();
  private @Nullable List<Statement> otherwise;
  private List<Statement> current = body;
  private boolean suspect;

  /**
   * Begins one.
   *
   * @param finish null if the line that opens it was not understood
   */
  Block(Token opener, @Nullable Finish finish) {
    this.opener = opener;
    this.finish = finish;
    // A line that was not understood may be a whole statement that has no end.
    suspect = finish == null;
  }

  Token opener() {
    return opener;
  }

  /** Gives the type of the token that ends it. */
  int end() {
    return switch (opener.getType()) {
      case KrlGrammarParser.IF -> KrlGrammarParser.ENDIF;
      case KrlGrammarParser.SWITCH -> KrlGrammarParser.ENDSWITCH;
      case KrlGrammarParser.FOR -> KrlGrammarParser.ENDFOR;
      case KrlGrammarParser.WHILE -> KrlGrammarParser.ENDWHILE;
      case KrlGrammarParser.REPEAT -> KrlGrammarParser.UNTIL;
      default -> KrlGrammarParser.ENDLOOP;
    };
  }

  boolean isLoop() {
    return opener.getType() != KrlGrammarParser.IF && !isSwitch();
  }

  boolean isSwitch() {
    return opener.getType() == KrlGrammarParser.SWITCH;
  }

  /** Gives the list that the next statement goes to. */
  List<Statement> current() {
    return current;
  }

  /** Gives the statements between the line that opens it and its end or {@code ELSE}. */
  List<Statement> body() {
    return body;
  }

  /** Gives the statements behind {@code ELSE} or {@code DEFAULT}; null if it was not there. */
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

  /** Says whether it is between {@code SWITCH} and the first {@code CASE}. */
  boolean awaitsCase() {
    return isSwitch() && current == body;
  }

  /** Remembers that something that was reported in it may be its mistyped end. */
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
