package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/** A library and an interpreter of the robot, with some variables that programs can use. */
final class Rig {
  private static final String GLOBALS =
      """
      DEFDAT $TEST PUBLIC
      STRUC FRAME REAL X,Y,Z,A,B,C
      STRUC POS REAL X,Y,Z,A,B,C,INT S,T
      STRUC E6POS REAL X,Y,Z,A,B,C,INT S,T,REAL E1,E2,E3,E4,E5,E6
      STRUC AXIS REAL A1,A2,A3,A4,A5,A6
      STRUC E6AXIS REAL A1,A2,A3,A4,A5,A6,E1,E2,E3,E4,E5,E6
      STRUC INERTIA REAL X,Y,Z
      STRUC LOAD REAL M,FRAME CM,INERTIA J
      STRUC CP REAL CP,ORI1,ORI2
      STRUC APO INT CVEL,CPTP,REAL CDIS,CORI
      STRUC CONT INT CVEL,CPTP,REAL CDIS,CORI
      STRUC PART INT NUMBER,REAL SIZE,CHAR NAME[8],INT COUNTS[3]
      ENUM IPO_M BASE,TCP
      STRUC FDAT INT TOOL_NO,BASE_NO,IPO_M IPO_FRAME
      ENUM ORI VAR,CONSTANT
      ENUM APO_MODE_T CDIS,CPTP
      STRUC PDAT REAL VEL,ACC,APO_DIST,APO_MODE_T APO_MODE
      ENUM COLOUR RED,GREEN,BLUE
      BOOL $IN[16]
      BOOL $OUT[16]
      INT $TIMER[4]
      BOOL $STOPMESS=FALSE
      INT $ADVANCE=3
      DECL CONST INT LIMIT=7
      SIGNAL SENSOR $IN[5]
      SIGNAL GRIPPER $OUT[6]
      SIGNAL NIBBLE $OUT[1] TO $OUT[4]
      SIGNAL UNWIRED FALSE
      INT I=0
      INT J=0
      INT K=0
      REAL R=0.0
      BOOL B=FALSE
      CHAR C="x"
      DECL COLOUR COL=#RED
      INT EMPTY
      FRAME F={X 1.0,Y 2.0,Z 3.0,A 0.0,B 0.0,C 0.0}
      FRAME NOWHERE
      FRAME G={X 10.0,Y 0.0,Z 0.0,A 90.0,B 0.0,C 0.0}
      POS P={X 1.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0,S 2,T 34}
      E6POS EP
      E6AXIS XHOME={A1 0.0,A2 -90.0,A3 90.0,A4 0.0,A5 0.0,A6 0.0}
      INT ARR[5]
      INT GRID[2,3]
      DECL PART PARTS[3]
      CHAR TEXT[10]
      CHAR OTHER[10]
      CHAR ROWS[2,8]
      DECL APO BLEND
      DECL CONT ROUNDING={CVEL 1,CPTP 2,CDIS 3.0,CORI 4.0}
      ENDDAT
      """;

  final Scope globals = new Scope();
  final ProgramLibrary library =
      new ProgramLibrary(globals, Set.of("$IN", "$OUT", "$TIMER")::contains);
  final FakeRobot robot;
  final KrlInterpreter interpreter;

  Rig() {
    this(Interpreter.ROBOT);
  }

  Rig(Interpreter kind) {
    DataListLoader.load(
        (DataList) parse("test.dat", GLOBALS),
        new Scope(globals),
        globals,
        LoadingMode.STRICT,
        error -> {
          throw new AssertionError(error.toString());
        });
    set("$IN[]", "FALSE");
    set("$OUT[]", "FALSE");
    set("ARR[]", "0");
    robot = new FakeRobot(globals);
    interpreter = new KrlInterpreter(kind, robot);
  }

  static KrlFile parse(String name, String text) {
    ParseResult result = KrlParser.parse(name, text);
    assertThat(result.errors()).isEmpty();
    return result.file().orElseThrow();
  }

  // modules

  /** Loads a module; its file has its name. */
  Rig load(String source) {
    return load(source, null);
  }

  Rig load(String source, String data) {
    SourceFile file = (SourceFile) parse("test.src", source);
    DataList list = data == null ? null : (DataList) parse("test.dat", data);
    assertThat(library.put(file, list, LoadingMode.STRICT)).isEmpty();
    return this;
  }

  /** Loads a module without regard to the errors of the parser. */
  Rig loadLeniently(String source) {
    SourceFile file = (SourceFile) KrlParser.parse("test.src", source).file().orElseThrow();
    assertThat(library.put(file, null, LoadingMode.LENIENT)).isEmpty();
    return this;
  }

  /** Loads a module and returns its errors, with lines and columns. */
  List<String> errorsOf(String source) {
    SourceFile file = (SourceFile) parse("test.src", source);
    library.put(file, null, LoadingMode.STRICT);
    return library.check(file.name()).stream().map(KrlError::toString).toList();
  }

  /** Returns the errors of statements in a subprogram. */
  List<String> errorsIn(String body) {
    return errorsOf("DEF TEST()\n" + body + "\nEND\n");
  }

  // running

  Rig select(String module, KrlValue... arguments) {
    try {
      assertThat(interpreter.select(library.program(module), List.of(arguments))).isTrue();
    } catch (KrlFileException | KrlExecutionException e) {
      throw new AssertionError(e);
    }
    return this;
  }

  /** Loads, selects and starts a module. */
  Rig start(String source) {
    load(source);
    select(((SourceFile) parse("test.src", source)).name());
    assertThat(interpreter.start()).isTrue();
    return this;
  }

  Rig startSelected() {
    assertThat(interpreter.start()).isTrue();
    return this;
  }

  /** Lets cycles pass. */
  Rig cycles(int count) {
    for (int i = 0; i < count; i++) {
      robot.cycle();
      interpreter.run(10_000);
    }
    return this;
  }

  Rig cycle() {
    return cycles(1);
  }

  /** Ends the motion under way and lets a cycle pass. */
  Rig endMotion() {
    robot.endMotion();
    return cycle();
  }

  /** Executes a module to its end, which must come within a cycle. */
  Rig run(String source) {
    start(source).cycle();
    assertThat(robot.faults).isEmpty();
    assertThat(interpreter.state()).isEqualTo(ProgramState.END);
    return this;
  }

  /** Executes statements to their end. */
  Rig execute(String body) {
    return run("DEF TEST()\n" + body + "\nEND\n");
  }

  /** Executes a module that stops with a fault; returns number, line and text. */
  String faultOf(String source) {
    start(source).cycle();
    return fault();
  }

  /** Executes statements of which one fails. */
  String faultIn(String body) {
    return faultOf("DEF TEST()\n" + body + "\nEND\n");
  }

  /** Returns number, line and text of the message that the program has stopped with. */
  String fault() {
    assertThat(interpreter.state()).isEqualTo(ProgramState.STOP);
    assertThat(robot.faults).hasSize(1);
    FakeRobot.Fault fault = robot.faults.get(0);
    return fault.number() + " line " + fault.position().line() + ": " + fault.text();
  }

  int line() {
    return interpreter.levels().get(0).position().line();
  }

  // variables

  String get(String name) {
    try {
      return globals.read(VariablePath.parse(name)).printShort();
    } catch (RefusedException e) {
      return e.reason().name();
    }
  }

  Rig set(String name, String value) {
    try {
      globals.write(VariablePath.parse(name), KrlValue.parse(value), Scope.Writer.SYSTEM);
    } catch (RefusedException e) {
      throw new AssertionError(name + ": " + e.getMessage(), e);
    }
    return this;
  }
}
