package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.FILE;
import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.expression;
import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import no.hials.crosscom.lang.Expression.Binary;
import no.hials.crosscom.lang.Expression.BinaryOperator;
import no.hials.crosscom.lang.Expression.IntLiteral;
import no.hials.crosscom.lang.Expression.Step;
import no.hials.crosscom.lang.Expression.Unary;
import no.hials.crosscom.lang.Expression.UnaryOperator;
import no.hials.crosscom.lang.Expression.Variable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ExpressionTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        // operators of adjacent precedence, the higher on the right
        "A OR B EXOR C         | (A OR (B EXOR C))",
        "A EXOR B AND C        | (A EXOR (B AND C))",
        "A AND B==C            | (A AND (B EQUAL C))",
        "A==B B_OR C           | (A EQUAL (B B_OR C))",
        "A B_OR B B_EXOR C     | (A B_OR (B B_EXOR C))",
        "A B_EXOR B B_AND C    | (A B_EXOR (B B_AND C))",
        "A B_AND B+C           | (A B_AND (B PLUS C))",
        "A+B*C                 | (A PLUS (B MULTIPLY C))",
        "A*B:C                 | (A MULTIPLY (B GEOMETRIC C))",
        "A:-B                  | (A GEOMETRIC (MINUS B))",
        // the higher on the left
        "A EXOR B OR C         | ((A EXOR B) OR C)",
        "A AND B EXOR C        | ((A AND B) EXOR C)",
        "A==B AND C            | ((A EQUAL B) AND C)",
        "A B_OR B==C           | ((A B_OR B) EQUAL C)",
        "A B_AND B B_EXOR C    | ((A B_AND B) B_EXOR C)",
        "A+B B_AND C           | ((A PLUS B) B_AND C)",
        "A*B-C                 | ((A MULTIPLY B) MINUS C)",
        "A:B/C                 | ((A GEOMETRIC B) DIVIDE C)",
        "-A:B                  | ((MINUS A) GEOMETRIC B)",
        "NOT A AND B           | ((NOT A) AND B)",
        "NOT A==B              | ((NOT A) EQUAL B)",
        "B_NOT A B_AND B       | ((B_NOT A) B_AND B)",
        // the same precedence, from left to right
        "A-B+C-D               | (((A MINUS B) PLUS C) MINUS D)",
        "A/B*C                 | ((A DIVIDE B) MULTIPLY C)",
        "A:B:C                 | ((A GEOMETRIC B) GEOMETRIC C)",
        "A<B<>C                | ((A LESS B) NOT_EQUAL C)",
        // parentheses
        "A*(B+C)               | (A MULTIPLY (B PLUS C))",
        "NOT (A AND B)         | (NOT (A AND B))",
        // common conditions
        "A==1 AND B==2         | ((A EQUAL 1) AND (B EQUAL 2))",
        "(A>=1) OR (B<=2)      | ((A GREATER_OR_EQUAL 1) OR (B LESS_OR_EQUAL 2))",
        "$IN[1] AND NOT $IN[2] | ($IN[1] AND (NOT $IN[2]))",
        "STATUS B_AND 4==4     | ((STATUS B_AND 4) EQUAL 4)",
        "- -A > +B             | ((MINUS (MINUS A)) GREATER (PLUS B))",
      })
  void groupsOperatorsByPrecedence(String text, String tree) {
    assertThat(show(expression(text))).isEqualTo(tree);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "0               | 0",
        "007             | 7",
        "2147483647      | 2147483647",
        "-2147483648     | -2147483648",
        "'B0101'         | 5",
        "'b000111111111' | 511",
        "'HFF'           | 255",
        "'hff'           | 255",
        "'HFFFFFFFF'     | -1",
        "'H00000000F'    | 15",
        "1.5             | 1.5",
        "1.              | 1.0",
        ".5              | 0.5",
        "1E5             | 100000.0",
        "1.5e-1          | 0.15000000596046448",
        "2.5E+01         | 25.0",
        "0.1             | 0.10000000149011612",
        "true            | true",
        "FALSE           | false",
        "\"a;b {c}\"     | \"a;b {c}\"",
        "\"\"            | \"\"",
        "#P_FREE         | #P_FREE",
        "#ON             | #ON",
      })
  void readsLiterals(String text, String tree) {
    assertThat(show(expression(text))).isEqualTo(tree);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "$axis_act.A1          | $axis_act.A1",
        "LOAD_DATA[I+1].CM.X   | LOAD_DATA[(I PLUS 1)].CM.X",
        "A[1,2,3]              | A[1, 2, 3]",
        "NAME[]                | NAME[]+open",
        "TOOL_NAME[1,]         | TOOL_NAME[1]+open",
        "TABLE[,]              | TABLE[]+open",
        "$DATE.SEC             | $DATE.SEC",
        "ON+STEP               | (ON PLUS STEP)",
        "F()                   | F()",
        "SIN ( 30 )            | SIN(30)",
        "F(A,,#B,NAME[])       | F(A, -, #B, NAME[]+open)",
        "F(,A)                 | F(-, A)",
        "F(G(1))[1]            | error",
        "{X 10,Y 2*I,Z -1.5}   | {X 10, Y (2 MULTIPLY I), Z (MINUS 1.5)}",
        "{POS: X 10}           | {POS: X 10}",
        "{E6POS: }             | {E6POS: }",
        "{}                    | {}",
        "{NAME[] \"A,B\",L {M 1,CM {FRAME: X 2}}} | {NAME[] \"A,B\", L {M 1, CM {FRAME: X 2}}}",
        "{A[ 1 ] 5,A[2] 6}     | {A[1] 5, A[2] 6}",
        "{P F(1),Q A.B}        | {P F(1), Q A.B}",
      })
  void readsVariablesCallsAndAggregates(String text, String tree) {
    ParseResult result = routine("T=" + text);

    assertThat(
            result.errors().isEmpty()
                ? show(Snippets.onlyRoutine(result).body().get(0))
                : "AssignmentStatement(T, error)")
        .isEqualTo("AssignmentStatement(T, " + tree + ")");
  }

  @Test
  void givesEveryPartItsPlace() {
    assertThat(expression("-A+B[12]"))
        .isEqualTo(
            new Binary(
                at(5),
                BinaryOperator.PLUS,
                new Unary(at(3), UnaryOperator.MINUS, variable(4, "A")),
                new Variable(
                    at(6),
                    List.of(new Step("B", true, List.of(new IntLiteral(at(8), 12)), false)))));
  }

  @Test
  void givesParenthesesNoPlaceOfTheirOwn() {
    assertThat(expression("((A))")).isEqualTo(variable(5, "A"));
  }

  private static Position at(int column) {
    return new Position(FILE, 2, column);
  }

  private static Variable variable(int column, String name) {
    return new Variable(at(column), List.of(new Step(name, false, List.of(), false)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "T=          | 2:3 expected a value, found the end of the line",
        "T=1+        | 2:5 expected a value, found the end of the line",
        "T=1+*2      | 2:5 expected a value, found *",
        "T=(1+2      | 2:7 expected ), found the end of the line",
        "T=1+2)      | 2:6 expected the end of the line, found )",
        "T=1 2       | 2:5 expected the end of the line, found 2",
        "T=A B       | 2:5 expected the end of the line, found B",
        "T=A.        | 2:5 expected a name, found the end of the line",
        "T=A.1       | 2:4 expected the end of the line, found .1",
        "T=A[1       | 2:6 expected a comma or ], found the end of the line",
        "T=A[1 2]    | 2:7 expected a comma or ], found 2",
        "T=F(:)      | 2:6 expected a name, found )",
        "T=F(:A:B)   | 2:7 expected a comma or ), found :",
        "T=:A        | 2:3 expected a value, found :",
        "T=A[,1]     | 2:6 an index after an omitted index",
        "T=A[1,2,3,4] | 2:4 expected at most 3 dimensions, found 4",
        "T=F(1 2)    | 2:7 expected a comma or ), found 2",
        "T=F(1,2     | 2:8 expected a comma or ), found the end of the line",
        "T={X 1 Y 2} | 2:8 expected a comma or }, found Y",
        "T={X 1,}    | 2:8 expected a name, found }",
        "T={X}       | 2:5 expected a value or [, found }",
        "T={X 1      | 2:7 expected a comma or }, found the end of the line",
        "T={1}       | 2:4 expected a name or }, found 1",
        "T=NOT       | 2:6 expected a value, found the end of the line",
        "T=A==THEN   | 2:6 expected a value, found THEN",
        "T=A AND IF  | 2:9 expected a value, found IF",
        "T=2147483648 | 2:3 2147483648 is not an INT: the largest is 2147483647",
        "T='B111111111111111111111111111111111' | 2:3 'B111111111111111111111111111111111' is not an INT: it has more than 32 bits",
        "T='H100000000' | 2:3 'H100000000' is not an INT: it has more than 32 bits",
        "T=1E39      | 2:3 1E39 is not a REAL: the largest is 3.4028235E38",
        "T='X12'     | 2:3 expected 'B' and binary or 'H' and hexadecimal digits, found 'X12'",
        "T='B012'    | 2:3 expected 'B' and binary or 'H' and hexadecimal digits, found 'B012'",
        "T=\"abc     | 2:3 expected \" at the end of the text, found the end of the line",
        "T=5 ! 3     | 2:5 expected the end of the line, found the character !",
        "T=5 ä 3     | 2:5 expected the end of the line, found the character ä",
        "T=#         | 2:3 expected a value, found the character #",
        "T=A=B       | 2:4 expected the end of the line, found =",
      })
  void reportsABadExpressionOnce(String line, String error) {
    assertThat(errors(routine(line))).containsExactly(error);
  }

  @Test
  void namesAControlCharacterByItsNumber() {
    assertThat(errors(routine("T=5\u0007")))
        .containsExactly("2:4 expected the end of the line, found the character U+0007");
  }
}
