package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.FILE;
import static no.hials.crosscom.lang.Snippets.dataList;
import static no.hials.crosscom.lang.Snippets.declarations;
import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.onlyRoutine;
import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Declaration.Declarator;
import no.hials.crosscom.lang.Expression.IntLiteral;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DeclarationTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "INT I                    | Variables(false, false, INT, [Declarator(I, [], -)], )",
        "DECL INT I, J            | Variables(false, false, INT, [Declarator(I, [], -),"
            + " Declarator(J, [], -)], )",
        "decl gripper_t g         | Variables(false, false, gripper_t, [Declarator(g, [], -)], )",
        "E3AXIS A                 | Variables(false, false, E3AXIS, [Declarator(A, [], -)], )",
        "GLOBAL E6AXIS A[10]      | Variables(true, false, E6AXIS, [Declarator(A, [10], -)], )",
        "DECL GLOBAL REAL M[2,N,4] | Variables(true, false, REAL, [Declarator(M, [2, N, 4], -)], )",
        "GLOBAL DECL CHAR C[],D[,] | Variables(true, false, CHAR, [Declarator(C, [-], -),"
            + " Declarator(D, [-, -], -)], )",
        "DECL INT SEC,STEP        | Variables(false, false, INT, [Declarator(SEC, [], -),"
            + " Declarator(STEP, [], -)], )",
        "STRUC S INT A,B[2], REAL C, FRAME F | StrucDeclaration(false, S, [Component(INT,"
            + " Declarator(A, [], -)), Component(INT, Declarator(B, [2], -)), Component(REAL,"
            + " Declarator(C, [], -)), Component(FRAME, Declarator(F, [], -))], )",
        "GLOBAL STRUC S CHAR N[24] | StrucDeclaration(true, S, [Component(CHAR, Declarator(N, [24],"
            + " -))], )",
        "ENUM E A,B,ON            | EnumDeclaration(false, E, [A, B, ON], )",
        "GLOBAL ENUM E A          | EnumDeclaration(true, E, [A], )",
        "SIGNAL S $OUT[5]         | Signal(false, S, $OUT[5], -, )",
        "SIGNAL S $IN[1] TO $IN[8] | Signal(false, S, $IN[1], $IN[8], )",
        "GLOBAL SIGNAL S $X       | Signal(true, S, $X, -, )",
        "SIGNAL $S FALSE          | Signal(false, $S, -, -, )",
        "CHANNEL :SER_1 :SER_2 $PSER_1 | Channel(SER_1, SER_2, $PSER_1, )",
        "GLOBAL CHANNEL :A :B C[1] | Channel(A, B, C[1], )",
        "SIGNAL S $IN[1026] TO $IN[1026] | Signal(false, S, $IN[1026], $IN[1026], )",
        "EXT FOO()                | External(FOO, )",
        "EXTP FOO(INT:IN)         | External(FOO, )",
        "EXTFCTP INT FOO()        | External(FOO, )",
        "EXTFCT CHAR[16] F()      | External(F, )",
        "INT STOP,SPL             | Variables(false, false, INT, [Declarator(STOP, [], -),"
            + " Declarator(SPL, [], -)], )",
        "EXT  BAS (BAS_COMMAND  :IN,REAL[] :OUT ) | External(BAS, )",
        "EXTFCT REAL F(INT:IN)    | External(F, )",
        "EXTFCT CHAR[] F()        | External(F, )",
        "IMPORT INT N IS /R1/ACTUATOR..COUNT | External(N, /R1/ACTUATOR..COUNT)",
        "IMPORT REAL N[] IS /R1/STEU/$MACHINE..N | External(N, /R1/STEU/$MACHINE..N)",
        "IMPORT REAL N[] IS //R1/POINTS..N[] | External(N, //R1/POINTS..N)",
      })
  void readsDeclarationsInRoutinesAndDataLists(String line, String tree) {
    assertThat(show(onlyRoutine(routine(line)).declarations())).isEqualTo("[" + tree + "]");
    assertThat(show(declarations(dataList(line)))).isEqualTo("[" + tree + "]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "INT I=5                  | Variables(false, false, INT, [Declarator(I, [], 5)], )",
        "INT I=-2*N+1,J           | Variables(false, false, INT, [Declarator(I, [], (((MINUS 2)"
            + " MULTIPLY N) PLUS 1)), Declarator(J, [], -)], )",
        "INT MASK='B0101'         | Variables(false, false, INT, [Declarator(MASK, [], 5)], )",
        "DECL MODE_OP M=#T1       | Variables(false, false, MODE_OP, [Declarator(M, [], #T1)], )",
        "CONST INT N=5            | Variables(false, true, INT, [Declarator(N, [], 5)], )",
        "DECL GLOBAL CONST INT N=5 | Variables(true, true, INT, [Declarator(N, [], 5)], )",
        "E6POS P={X 1.0,Y -2,S 'B010'} | Variables(false, false, E6POS, [Declarator(P, [], {X 1.0,"
            + " Y (MINUS 2), S 2})], )",
        "DECL LOAD L={M -1.0,CM {FRAME: X 0.0}} | Variables(false, false, LOAD, [Declarator(L, [],"
            + " {M (MINUS 1.0), CM {FRAME: X 0.0}})], )",
        "CHAR C[3]=\"abc\"        | Variables(false, false, CHAR, [Declarator(C, [3], \"abc\")], )",
        "CONST CHAR N[64]         | Variables(false, true, CHAR, [Declarator(N, [64], -)], )",
        "DECL CONST T TUPLES[3]   | Variables(false, true, T, [Declarator(TUPLES, [3], -)], )",
        "FRA F={N 5}              | Variables(false, false, FRA, [Declarator(F, [], {N 5})], )",
        "A=5                      | InitialValue(A, 5, )",
        "A[1]={X 1}               | InitialValue(A[1], {X 1}, )",
        "TOOL_NAME[1,]=\"grip\"   | InitialValue(TOOL_NAME[1]+open, \"grip\", )",
        "NAME[]=\"grip\"          | InitialValue(NAME[]+open, \"grip\", )",
        "$VEL.CP=2.0              | InitialValue($VEL.CP, 2.0, )",
      })
  void readsInitialValuesInDataLists(String line, String tree) {
    assertThat(show(declarations(dataList(line)))).isEqualTo("[" + tree + "]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "INT I ; a counter        | Variables(false, false, INT, [Declarator(I, [], -)], a"
            + " counter)",
        "STRUC S INT A;b;c        | StrucDeclaration(false, S, [Component(INT, Declarator(A, [],"
            + " -))], b;c)",
        "ENUM E A;  two  words    | EnumDeclaration(false, E, [A], two  words)",
        "SIGNAL S $OUT[1];        | Signal(false, S, $OUT[1], -, )",
        "A=\"x;y\" ;z             | InitialValue(A, \"x;y\", z)",
      })
  void keepsTheCommentBehindADeclaration(String line, String tree) {
    assertThat(show(declarations(dataList(line)))).isEqualTo("[" + tree + "]");
  }

  @Test
  void keepsNoCommentOfAnotherLine() {
    assertThat(show(declarations(dataList("INT I ; one\n; two\nINT J\nINT K ; three"))))
        .isEqualTo(
            "[Variables(false, false, INT, [Declarator(I, [], -)], one),"
                + " Variables(false, false, INT, [Declarator(J, [], -)], ),"
                + " Variables(false, false, INT, [Declarator(K, [], -)], three)]");
  }

  @Test
  void givesDeclarationsTheirPlaces() {
    assertThat(declarations(dataList("  GLOBAL INT  I=5,J[2]")))
        .containsExactly(
            new Declaration.Variables(
                at(3),
                true,
                false,
                "INT",
                List.of(
                    new Declarator(at(15), "I", List.of(), new IntLiteral(at(17), 5)),
                    new Declarator(at(19), "J", List.of(new IntLiteral(at(21), 2)), null)),
                ""));
  }

  private static Position at(int column) {
    return new Position(FILE, 2, column);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "DECL                     | 2:5 expected a declaration, found the end of the line",
        "DECL INT                 | 2:9 expected a name, found the end of the line",
        "INT                      | 2:4 expected a name, =, : or (, found the end of the line",
        "INT 5                    | 2:5 expected a name, =, : or (, found 5",
        "DECL INT I,              | 2:12 expected a name, found the end of the line",
        "DECL INT I J             | 2:12 expected =, a comma or the end of the line, found J",
        "DECL INT IF              | 2:10 expected a name, found IF",
        "DECL INT 1A              | 2:10 expected a name, found 1",
        "DECL INT A[              | 2:12 expected a value, a comma or ], found the end of the line",
        "DECL INT A[1,2,3,4]      | 2:11 expected at most 3 dimensions, found 4",
        "DECL INT A23456789012345678901234X | 2:10 a name has at most 24 characters,"
            + " A23456789012345678901234X has 25",
        "DECL DECL INT A          | 2:6 DECL is not allowed here",
        "GLOBAL GLOBAL INT A      | 2:8 GLOBAL is not allowed here",
        "CONST SIGNAL S FALSE     | 2:1 CONST is not allowed here",
        "DECL EXT FOO()           | 2:1 DECL is not allowed here",
        "STRUC                    | 2:6 expected a name, found the end of the line",
        "STRUC S                  | 2:8 expected a name, found the end of the line",
        "STRUC S A                | 2:9 expected a type and a name, found A",
        "STRUC S A[2],INT B       | 2:9 expected a type and a name, found A[2]",
        "STRUC S INT A B          | 2:15 expected a comma or the end of the line, found B",
        "STRUC S INT A=5          | 2:14 expected a comma or the end of the line, found =",
        "ENUM E                   | 2:7 expected a name, found the end of the line",
        "ENUM E #A                | 2:8 expected a name, found #A",
        "ENUM E A B               | 2:10 expected a comma or the end of the line, found B",
        "SIGNAL S                 | 2:9 expected a name or FALSE, found the end of the line",
        "SIGNAL S 5               | 2:10 expected a name or FALSE, found 5",
        "SIGNAL S $IN[1] TO       | 2:19 expected a name, found the end of the line",
        "SIGNAL S $IN[1] $IN[2]   | 2:17 expected TO or the end of the line, found $IN",
        "EXT FOO                  | 2:8 expected (, found the end of the line",
        "EXT FOO(REAL :INOUT)     | 2:15 expected IN or OUT, found INOUT",
        "EXT FOO(REAL[3])         | 2:14 the dimensions of a parameter must be open, as in NAME[]",
        "EXTFCT FOO()             | 2:11 expected a name or [, found (",
        "IMPORT INT N             | 2:13 expected IS, found the end of the line",
        "IMPORT INT N IS X        | 2:17 expected /, found X",
        "IMPORT INT N IS /R1/X    | 2:22 expected / or .., found the end of the line",
        "CHANNEL A :B SER         | 2:9 expected :, found A",
      })
  void reportsABadDeclarationOnce(String line, String error) {
    assertThat(errors(routine(line))).containsExactly(error);
    assertThat(errors(dataList(line))).containsExactly(error);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "INT I=                   | 2:7 expected a value, found the end of the line",
        "INT I=5 6                | 2:9 expected a comma or the end of the line, found 6",
        "A[1]=                    | 2:6 expected a value, found the end of the line",
        "A:                       | 2:1 a data list contains only declarations, found A",
        "FOO(1)                   | 2:1 a data list contains only declarations, found FOO",
        "PTP P1                   | 2:1 a data list contains only declarations, found PTP",
        "IF A THEN                | 2:1 a data list contains only declarations, found IF",
        "INTERRUPT DECL 3 WHEN A DO B() | 2:1 a data list contains only declarations, found"
            + " INTERRUPT",
        "SLIN P1                  | 2:1 a data list contains only declarations, found SLIN",
      })
  void reportsABadLineOfADataListOnce(String line, String error) {
    assertThat(errors(dataList(line))).containsExactly(error);
  }

  @Test
  void refusesInitialValuesInARoutine() {
    assertThat(errors(routine("DECL INT I=5,J,K=6")))
        .containsExactly(
            "2:11 an initial value is allowed only in a data list",
            "2:17 an initial value is allowed only in a data list");
  }

  @Test
  void allowsDeclarationsBetweenThoseOfInterrupts() {
    Routine routine = onlyRoutine(routine("INT A\nINTERRUPT DECL 3 WHEN A DO B()\n\nINT C\nC=1"));

    assertThat(routine.declarations()).hasSize(2);
    assertThat(routine.body()).hasSize(2);
  }

  @Test
  void refusesDeclarationsBehindAStatement() {
    assertThat(errors(routine("A=1\nINT B\nINT C\nLOOP\nDECL INT D\nENDLOOP")))
        .containsExactly(
            "3:1 a declaration must precede the first statement",
            "6:1 a declaration must precede the first statement");
  }

  @Test
  void allowsANameOf24Characters() {
    assertThat(declarations(dataList("DECL INT A23456789012345678901234"))).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "INT I                    | Variables(false, false, INT, [Declarator(I, [], -)], )",
        "REAL A [ 2 , 3 ],B       | Variables(false, false, REAL, [Declarator(A, [2, 3], -),"
            + " Declarator(B, [], -)], )",
        "LOOP TO                  | Variables(false, false, LOOP, [Declarator(TO, [], -)], )",
        "INT A234567890123456789012345 | Variables(false, false, INT,"
            + " [Declarator(A234567890123456789012345, [], -)], )",
        "SIGNAL LOOP LOOP[1] to LOOP[2] | Signal(false, LOOP, LOOP[1], LOOP[2], )",
        "SIGNAL FALSE FALSE       | Signal(false, FALSE, -, -, )",
        "STRUC LOOP REAL A[2],TO, INT B | StrucDeclaration(false, LOOP,"
            + " [Component(REAL, Declarator(A, [2], -)), Component(REAL, Declarator(TO, [], -)),"
            + " Component(INT, Declarator(B, [], -))], )",
      })
  void readsASingleDeclarationWhoseNamesCanBeKeywords(String text, String tree) {
    List<KrlError> errors = new ArrayList<>();
    assertThat(show(KrlParser.parseDeclaration(text, errors::add).orElseThrow())).isEqualTo(tree);
    assertThat(errors).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "~~                       | expected one declaration without a comment",
        "INT A;B                  | expected one declaration without a comment",
        "~INT A\nINT B~           | expected one declaration without a comment",
        "INT                      | expected",
        "INT A B                  | expected",
        "DECL INT A               | expected",
        "INT A=5                  | an initial value is allowed only in a data list",
        "A[1]=5                   | expected a declaration, found A",
        "FOO()                    | expected a declaration, found FOO",
        "SIGNAL S $OUT[1] TO      | expected",
        "STRUC S                  | expected",
        "STRUC S X                | expected a type and a name, found X",
      })
  void refusesWhatIsNoSingleDeclaration(String text, String error) {
    List<KrlError> errors = new ArrayList<>();
    assertThat(KrlParser.parseDeclaration(text.replace("\\n", "\n"), errors::add)).isEmpty();
    assertThat(errors).singleElement().extracting(KrlError::message).asString().contains(error);
  }
}
