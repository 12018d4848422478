package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.FILE;
import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static no.hials.crosscom.lang.Snippets.statements;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.Expression.IntLiteral;
import no.hials.crosscom.lang.Expression.Step;
import no.hials.crosscom.lang.Expression.Variable;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.lang.Statement.MotionKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StatementTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "A=1                   | AssignmentStatement(A, 1)",
        "$OUT[3]=TRUE          | AssignmentStatement($OUT[3], true)",
        "A.B[2].C=\"X\"        | AssignmentStatement(A.B[2].C, \"X\")",
        "NAME[]=\"X\"          | AssignmentStatement(NAME[]+open, \"X\")",
        "SEC=5                 | AssignmentStatement(SEC, 5)",
        "SPL=5                 | AssignmentStatement(SPL, 5)",
        "STOP[1]=5             | AssignmentStatement(STOP[1], 5)",
        "FOO()                 | CallStatement(FOO, [])",
        "FOO( )                | CallStatement(FOO, [])",
        "BAS (#INITMOV,0 )     | CallStatement(BAS, [#INITMOV, 0])",
        "FOO(,1)               | CallStatement(FOO, [-, 1])",
        "COPEN(:SER_1, HANDLE) | CallStatement(COPEN, [:SER_1, HANDLE])",
        "CWRITE(H,S,M,\"%d\",I) | CallStatement(CWRITE, [H, S, M, \"%d\", I])",
        "PULSE($OUT[1],TRUE,0.5) | Pulse($OUT[1], true, 0.5)",
        "pulse ( $out[1], not a, t*2 ) | Pulse($out[1], (NOT a), (t MULTIPLY 2))",
        "L1:                   | Label(L1)",
        "RETURN                | Return(-)",
        "HALT                  | Halt()",
        "CONTINUE              | Continue()",
        "WAIT FOR $IN[1]==TRUE | WaitFor(($IN[1] EQUAL true))",
        "WAIT SEC 0            | WaitSec(0)",
        "WAIT SEC T*0.5        | WaitSec((T MULTIPLY 0.5))",
        "INTERRUPT DECL 3 WHEN A==B DO C(1)   | InterruptDeclaration(false, 3, (A EQUAL B), CallStatement(C, [1]))",
        "GLOBAL INTERRUPT DECL 4 WHEN A DO B=1 | InterruptDeclaration(true, 4, A, AssignmentStatement(B, 1))",
        "INTERRUPT DECL P WHEN A DO PULSE($OUT[1],TRUE,1) | InterruptDeclaration(false, P, A, Pulse($OUT[1], true, 1))",
        "INTERRUPT ON 3        | Interrupt(ON, 3)",
        "INTERRUPT OFF         | Interrupt(OFF, -)",
        "INTERRUPT ENABLE 3    | Interrupt(ENABLE, 3)",
        "INTERRUPT DISABLE N   | Interrupt(DISABLE, N)",
        "RESUME                | Resume()",
        "BRAKE                 | Brake(false)",
        "BRAKE F               | Brake(true)",
        "PTP XHOME             | MotionStatement(PTP, -, XHOME, -, [], -)",
        "PTP {A1 10} C_PTP     | MotionStatement(PTP, -, {A1 10}, -, [C_PTP], -)",
        "PTP P1 C_PTP C_DIS    | MotionStatement(PTP, -, P1, -, [C_PTP, C_DIS], -)",
        "PTP P1 C_DIS          | MotionStatement(PTP, -, P1, -, [C_DIS], -)",
        "PTP P1:OFFSET         | MotionStatement(PTP, -, (P1 GEOMETRIC OFFSET), -, [], -)",
        "LIN P1 C_DIS C_DIS    | MotionStatement(LIN, -, P1, -, [C_DIS], -)",
        "PTP F(1) C_PTP        | MotionStatement(PTP, -, F(1), -, [C_PTP], -)",
        "PTP_REL MYPOS C_PTP   | MotionStatement(PTP_REL, -, MYPOS, -, [C_PTP], -)",
        "LIN P1                | MotionStatement(LIN, -, P1, -, [], -)",
        "lin p[i] c_vel c_ori  | MotionStatement(LIN, -, p[i], -, [C_VEL, C_ORI], -)",
        "LIN_REL {X 10}        | MotionStatement(LIN_REL, -, {X 10}, -, [], -)",
        "LIN_REL {X 10} C_DIS #BASE | MotionStatement(LIN_REL, -, {X 10}, -, [C_DIS], #BASE)",
        "LIN_REL {X 10} #tool  | MotionStatement(LIN_REL, -, {X 10}, -, [], #tool)",
        "CIRC A,B              | MotionStatement(CIRC, A, B, -, [], -)",
        "CIRC A,B,CA 90 C_ORI  | MotionStatement(CIRC, A, B, 90, [C_ORI], -)",
        "CIRC CA,CA,CA -CA     | MotionStatement(CIRC, CA, CA, (MINUS CA), [], -)",
        "CIRC_REL A,B,CA 5 C_DIS #TOOL | MotionStatement(CIRC_REL, A, B, 5, [C_DIS], #TOOL)",
        "TRIGGER WHEN DISTANCE=0 DELAY=20 DO FOO() PRIO=-1 | Trigger(false, 0, false, 20, CallStatement(FOO, []), (MINUS 1))",
        "TRIGGER WHEN DISTANCE=1 DO A=1 | Trigger(false, 1, false, -, AssignmentStatement(A, 1), -)",
        "TRIGGER WHEN PATH=-5 DELAY=D DO PULSE($OUT[1],TRUE,1) | Trigger(true, (MINUS 5), false, D, Pulse($OUT[1], true, 1), -)",
        "TRIGGER WHEN PATH=50 ONSTART DELAY=0 DO FOO() PRIO=P | Trigger(true, 50, true, 0, CallStatement(FOO, []), P)",
        "ON_ERROR_PROCEED      | OnErrorProceed()",
        "ERR_RAISE(E)          | CallStatement(ERR_RAISE, [E])",
        "CONFIRM N             | Confirm(N)",
        "ANIN ON A=2*$ANIN[1]+1 | AnalogInput(A, ((2 MULTIPLY $ANIN[1]) PLUS 1))",
        "ANIN OFF A            | AnalogInput(A, -)",
        "ANOUT ON $ANOUT[1]=A*2 | AnalogOutput($ANOUT[1], (A MULTIPLY 2), -, -, -)",
        "ANOUT ON Q=A DELAY=-0.5 MINIMUM=0 MAXIMUM=1 | AnalogOutput(Q, A, (MINUS 0.5), 0, 1)",
        "ANOUT OFF $ANOUT[1]   | AnalogOutput($ANOUT[1], -, -, -, -)",
        "$CYCFLAG[1]=A AND B   | AssignmentStatement($CYCFLAG[1], (A AND B))",
        "SREAD(TEXT[],STATE,OFFSET,\"%d\",N) | CallStatement(SREAD, [TEXT[]+open, STATE, OFFSET, \"%d\", N])",
        "F(A,,,B,)             | CallStatement(F, [A, -, -, B, -])",
        "F(A+1, ,G(,1))        | CallStatement(F, [(A PLUS 1), -, G(-, 1)])",
        "STOP()                | CallStatement(STOP, [])",
        "STOP:                 | Label(STOP)",
        "START=END_X           | AssignmentStatement(START, END_X)",
        "WITH=PART+MINIMUM     | AssignmentStatement(WITH, (PART PLUS MINIMUM))",
      })
  void readsStatements(String line, String tree) {
    assertThat(show(statements(line))).isEqualTo("[" + tree + "]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "IF A THEN;B=1;ENDIF                | If(A, [AssignmentStatement(B, 1)], [])",
        "IF A THEN;ELSE;B=1;ENDIF           | If(A, [], [AssignmentStatement(B, 1)])",
        "SWITCH A;CASE 1;CASE 2,#X;HALT;ENDSWITCH | Switch(A, [Case([1], []), Case([2, #X], [Halt()])], -)",
        "SWITCH A;CASE \"B\";DEFAULT;HALT;ENDSWITCH | Switch(A, [Case([\"B\"], [])], [Halt()])",
        "FOR I=1 TO 5;HALT;ENDFOR           | For(I, 1, 5, -, [Halt()])",
        "FOR A[1].B=1 TO N-1 STEP -2;ENDFOR | For(A[1].B, 1, (N MINUS 1), (MINUS 2), [])",
        "WHILE A<5;EXIT;ENDWHILE            | While((A LESS 5), [Exit()])",
        "REPEAT;A=1;UNTIL A                 | Repeat([AssignmentStatement(A, 1)], A)",
        "LOOP;IF A THEN;EXIT;ENDIF;ENDLOOP  | Loop([If(A, [Exit()], [])])",
        "GOTO L;L:                          | Goto(L), Label(L)",
        "L:;LOOP;IF A THEN;goto l;ENDIF;ENDLOOP | Label(L), Loop([If(A, [Goto(l)], [])])",
      })
  void readsStatementsOfSeveralLines(String lines, String tree) {
    assertThat(show(statements(lines.replace(';', '\n')))).isEqualTo("[" + tree + "]");
  }

  @Test
  void givesStatementsTheirPlaces() {
    assertThat(statements("  LOOP\n    CIRC A,B,CA 90 C_DIS ; round\n  ENDLOOP"))
        .containsExactly(
            new Statement.Loop(
                at(2, 3),
                List.of(
                    new Statement.MotionStatement(
                        at(3, 5),
                        MotionKind.CIRC,
                        variable(10, "A"),
                        variable(12, "B"),
                        new IntLiteral(at(3, 17), 90),
                        Set.of(Approximation.C_DIS),
                        null))));
  }

  private static Position at(int line, int column) {
    return new Position(FILE, line, column);
  }

  private static Variable variable(int column, String name) {
    return new Variable(at(3, column), List.of(new Step(name, false, List.of(), false)));
  }

  @Test
  void readsTheValueOfAFunction() {
    ParseResult result = KrlParser.parse(FILE, "DEFFCT INT F()\nRETURN A+1\nENDFCT");

    assertThat(show(Snippets.onlyRoutine(result).body())).isEqualTo("[Return((A PLUS 1))]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "FOO                   | 2:1 unknown statement FOO: expected = or ( after it, found the end of the line",
        "FOO 5                 | 2:1 unknown statement FOO: expected = or ( after it, found 5",
        "GRIPPER OPEN          | 2:1 unknown statement GRIPPER; a type needs DECL before it",
        "VACUUM OFF X=1        | 2:1 unknown statement VACUUM; a type needs DECL before it",
        "5=A                   | 2:1 expected a statement or a declaration, found 5",
        "THEN                  | 2:1 expected a statement or a declaration, found THEN",
        ")                     | 2:1 expected a statement or a declaration, found )",
        "A.B                   | 2:4 expected =, found the end of the line",
        "A[1]()                | 2:5 expected =, found (",
        "FOO(1                 | 2:6 expected a comma or ), found the end of the line",
        "FOO() A               | 2:7 expected the end of the line, found A",
        "PULSE $OUT[1]         | 2:7 expected (, found $OUT",
        "PULSE(1,TRUE,1)       | 2:7 expected a name, found 1",
        "PULSE($OUT[1],TRUE)   | 2:19 expected a comma, found )",
        "L1: A=1               | 2:5 expected the end of the line, found A",
        "RETURN )              | 2:8 expected a value or the end of the line, found )",
        "HALT 5                | 2:6 expected the end of the line, found 5",
        "CONTINUE A            | 2:10 expected the end of the line, found A",
        "WAIT 5                | 2:6 expected FOR or SEC, found 5",
        "WAIT FOR              | 2:9 expected a value, found the end of the line",
        "WAIT SEC              | 2:9 expected a value, found the end of the line",
        "WAIT FOR A=B          | 2:11 expected the end of the line, found =",
        "INTERRUPT 3           | 2:11 expected DECL, DISABLE, ENABLE, OFF or ON, found 3",
        "INTERRUPT DECL 3 DO A() | 2:18 expected WHEN, found DO",
        "INTERRUPT DECL 3 WHEN A | 2:24 expected DO, found the end of the line",
        "INTERRUPT DECL 3 WHEN A DO HALT | 2:28 expected a name or PULSE, found HALT",
        "INTERRUPT DECL 3 WHEN A DO B | 2:29 expected = or (, found the end of the line",
        "GLOBAL INTERRUPT ON 3 | 2:1 GLOBAL is not allowed here",
        "DECL INTERRUPT DECL 3 WHEN A DO B() | 2:1 DECL is not allowed here",
        "RESUME 1              | 2:8 expected the end of the line, found 1",
        "BRAKE Q               | 2:7 expected F or the end of the line, found Q",
        "PTP                   | 2:4 expected a value, found the end of the line",
        "PTP P1 P2             | 2:8 expected C_DIS, C_ORI, C_PTP, C_VEL or the end of the line, found P2",
        "PTP P1 C_PTP C_DIS C_ORI | 2:20 expected the end of the line, found C_ORI",
        "PTP P1 WITH $VEL=1    | 2:8 expected C_DIS, C_ORI, C_PTP, C_VEL or the end of the line, found WITH",
        "LIN P1 C_PTP          | 2:8 expected C_DIS, C_ORI, C_VEL or the end of the line, found C_PTP",
        "LIN P1 #BASE          | 2:8 expected C_DIS, C_ORI, C_VEL or the end of the line, found #BASE",
        "LIN P1,P2             | 2:7 expected C_DIS, C_ORI, C_VEL or the end of the line, found ,",
        "LIN_REL {X 1} #FOO    | 2:15 expected #BASE or #TOOL, found #FOO",
        "LIN_REL {X 1} BASE    | 2:15 expected C_DIS, C_ORI, C_VEL, #BASE, #TOOL or the end of the line, found BASE",
        "CIRC P1               | 2:8 expected a comma, found the end of the line",
        "CIRC P1,P2,90         | 2:12 expected CA, found 90",
        "TRIGGER DISTANCE=0    | 2:9 expected WHEN, found DISTANCE",
        "TRIGGER WHEN X=0 DO A() | 2:14 expected DISTANCE or PATH, found X",
        "TRIGGER WHEN PATH=0 START DO A() | 2:21 expected DELAY, DO or ONSTART, found START",
        "TRIGGER WHEN DISTANCE=0 ONSTART DO A() | 2:25 expected DELAY or DO, found ONSTART",
        "ON_ERROR_PROCEED 1    | 2:18 expected the end of the line, found 1",
        "CONFIRM               | 2:8 expected a value, found the end of the line",
        "ANIN A=1              | 2:6 expected OFF or ON, found A",
        "ANOUT ON A            | 2:11 expected =, found the end of the line",
        "TRIGGER WHEN PATH=0 DO A() PRIO | 2:32 expected =, found the end of the line",
        "GOTO                  | 2:5 expected a name, found the end of the line",
        "GOTO NOWHERE          | 2:1 unknown label NOWHERE",
        "EXIT                  | 2:1 EXIT outside a loop",
        "RETURN 5              | 2:1 RETURN with a value in a DEF",
        "IF A                  | 2:5 expected THEN, found the end of the line",
        "IF THEN               | 2:4 expected a value, found THEN",
        "IF A THEN B=1         | 2:11 expected the end of the line, found B",
        "FOR 1 TO 5            | 2:5 expected a name, found 1",
        "FOR I TO 5            | 2:7 expected =, found TO",
        "FOR I=1 STEP 5        | 2:9 expected TO, found STEP",
        "FOR I=1 TO 5 FOO      | 2:14 expected STEP or the end of the line, found FOO",
        "WHILE                 | 2:6 expected a value, found the end of the line",
        "SWITCH                | 2:7 expected a value, found the end of the line",
        "LOOP 5                | 2:6 expected the end of the line, found 5",
      })
  void reportsABadStatementOnce(String line, String error) {
    assertThat(errors(routine(line))).containsExactly(error);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "L:;L:                    | 3:1 the label L is already in line 2",
        "L:;A=1;l:                | 4:1 the label l is already in line 2",
        "GOTO L;IF A THEN;L:;ENDIF | 2:1 GOTO into a block: the label L is in line 4",
        "IF A THEN;GOTO L;ELSE;L:;ENDIF | 3:1 GOTO into a block: the label L is in line 5",
        "SWITCH A;CASE 1;GOTO L;CASE 2;L:;ENDSWITCH | 4:1 GOTO into a block: the label L is in line 6",
        "IF A THEN;EXIT;ENDIF     | 3:1 EXIT outside a loop",
        "REPEAT;UNTIL             | 3:6 expected a value, found the end of the line",
        "SWITCH A;CASE;ENDSWITCH  | 3:5 expected a value, found the end of the line",
        "SWITCH A;CASE 1,;ENDSWITCH | 3:8 expected a value, found the end of the line",
        "IF A THEN;ENDIF B        | 3:7 expected the end of the line, found B",
      })
  void reportsAMistakeOfSeveralLinesOnce(String lines, String error) {
    assertThat(errors(routine(lines.replace(';', '\n')))).containsExactly(error);
  }

  @Test
  void wantsAValueOfAFunction() {
    assertThat(errors(KrlParser.parse(FILE, "DEFFCT INT F()\nRETURN\nENDFCT")))
        .containsExactly("2:1 RETURN without a value in a DEFFCT");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "ASYPTP {E1 5}          | ASYPTP",
        "ASYSTOP                | ASYSTOP",
        "ASYCONT                | ASYCONT",
        "ASYCANCEL 1            | ASYCANCEL",
      })
  void saysWhatIsNotSupported(String line, String word) {
    assertThat(errors(routine(line))).containsExactly("2:1 " + word + " is not supported");
  }
}
