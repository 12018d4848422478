package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import no.hials.crosscom.KRL.KRLRecord;
import no.hials.crosscom.KRL.KrlName;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.E6Axis;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.Load;
import no.hials.crosscom.protocol.value.Pos;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Reads and writes a user's own STRUCs as records. */
class KRLRecordTest extends RobotTest {

  private enum Mode {
    MANUAL,
    Automatic,
    @KrlName("TEACH_IN")
    TEACH
  }

  private record Seam(double x, int layers) {}

  private record Weld(double speed, int seam, String name, KRLFrame offset) {}

  private record Scalars(int i, float f, double d, boolean b, char c, String s, Mode mode) {}

  private record Nested(int id, Seam seam, @KrlName("seam_2") Seam second) {}

  @SuppressWarnings("ArrayRecordComponent")
  private record Arrays4(int[] ints, double[] reals, float[] floats, boolean[] bools, Mode[] m) {}

  private record Positions(KRLFrame frame, KRLPos pos, KRLE6Pos e6pos) {}

  private record Axes(KRLAxis axis, KRLE6Axis e6axis) {}

  private record Sparse(
      Optional<Integer> i, Optional<String> s, Optional<int[]> a, Optional<Seam> seam, int id) {}

  private record Checked(int percent) {
    Checked {
      if (percent > 100) {
        throw new IllegalArgumentException("percent must be at most 100, is " + percent);
      }
    }
  }

  private record Outer(Checked checked) {}

  @BeforeEach
  void declare() {
    detectServer();
    var variables = robot.variables();
    variables.declareEnum("MODE", "MANUAL", "AUTOMATIC", "TEACH_IN", "OTHER");
    variables.declareStruc("STRUC SEAM REAL X, INT LAYERS");
    variables.declareStruc("STRUC WELD REAL SPEED, INT SEAM, CHAR NAME[24], FRAME OFFSET");
    variables.declareStruc(
        "STRUC SCALARS INT I, REAL F, REAL D, BOOL B, CHAR C, CHAR S[200], MODE MODE");
    variables.declareStruc("STRUC NESTED INT ID, SEAM SEAM, SEAM SEAM_2");
    variables.declareStruc(
        "STRUC ARRAYS INT INTS[3], REAL REALS[2], REAL FLOATS[2], BOOL BOOLS[2], MODE M[2]");
    variables.declareStruc("STRUC POSITIONS FRAME FRAME, POS POS, E6POS E6POS");
    variables.declareStruc("STRUC AXES AXIS AXIS, E6AXIS E6AXIS");
    variables.declareStruc("STRUC SPARSE INT I, CHAR S[10], INT A[3], SEAM SEAM, INT ID");
    variables.declareStruc("STRUC CHECKED INT PERCENT");
    variables.declareStruc("STRUC OUTER CHECKED CHECKED");
    variables.declare(
        "MYWELD",
        "WELD",
        "{SPEED 0.5,SEAM 3,NAME[] \"left\",OFFSET {X 1,Y 2,Z 3.5,A 0,B 0,C -90}}");
    variables.declare(
        "MYSCALARS",
        "SCALARS",
        "{I -7,F 27.0000057,D 27.0000057,B TRUE,C \"x\",S[] \"a, {b} #c\",MODE #TEACH_IN}");
    variables.declare("MYNESTED", "NESTED", "{ID 1,SEAM {X 1.5,LAYERS 2},SEAM_2 {X 2.5,LAYERS 3}}");
    variables.declare(
        "MYARRAYS",
        "ARRAYS",
        "{INTS[] 1 -2 3,REALS[] 0.1 2,FLOATS[] 0.1 2,BOOLS[] TRUE FALSE,M[] #MANUAL #AUTOMATIC}");
    variables.declare("MYSPARSE", "SPARSE", "{ID 4}");
    variables.declare("MYCHECKED", "CHECKED", "{PERCENT 50}");
    variables.declare("MYOUTER", "OUTER", "{CHECKED {PERCENT 101}}");
  }

  private <T extends Record> T read(String name, Class<T> type) throws Exception {
    KRLRecord<T> variable = new KRLRecord<>(name, type);
    client.readVariable(variable);
    return variable.recordValue();
  }

  private <T extends Record> KRLRecord<T> write(String name, Class<T> type, T value)
      throws Exception {
    KRLRecord<T> variable = new KRLRecord<>(name, type);
    variable.setValue(value);
    client.writeVariable(variable);
    return variable;
  }

  /** Reads from a controller that answers with the given text. */
  private <T extends Record> T readText(String text, Class<T> type) throws Exception {
    robot.enqueue(Fault.answer(text, Tail.SUCCESS));
    return read("MYVAR", type);
  }

  private List<String> written() {
    return robot.requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(r -> r.name() + " = " + r.value())
        .toList();
  }

  private void assertUnreadable(String text, Class<? extends Record> type, String... messageParts) {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> readText(text, type))
        .satisfies(
            e -> {
              assertThat(e.getVariable()).isEqualTo("MYVAR");
              assertThat(e.getText()).isEqualTo(text);
              assertThat(e).hasMessageContainingAll(messageParts);
            });
  }

  @Test
  void aRecordIsReadInOneAccess() throws Exception {
    Weld weld = read("MYWELD", Weld.class);

    assertThat(weld.speed()).isEqualTo(0.5);
    assertThat(weld.seam()).isEqualTo(3);
    assertThat(weld.name()).isEqualTo("left");
    assertThat(weld.offset().getZ()).isEqualTo(3.5);
    assertThat(weld.offset().getC()).isEqualTo(-90);
    assertThat(weld.offset().getName()).isEqualTo("MYWELD.OFFSET");
    assertThat(robot.requests()).hasSize(1);
  }

  @Test
  void aRecordIsWrittenInOneAccess() throws Exception {
    KRLRecord<Weld> variable =
        write("MYWELD", Weld.class, new Weld(1.25, 7, "", new KRLFrame("F").setX(0.1)));

    assertThat(written())
        .containsExactly(
            "MYWELD = {SPEED 1.25,SEAM 7,NAME[] \" \","
                + "OFFSET {X 0.1,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}}");
    assertThat(robot.variables().get("MYWELD.OFFSET.X")).isEqualTo("0.100000");
    assertThat(variable.recordValue().name()).isEmpty();
    assertThat(variable.getReadTimeNano()).isPositive();
  }

  @Test
  void thereIsNoValueBeforeItIsReadOrSet() {
    KRLRecord<Weld> variable = new KRLRecord<>("MYWELD", Weld.class);

    assertThat(variable.getValue()).isNull();
    assertThat(variable.toString()).contains("value=null");
    assertThatIllegalStateException()
        .isThrownBy(variable::recordValue)
        .withMessage("MYWELD has no value: it was neither set nor read");
    assertThatIllegalStateException().isThrownBy(() -> client.writeVariable(variable));
    assertThatNullPointerException().isThrownBy(() -> variable.setValue(null));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void everyScalarTypeIsReadAndWritten() throws Exception {
    Scalars scalars = read("MYSCALARS", Scalars.class);

    assertThat(scalars)
        .isEqualTo(new Scalars(-7, 27.000006f, 27.0000057, true, 'x', "a, {b} #c", Mode.TEACH));

    write(
        "MYSCALARS",
        Scalars.class,
        new Scalars(Integer.MIN_VALUE, -0f, 1e-7, false, 'å', "ÿ", Mode.Automatic));
    assertThat(written())
        .containsExactly(
            "MYSCALARS = {I -2147483648,F 0.0,D 1.0E-07,B FALSE,C \"å\",S[] \"ÿ\","
                + "MODE #AUTOMATIC}");
    assertThat(read("MYSCALARS", Scalars.class).mode()).isEqualTo(Mode.Automatic);
  }

  @Test
  void nestedRecordsAreReadAndWritten() throws Exception {
    assertThat(read("MYNESTED", Nested.class))
        .isEqualTo(new Nested(1, new Seam(1.5, 2), new Seam(2.5, 3)));

    write("MYNESTED", Nested.class, new Nested(9, new Seam(0.25, 1), new Seam(-2, 0)));
    assertThat(robot.variables().get("MYNESTED"))
        .isEqualTo(
            "{NESTED: ID 9, SEAM {SEAM: X 0.250000, LAYERS 1}, SEAM_2 {SEAM: X -2.00000, LAYERS"
                + " 0}}");
  }

  @Test
  void arraysAreReadAndWritten() throws Exception {
    Arrays4 arrays = read("MYARRAYS", Arrays4.class);

    assertThat(arrays.ints()).containsExactly(1, -2, 3);
    assertThat(arrays.reals()).containsExactly(0.1, 2);
    assertThat(arrays.floats()).containsExactly(0.1f, 2f);
    assertThat(arrays.bools()).containsExactly(true, false);
    assertThat(arrays.m()).containsExactly(Mode.MANUAL, Mode.Automatic);

    write(
        "MYARRAYS",
        Arrays4.class,
        new Arrays4(
            new int[] {4, 5, 6},
            new double[] {-1, 0.25},
            new float[] {0.1f, 3},
            new boolean[] {false, true},
            new Mode[] {Mode.TEACH, Mode.MANUAL}));
    assertThat(written())
        .containsExactly(
            "MYARRAYS = {INTS[] 4 5 6,REALS[] -1.0 0.25,FLOATS[] 0.1 3.0,BOOLS[] FALSE TRUE,"
                + "M[] #TEACH_IN #MANUAL}");
    assertThat(read("MYARRAYS", Arrays4.class).m()).containsExactly(Mode.TEACH, Mode.MANUAL);
  }

  @SuppressWarnings("ArrayRecordComponent")
  private record Ints(int[] a, Optional<Boolean> b) {}

  @Test
  void aPartlyInitialisedArrayHasItsFirstElements() throws Exception {
    robot.variables().set("MYSPARSE", "{A[1] 5,A[2] 6}");
    assertThat(robot.variables().get("MYSPARSE")).contains("A[1] 5, A[2] 6");

    assertThat(read("MYSPARSE", Sparse.class).a().orElseThrow()).containsExactly(5, 6);
    assertThat(readText("{A[2] 2, B TRUE, A[1] 1}", Ints.class).a()).containsExactly(1, 2);
    assertThat(readText("{A[] 1}", Ints.class).a()).containsExactly(1);
    assertThat(readText("{X: A[] 1   2 , B TRUE}", Ints.class).a()).containsExactly(1, 2);
  }

  @Test
  void anArrayWithAGapNamesTheMissingElement() {
    assertUnreadable("{A[1] 1, A[3] 3}", Ints.class, "MYVAR.A[2] is missing");
    assertUnreadable("{A[2000000000] 1}", Ints.class, "MYVAR.A[2000000000] is not of");
    assertUnreadable("{A[200000000] 1}", Ints.class, "MYVAR.A[1] is missing");
    assertUnreadable("{A[1] 1, A[1] 3}", Ints.class, "MYVAR.A[1] occurs twice");
    assertUnreadable("{A[] 1, A[1] 3}", Ints.class, "MYVAR.A[1] occurs twice");
    assertUnreadable("{A[1] 1, A[] 3}", Ints.class, "MYVAR.A[] occurs twice");
    assertUnreadable("{A[1,2] 1}", Ints.class, "MYVAR.A[1,2] is not of", "expected A[]");
    assertUnreadable("{A[0] 1}", Ints.class, "MYVAR.A[0] is not of");
    assertUnreadable("{A 1}", Ints.class, "MYVAR.A is not of", "expected A[]");
    assertUnreadable("{A[1] TRUE}", Ints.class, "MYVAR.A[1]: expected an INT");
    assertUnreadable("{A[] 1 1.5}", Ints.class, "MYVAR.A[]: expected the end of an INT");
  }

  @Test
  void geometricTypesAreReadAndWritten() throws Exception {
    robot.variables().declare("MYPOSITIONS", "POSITIONS", null);
    KRLFrame frame = new KRLFrame("F");
    frame.setXToZ(1, 2, 3);
    KRLPos pos = new KRLPos("P").setX(4);
    pos.setS(2);
    pos.setT(34);
    write("MYPOSITIONS", Positions.class, new Positions(frame, pos, new KRLE6Pos("EP").setE6(5)));
    robot.variables().declare("MYAXES", "AXES", null);
    KRLAxis axis = new KRLAxis("A");
    axis.setA1(6);
    KRLE6Axis e6axis = new KRLE6Axis("EA");
    e6axis.setE1(7);
    write("MYAXES", Axes.class, new Axes(axis, e6axis));

    Positions positions = read("MYPOSITIONS", Positions.class);
    assertThat(positions.frame().asArrayXToZ()).containsExactly(1, 2, 3);
    assertThat(positions.pos().getT()).isEqualTo(34);
    assertThat(positions.e6pos().getE6()).isEqualTo(5);
    Axes axes = read("MYAXES", Axes.class);
    assertThat(axes.axis().getA1()).isEqualTo(6);
    assertThat(axes.e6axis().getE1()).isEqualTo(7);
  }

  private record Places(Frame frame, Pos pos, E6Pos e6pos) {}

  private record Angles(Axis axis, E6Axis e6axis) {}

  @Test
  void geometricTypesAreRecordsThatAreEqualByTheirValues() throws Exception {
    Places places =
        new Places(
            new Frame(1, 2, 3, 4, 5, 6),
            new Pos(0.1, 2, 3, 4, 5, 6, 2, 34),
            new E6Pos(1, 2, 3, 4, 5, 6, 6, 43, 7, 8, 9, 10, 11, 12.5));
    robot.variables().declare("MYPOSITIONS", "POSITIONS", null);
    write("MYPOSITIONS", Places.class, places);
    Angles angles =
        new Angles(Axis.of(1, 2, 3, 4, 5, 6), new E6Axis(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
    robot.variables().declare("MYAXES", "AXES", null);
    write("MYAXES", Angles.class, angles);

    assertThat(read("MYPOSITIONS", Places.class)).isEqualTo(places);
    assertThat(read("MYAXES", Angles.class)).isEqualTo(angles);
    assertUnreadable(
        "{FRAME {X 1,Y 1,Z 1,A 1,B 1,C 1}, POS {X 1,Y 1,Z 1,A 1,B 1,C 1,S 2}}",
        Places.class,
        "MYVAR.POS.T is missing");
  }

  @Test
  void aPositionAloneIsARecordToo() throws Exception {
    Load load = new Load(5.5, new Frame(1, 2, 3, 4, 5, 6), new Load.Inertia(0.1, 0.2, 0.3));
    assertThat(
            readText(
                "{LOAD: M 5.50000, CM {FRAME: X 1.00000, Y 2.00000, Z 3.00000, A 4.00000, B"
                    + " 5.00000, C 6.00000}, J {INERTIA: X 0.100000, Y 0.200000, Z 0.300000}}",
                Load.class))
        .isEqualTo(load);
    assertThat(readText("{E6AXIS: E1 7, A6 6, A5 5, a4 4, A3 3, A2 2, A1 1}", Axis.class))
        .isEqualTo(Axis.of(1, 2, 3, 4, 5, 6));
    assertThat(readText("{FRAME: X -0.0, Y 27.0000057, Z 0,A 0,B 0,C 0}", Frame.class))
        .isEqualTo(new Frame(0, 27.0000057, 0, 0, 0, 0));
    assertUnreadable("{FRAME: X 1, Y 2}", Frame.class, "MYVAR.Z is missing");
    assertUnreadable("{POS: X 1, X 2}", Pos.class, "MYVAR.X occurs twice");
    assertUnreadable("{POS: X TRUE}", Pos.class, "MYVAR.X: expected a REAL");
    assertUnreadable("{POS: S 2.5}", Pos.class, "MYVAR.S: expected the end of an INT");
    assertUnreadable("{POS: X 1} 2", Pos.class, "expected the end");
    assertUnreadable("12", Pos.class, "expected an aggregate in braces");
  }

  @Test
  void aPositionIsWrittenWithTheFieldsOfItsType() throws Exception {
    robot.variables().declare("MYPLACE", "E6POS", "{X 1,Y 1,Z 1,A 1,B 1,C 1,S 2,T 34,E1 9}");

    write("MYPLACE", Frame.class, new Frame(0.1, 2, 3, 4, 5, 6));
    KRLRecord<Pos> written = write("MYPLACE", Pos.class, new Pos(0.1, 2, 3, 4, 5, 6, 6, 3));

    assertThat(written())
        .containsExactly(
            "MYPLACE = {X 0.1,Y 2.0,Z 3.0,A 4.0,B 5.0,C 6.0}",
            "MYPLACE = {X 0.1,Y 2.0,Z 3.0,A 4.0,B 5.0,C 6.0,S 6,T 3}");
    assertThat(written.recordValue()).isEqualTo(new Pos(0.1, 2, 3, 4, 5, 6, 6, 3));
    assertThat(robot.variables().get("MYPLACE.E1")).isEqualTo("9.00000");
    KRLRecord<Frame> frame = new KRLRecord<>("MYPLACE", Frame.class);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> frame.setValue(new Frame(0, 0, 1e39, 0, 0, 0)))
        .withMessageContaining("MYPLACE.Z: ");
    assertThat(frame.getValue()).isNull();
  }

  @Test
  void theAnswerToAWriteUpdatesTheFieldsThatItNames() throws Exception {
    robot.enqueue(Fault.answer("{FRAME: X 5.5, Y 2.00000}", Tail.SUCCESS));

    KRLRecord<Frame> written = write("MYVAR", Frame.class, new Frame(1, 2, 3, 4, 5, 6));

    assertThat(written.recordValue()).isEqualTo(new Frame(5.5, 2, 3, 4, 5, 6));
  }

  private record Point(KRLE6Pos p) {}

  @Test
  void whatAPositionDoesNotHaveIsNotHandedOutAndNotWritten() throws Exception {
    robot.variables().declareStruc("STRUC POINT E6POS P");
    robot.variables().declare("MYPOINT", "POINT", "{P {X 1,Y 2,Z 3,A 4,B 5,C 27.0000057}}");
    KRLRecord<Point> variable = new KRLRecord<>("MYPOINT", Point.class);
    client.readVariable(variable);
    KRLE6Pos position = variable.recordValue().p();

    assertThat(position.getC()).as("the controller's own digits").isEqualTo(27.0000057);
    assertThatIllegalStateException()
        .isThrownBy(position::getS)
        .withMessageStartingWith("MYPOINT.P.S was not in the controller's answer");
    position.setX(9);
    client.writeVariable(variable);
    assertThat(written())
        .containsExactly("MYPOINT = {P {X 9.0,Y 2.0,Z 3.0,A 4.0,B 5.0,C 27.000006}}");
    assertThat(robot.variables().get("MYPOINT")).doesNotContain("S ");

    assertThatIllegalStateException()
        .isThrownBy(() -> readText("{P {E6POS: }}", Point.class).p().getX());
    robot.enqueue(Fault.answer("{P {E6POS: }}", Tail.SUCCESS));
    client.readVariable(variable);
    assertThat(variable.getStringValue()).isEqualTo("{P {}}");
  }

  @Test
  void aPositionHasTheFieldsOfItsTypeAndNumbersInThem() {
    assertUnreadable("{P {X 1, Q 2}}", Point.class, "MYVAR.P.Q is not a field of a KRLE6Pos");
    assertUnreadable("{P {X 1, Y TRUE}}", Point.class, "MYVAR.P.Y: expected a REAL");
    assertUnreadable("{P {X 1, Y 1E99}}", Point.class, "MYVAR.P.Y: expected a REAL within");
    assertUnreadable("{P 5}", Point.class, "MYVAR.P: expected an aggregate in braces");
    assertUnreadable("{P {X 1, X 2}}", Point.class, "MYVAR.P: expected field X once");
    assertUnreadable("{P {X 1, Y 2 3}}", Point.class, "MYVAR.P: expected ',' or '}'");
    KRLRecord<Weld> weld = new KRLRecord<>("MYWELD", Weld.class);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> weld.setValue(new Weld(1, 2, "", new KRLPos("P"))))
        .withMessage("MYWELD.OFFSET: must be a KRLFrame, is a KRLPos");
  }

  @Test
  void anOptionalComponentMayBeMissingAndIsThenNotWritten() throws Exception {
    KRLRecord<Sparse> variable = new KRLRecord<>("MYSPARSE", Sparse.class);
    client.readVariable(variable);
    Sparse empty =
        new Sparse(Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), 4);
    assertThat(variable.getValue()).isEqualTo(empty);
    client.writeVariable(variable);
    assertThat(written()).containsExactly("MYSPARSE = {ID 4}");
    assertThat(variable.getValue()).isEqualTo(empty);

    Sparse some =
        new Sparse(
            Optional.of(1), Optional.of("x"), Optional.empty(), Optional.of(new Seam(2, 3)), 4);
    write("MYSPARSE", Sparse.class, some);
    assertThat(read("MYSPARSE", Sparse.class)).isEqualTo(some);
    write("MYSPARSE", Sparse.class, empty);
    assertThat(read("MYSPARSE", Sparse.class)).as("left as it was").isEqualTo(some);
  }

  private record AllOptional(Optional<Integer> i) {}

  @Test
  void aRecordOfWhichNothingIsThereIsReadButNotWritten() throws Exception {
    KRLRecord<AllOptional> variable = new KRLRecord<>("MYVAR", AllOptional.class);
    robot.enqueue(Fault.answer("{X: }", Tail.SUCCESS));
    client.readVariable(variable);

    assertThat(variable.recordValue().i()).isEmpty();
    assertThatIllegalStateException()
        .isThrownBy(() -> client.writeVariable(variable))
        .withMessage("MYVAR has no field to write: all are empty");
  }

  @Test
  void aMissingFieldIsNamed() {
    assertUnreadable("{X 1.0}", Seam.class, "MYVAR.LAYERS is missing in the controller's answer");
    assertUnreadable(
        "{ID 1, SEAM {X 1.0}, SEAM_2 {X 1.0, LAYERS 1}}",
        Nested.class,
        "MYVAR.SEAM.LAYERS is missing");
    assertUnreadable("{ID 1, SEAM {X 1.0, LAYERS 1}}", Nested.class, "MYVAR.SEAM_2 is missing");
    assertUnreadable("{SPEED 1.0, SEAM 1, OFFSET {X 1.0}}", Weld.class, "MYVAR.NAME[] is missing");
  }

  @Test
  void aBrokenPartIsNamed() {
    assertUnreadable("{ID 1, SEAM {X 1.0 2}}", Nested.class, "MYVAR.SEAM: expected ','");
    assertUnreadable("{ID 1, SEAM {X TRUE}}", Nested.class, "MYVAR.SEAM.X: expected a REAL");
    assertUnreadable("{ID 1, SEAM 3}", Nested.class, "MYVAR.SEAM: expected an aggregate");
  }

  @Test
  void fieldsWithoutAComponentAreIgnored() throws Exception {
    assertThat(readText("{GAP 2, X 1.0, LAYERS 1, NOTE[] \"a, }\", N[1] TRUE}", Seam.class))
        .isEqualTo(new Seam(1, 1));
    assertThat(
            readText(
                "{ID 1, SEAM {X 1.0, LAYERS 1, P {FRAME: X 1, Q {R #B}}}, SEAM_2 {X 2, LAYERS 3}}",
                Nested.class))
        .isEqualTo(new Nested(1, new Seam(1, 1), new Seam(2, 3)));
    assertUnreadable("{X 1.0, LAYERS 1, GAP {A 1}", Seam.class, "expected ',' or '}'");
    assertUnreadable("{X 1.0, LAYERS 1, GAP \"}", Seam.class, "expected a closing double quote");
  }

  @Test
  void aFieldIsThereOnce() {
    assertUnreadable("{X 1.0, LAYERS 1, x 2}", Seam.class, "MYVAR.x occurs twice");
  }

  @Test
  void fieldsComeInAnyOrderAndCase() throws Exception {
    assertThat(readText(" { seam: layers 2,X 1 } ", Seam.class)).isEqualTo(new Seam(1, 2));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "I | 1.5 | expected the end of an INT",
        "I | 2147483648 | expected an INT of 32 bits",
        "I | TRUE | expected an INT at position 3, found 'T', in: {I TRUE}",
        "F | 1E39 | expected a REAL within",
        "F | 16777217 | expected an INT that a float can hold at position 3, found 16777217",
        "F | 'H1000001' | expected an INT that a float can hold",
        "F | #X | expected a REAL",
        "D | 1E39 | expected a REAL within",
        "D | \"1\" | expected a REAL",
        "B | 1 | expected TRUE or FALSE",
        "C | \"ab\" | expected one character in double quotes",
        "C | \"\" | expected one character in double quotes",
        "C | 1 | expected a text in double quotes",
        "S[] | 1 | expected a text in double quotes",
        "MODE | #OTHER | expected one of #MANUAL, #AUTOMATIC, #TEACH_IN at position 6, found"
            + " #OTHER",
        "MODE | #TEACH | expected one of #MANUAL, #AUTOMATIC, #TEACH_IN",
        "MODE | TRUE | expected an ENUM constant",
      })
  void aValueOfAnotherTypeOrThatDoesNotFitIsNamed(String field, String text, String problem) {
    assertUnreadable(
        "{" + field + " " + text + "}", Scalars.class, "MYVAR." + field + ": " + problem);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"S \"x\"", "S[1] \"x\"", "C[] \"x\"", "I[] 1", "I[1] 1", "MODE[] #MANUAL"})
  void anArrayIsNotTakenForAScalarNorAScalarForAnArray(String field) {
    assertUnreadable(
        "{" + field + "}", Scalars.class, "MYVAR." + field.replaceAll(" .*", "") + " is not of");
  }

  @Test
  void aFloatHoldsTheIntsAndRealsThatAreFloats() throws Exception {
    record F(float f) {}

    assertThat(readText("{F 16777216}", F.class).f()).isEqualTo(16777216f);
    assertThat(readText("{F 16777218}", F.class).f()).isEqualTo(16777218f);
    assertThat(readText("{F 'H2000000'}", F.class).f()).isEqualTo(33554432f);
    assertThat(readText("{F 1.23456789E+15}", F.class).f()).isEqualTo((float) 1.23456789E15);
    assertThat(readText("{F 16777217.0}", F.class).f()).isEqualTo(16777216f);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"5", "TRUE", "\"x\"", "{X 1.0,LAYERS 2", "{X 1.0,LAYERS 2} 3", "{X 1.0 2}"})
  void whatIsNoAggregateIsRefused(String text) {
    assertUnreadable(text, Seam.class, "expected ");
  }

  @Test
  void aRefusedReadLeavesTheValueAsItWas() throws Exception {
    KRLRecord<Seam> variable = new KRLRecord<>("MYNESTED.SEAM", Seam.class);
    client.readVariable(variable);
    robot.enqueue(Fault.answer("{X 7.0}", Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(variable))
        .withMessageContaining("MYNESTED.SEAM.LAYERS is missing");
    assertThat(variable.getValue()).isEqualTo(new Seam(1.5, 2));
  }

  @Test
  void aConstructorThatRefusesIsAnErrorOfTheField() throws Exception {
    assertThat(read("MYCHECKED", Checked.class)).isEqualTo(new Checked(50));
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> read("MYOUTER", Outer.class))
        .withMessageContaining("MYOUTER.CHECKED is refused by")
        .withMessageContaining("percent must be at most 100, is 101");
    assertThat(read("MYCHECKED", Checked.class).percent()).as("still usable").isEqualTo(50);
  }

  private static void assertRefused(ThrowingCallable set, String message) {
    assertThatIllegalArgumentException().isThrownBy(set).withMessageStartingWith(message);
  }

  @Test
  void whatCannotBeWrittenIsRefusedWhenItIsSet() {
    KRLRecord<Scalars> s = new KRLRecord<>("S", Scalars.class);
    assertRefused(
        () -> s.setValue(new Scalars(1, Float.NaN, 1, true, 'c', "s", Mode.MANUAL)),
        "S.F: a REAL must be finite, is NaN");
    assertRefused(
        () -> s.setValue(new Scalars(1, 1, 1e39, true, 'c', "s", Mode.MANUAL)),
        "S.D: a REAL is a 32-bit float");
    assertRefused(
        () -> s.setValue(new Scalars(1, 1, Double.NEGATIVE_INFINITY, true, 'c', "s", Mode.MANUAL)),
        "S.D: a REAL is a 32-bit float");
    assertRefused(
        () -> s.setValue(new Scalars(1, 1, 1, true, '"', "s", Mode.MANUAL)),
        "S.C: a CHAR array cannot hold a double quote");
    assertRefused(
        () -> s.setValue(new Scalars(1, 1, 1, true, 'c', "a\"b", Mode.MANUAL)),
        "S.S: a CHAR array cannot hold a double quote");
    assertRefused(
        () -> s.setValue(new Scalars(1, 1, 1, true, 'c', "s", null)), "S.MODE must not be null");
    assertThat(s.getValue()).isNull();

    KRLRecord<Nested> n = new KRLRecord<>("N", Nested.class);
    assertRefused(
        () -> n.setValue(new Nested(1, new Seam(1, 1), new Seam(Double.NaN, 1))),
        "N.SEAM_2.X: a REAL is a");
    KRLRecord<Ints> i = new KRLRecord<>("I", Ints.class);
    assertRefused(
        () -> i.setValue(new Ints(new int[0], Optional.empty())),
        "I.A: must have at least 1 element, has 0");
    assertRefused(() -> i.setValue(new Ints(new int[1], null)), "I.B must not be null");
    KRLRecord<Arrays4> a = new KRLRecord<>("A", Arrays4.class);
    assertRefused(
        () ->
            a.setValue(
                new Arrays4(
                    new int[1], new double[] {1, 1e39}, new float[1], new boolean[1], null)),
        "A.REALS[2]: a REAL is a");
    assertRefused(
        () ->
            a.setValue(
                new Arrays4(new int[1], new double[1], new float[1], new boolean[1], new Mode[1])),
        "A.M[1]: must not be null");
  }

  @Test
  void aRecordTooLongIsNotSentAndTheMessageSaysHowLongEachPartIs() throws Exception {
    String name = "n".repeat(230);
    KRLRecord<Weld> variable = new KRLRecord<>("MYWELD", Weld.class);
    variable.setValue(new Weld(0.5, 12, name, new KRLFrame("F").setX(1.25)));
    int length = variable.getStringValue().length();

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeVariable(variable))
        .withMessageContaining(
            "must have at most 255 bytes, has "
                + length
                + " (SPEED 9, SEAM 7, NAME[] 239, OFFSET 45 (X 6, Y 5, Z 5, A 5, B 5, C 5)): {");
    // and 2 braces and 3 commas
    assertThat(9 + 7 + 239 + 45 + 5).isEqualTo(length);
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aTextThatIsNoAggregateHasNoPartsToTellTheLengthOf() {
    String text = "{X 1.0" + " ".repeat(250);

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeText("MYFRAME", text))
        .withMessageContaining("has 256: {X");
  }

  @Test
  void aLongTextIsReadAllTheSame() throws Exception {
    String name = "n".repeat(2000);

    assertThat(readText("{SPEED 1.0,SEAM 1,NAME[] \"" + name + "\",OFFSET {X 1}}", Weld.class))
        .satisfies(w -> assertThat(w.name()).isEqualTo(name));
  }

  @Test
  void anEchoThatIsNotTheRecordSaysThatTheWriteWasDone() {
    KRLRecord<Seam> variable = new KRLRecord<>("MYNESTED.SEAM", Seam.class);
    variable.setValue(new Seam(1, 2));
    robot.enqueue(Fault.answer("{X 1.0}", Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeVariable(variable))
        .withMessageContaining("the write was done, but its answer is not a value")
        .withMessageContaining("MYNESTED.SEAM.LAYERS is missing")
        .withCauseInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void whatAProgramWroteIsWhatItReads() throws Exception {
    Random random = new Random(3);
    for (int i = 0; i < 500; i++) {
      Scalars scalars =
          new Scalars(
              random.nextInt(),
              anyFloat(random),
              anyFloat(random),
              random.nextBoolean(),
              anyChar(random),
              anyText(random),
              Mode.values()[random.nextInt(3)]);
      KRLRecord<Scalars> variable = write("MYSCALARS", Scalars.class, scalars);
      for (Scalars got : List.of(variable.recordValue(), read("MYSCALARS", Scalars.class))) {
        // a REAL has the digits of the text, and is the same float
        assertThat((float) got.d()).isEqualTo((float) scalars.d());
        assertThat(
                new Scalars(got.i(), got.f(), scalars.d(), got.b(), got.c(), got.s(), got.mode()))
            .isEqualTo(scalars);
      }
    }
  }

  private static float anyFloat(Random random) {
    while (true) {
      float f = Float.intBitsToFloat(random.nextInt());
      if (Float.isFinite(f) && f != 0) {
        return f;
      }
    }
  }

  /** Of ISO 8859-1, without the control characters from 80, which windows-1252 does not have. */
  private char anyChar(Random random) {
    char c = (char) (' ' + random.nextInt(0x100 - ' '));
    boolean unknown = c >= 0x80 && c <= 0x9F;
    return c == '"' || unknown ? '\'' : c;
  }

  private String anyText(Random random) {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(60); i > 0; i--) {
      text.append(anyChar(random));
    }
    return text.toString().equals(" ") ? "" : text.toString();
  }

  // --- classes that cannot be mapped

  private record NoComponents() {}

  private record Unmapped(int i, List<Integer> values) {}

  private record Long64(long n) {}

  @SuppressWarnings("ArrayRecordComponent")
  private record Rows(int[][] rows) {}

  @SuppressWarnings("ArrayRecordComponent")
  private record Texts(String[] texts) {}

  @SuppressWarnings("ArrayRecordComponent")
  private record Boxes(Integer[] boxes) {}

  private record Generic<V>(V v) {}

  private record Twice(int speed, @KrlName("Speed") int other) {}

  private record BadName(@KrlName("A[1]") int a) {}

  private record Loop(int i, Optional<Loop> next) {}

  private record InnerBad(int i, Long64 part) {}

  private enum Clash {
    A,
    @KrlName("a")
    B
  }

  private enum Unnamed {
    @KrlName("#A")
    A
  }

  private record WithClash(Clash clash) {}

  private record WithUnnamed(Unnamed e) {}

  @SuppressWarnings("rawtypes")
  private record RawOptional(Optional o) {}

  private static void assertUnmappable(Class<? extends Record> type, String... messageParts) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLRecord<>("X", type))
        .satisfies(
            e ->
                assertThat(e)
                    .hasMessageContaining(type.getTypeName())
                    .hasMessageContainingAll(messageParts));
  }

  @Test
  void aClassThatCannotBeMappedIsRefusedByTheConstructor() {
    assertUnmappable(Record.class, "is not a record");
    assertUnmappable(NoComponents.class, "has no components");
    assertUnmappable(
        Unmapped.class,
        "component values of ",
        "is of type java.util.List<java.lang.Integer>, which maps");
    assertUnmappable(Long64.class, "component n of ", "is of type long, which maps to no KRL type");
    assertUnmappable(Rows.class, "component rows of ", "int[][]");
    assertUnmappable(Texts.class, "component texts of ", "java.lang.String[]");
    assertUnmappable(Boxes.class, "component boxes of ", "java.lang.Integer[]");
    assertUnmappable(Generic.class, "component v of ", "is of type V");
    assertUnmappable(RawOptional.class, "component o of ", "is a raw Optional, which");
    assertUnmappable(Twice.class, "component other of ", "has the name SPEED, as another");
    assertUnmappable(BadName.class, "component a of ", "has the @KrlName \"A[1]\"");
    assertUnmappable(Loop.class, "component next of ", "which contains it");
    assertUnmappable(WithClash.class, "component clash of ", "has the name A twice");
    assertUnmappable(WithUnnamed.class, "component e of ", "whose A has no KRL name");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLRecord<>("X", InnerBad.class))
        .withMessageContaining("component n of " + Long64.class.getTypeName());
  }

  @Test
  void aRecordOfANamedModuleThatIsNotOpenIsRefused() {
    // the JDK has a record in a package that it does not export
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLRecord<>("X", hidden()))
        .withMessageContaining("cannot be reached; its module must open package ");
  }

  private static Class<? extends Record> hidden() throws ClassNotFoundException {
    return Class.forName("sun.security.pkcs.SignerInfo$AlgorithmInfo").asSubclass(Record.class);
  }

  @Test
  void aNameWithKrlNameIsTheOnlyOneOfAComponent() {
    assertUnreadable(
        "{ID 1, SEAM {X 1.0, LAYERS 1}, SECOND {X 1.0, LAYERS 1}}",
        Nested.class,
        "MYVAR.SEAM_2 is missing in the controller's answer");
  }

  @Test
  void anAnswerThatAProgramSimulatesIsReadToo() {
    KRLRecord<Seam> variable = new KRLRecord<>("MYSEAM", Seam.class);
    update(variable, "{X 1.0,LAYERS 2}");

    assertThat(variable.toString()).contains("value=Seam[x=1.0, layers=2]");
    assertThatExceptionOfType(KrlSyntaxException.class).isThrownBy(() -> update(variable, "5"));
  }

  @SuppressWarnings("deprecation")
  private static void update(KRLRecord<?> variable, String text) {
    variable.update(variable.getId(), text, 1);
  }

  @Test
  void framesAndArraysOfAWrittenRecordStayThoseOfTheProgram() throws Exception {
    record Joint(int seam, KRLFrame offset) {}

    robot.variables().declareStruc("STRUC SEAMTYPE INT SEAM, FRAME OFFSET");
    robot.variables().declare("MYSEAM", "SEAMTYPE", null);
    KRLFrame offset = new KRLFrame("OFFSET").setX(1);
    KRLRecord<Joint> seam = new KRLRecord<>("MYSEAM", Joint.class);
    seam.setValue(new Joint(1, offset));
    client.writeVariable(seam);
    offset.setX(7);
    client.writeVariable(seam);

    assertThat(robot.variables().get("MYSEAM.OFFSET.X")).isEqualTo("7.00000");
    assertThat(seam.recordValue().offset()).isSameAs(offset);
  }
}
