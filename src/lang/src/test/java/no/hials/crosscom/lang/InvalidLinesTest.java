package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A line with an error stays in the tree as an invalid statement, so that it is never skipped. */
class InvalidLinesTest {
  private static final String A = "AssignmentStatement(A, 1)";

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "A=1;GRIPPER OPEN;A=1    | $A, Invalid(unknown statement GRIPPER; a type needs DECL before it), $A",
        "A=1;B=);A=1             | $A, Invalid(expected a value, found )), $A",
        "ASYSTOP;A=1             | Invalid(ASYSTOP is not supported), $A",
        "B=2147483648            | Invalid(2147483648 is not an INT: the largest is 2147483647)",
        "POS=)                   | Invalid(expected a value, found ))",
        "LIN_REL C #D            | Invalid(expected #BASE or #TOOL, found #D)",
        "LOP;EXIT;ENDLOOP        |"
            + " Invalid(unknown statement LOP: expected = or ( after it, found the end of the line),"
            + " Invalid(EXIT outside a loop)",
        "EXIT                    | Invalid(EXIT outside a loop)",
        "RETURN 1                | Invalid(RETURN with a value in a DEF)",
        "GOTO L;A=1              | Invalid(unknown label L), $A",
        "LOOP;A=1;GOTO L;ENDLOOP | Loop([$A, Invalid(unknown label L)])",
        "L:;L:;GOTO L            | Label(L), Invalid(the label L is already in line 2), Goto(L)",
        "L: A=1;GOTO L           | Label(L), Invalid(expected the end of the line, found A), Goto(L)",
        "IF A THEN;B=);ENDIF     | If(A, [Invalid(expected a value, found ))], [])",
        "IF A THEN;ELSE;B=);ENDIF | If(A, [], [Invalid(expected a value, found ))])",
        "IF A THEN;A=1;ELSE X;ENDIF;A=1 | Invalid(expected the end of the line, found X), $A",
        "IF A;A=1;ENDIF;A=1      | Invalid(expected THEN, found the end of the line), $A",
        "IF A THEN;A=1           | Invalid(expected ENDIF of the IF in line 2, found END)",
        "A=1;LOOP;IF A THEN;ENDLOOP;A=1 | $A,"
            + " Loop([Invalid(expected ENDIF of the IF in line 4, found ENDLOOP)]), $A",
        "ENDIF;A=1               | Invalid(ENDIF without IF), $A",
        "IF A THEN;ELSE;A=1;ELSE;ENDIF | Invalid(expected ENDIF, found ELSE)",
        "SWITCH A;A=1;CASE 1;ENDSWITCH | Invalid(expected CASE, found A)",
        "SWITCH A;CASE;A=1;CASE 2;ENDSWITCH;A=1 | Invalid(expected a value, found the end of the line), $A",
        "REPEAT;A=1;UNTIL;A=1    | Invalid(expected a value, found the end of the line), $A",
        "FOR I=1 TO 3;A=1;ENDFOR X | Invalid(expected the end of the line, found X)",
        "DECL INT B C;A=1        | $A",
      })
  void keepsALineWithAnError(String lines, String tree) {
    ParseResult result = routine(lines.replace(';', '\n'));

    assertThat(result.errors()).hasSize(1);
    Routine routine = ((SourceFile) result.file().orElseThrow()).routines().get(0);
    assertThat(show(routine.body())).isEqualTo("[" + tree.replace("$A", A) + "]");
  }

  @Test
  void keepsALineWithAnErrorAtItsPlace() {
    Routine routine = ((SourceFile) routine("A=1\n  B=)").file().orElseThrow()).routines().get(0);

    assertThat(routine.body().get(1).position()).isEqualTo(new Position(Snippets.FILE, 3, 3));
  }

  @Test
  void keepsARoutineWithoutAnEndAndAListWithoutEnddat() {
    ParseResult program = KrlParser.parse("A.SRC", "DEF A()\nA=1\nDEF B()\nA=1\n");
    ParseResult list = KrlParser.parse("A.DAT", "DEFDAT A\nINT B=1\n");

    assertThat(program.errors()).hasSize(2);
    assertThat(show(program.file().orElseThrow()))
        .isEqualTo(
            "SourceFile([Routine(false, -, [], A, [], [], [%s]), Routine(false, -, [], B, [], [], [%s])])"
                .formatted(A, A));
    assertThat(list.errors()).hasSize(1);
    assertThat(((DataList) list.file().orElseThrow()).declarations()).hasSize(1);
  }

  @Test
  void keepsDeclarationsWithAnErrorOfStyleOnly() {
    ParseResult result = routine("A=1\nINT LONGER_THAN_TWENTY_FOUR_CHARACTERS\nB=1\nINT C=1");

    assertThat(result.errors()).hasSize(4);
    Routine routine = ((SourceFile) result.file().orElseThrow()).routines().get(0);
    assertThat(routine.declarations()).hasSize(2);
    assertThat(routine.body()).hasSize(2);
  }

  @Test
  void dropsADeclarationWhoseValueIsWrong() {
    ParseResult result = Snippets.dataList("INT A=2147483648\nINT B=1");

    assertThat(result.errors()).hasSize(1);
    assertThat(((DataList) result.file().orElseThrow()).declarations())
        .singleElement()
        .asString()
        .contains("B");
  }
}
