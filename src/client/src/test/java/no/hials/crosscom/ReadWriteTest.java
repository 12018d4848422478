package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.charset.Charset;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComAccessException.Operation;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLBoolArray;
import no.hials.crosscom.KRL.KRLChar;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLIntArray;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.mock.FailedRead;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.E6Axis;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.Pos;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Reads and writes variables of every type. */
class ReadWriteTest extends RobotTest {
  private List<String> written() {
    return robot.requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(r -> r.name() + " = " + r.value())
        .toList();
  }

  @Test
  void scalarsAreReadAndWritten() throws Exception {
    KRLInt i = new KRLInt("MYINT");
    i.setValue(-7);
    client.writeVariable(i);
    KRLReal r = new KRLReal("MYREAL");
    r.setValue(27.0000057);
    client.writeVariable(r);
    KRLBool b = new KRLBool("MYBOOL");
    b.setValue(true);
    client.writeVariable(b);
    KRLEnum e = new KRLEnum("MYENUM");
    e.setValue("AUT");
    client.writeVariable(e);
    KRLChar c = new KRLChar("MYCHAR");
    c.setValue('x');
    client.writeVariable(c);
    KRLString s = new KRLString("MYSTRING");
    s.setValue("a, {b} #c");
    client.writeVariable(s);

    assertThat(written())
        .containsExactly(
            "MYINT = -7",
            "MYREAL = 27.000006",
            "MYBOOL = TRUE",
            "MYENUM = #AUT",
            "MYCHAR = \"x\"",
            "MYSTRING[] = \"a, {b} #c\"");
    for (KRLVariable variable : List.of(i, r, b, e, c, s)) {
      client.readVariable(variable);
    }
    assertThat(i.getValue()).isEqualTo(-7);
    assertThat(r.getValue()).as("the controller's own digits").isEqualTo(27.0000057);
    assertThat(b.getValue()).isTrue();
    assertThat(e.getValue()).isEqualTo("#AUT");
    assertThat(c.getValue()).isEqualTo('x');
    assertThat(s.getValue()).isEqualTo("a, {b} #c");
  }

  @Test
  @SuppressWarnings("NullAway") // on purpose
  void nullIsRefusedBeforeAnythingIsSent() {
    KRLIntArray ints = new KRLIntArray("MYINTS");
    ints.setValue(1, 2, 3);

    assertThatNullPointerException()
        .isThrownBy(() -> client.writeVariable(ints, null))
        .withMessage("progress");
    assertThatNullPointerException()
        .isThrownBy(() -> client.readVariable(ints, null))
        .withMessage("progress");
    assertThatNullPointerException()
        .isThrownBy(() -> client.readVariable(null))
        .withMessage("variable");
    assertThatNullPointerException()
        .isThrownBy(() -> client.writeVariable(null))
        .withMessage("variable");
    assertThatNullPointerException().isThrownBy(() -> client.async(null)).withMessage("function");
    assertThatNullPointerException().isThrownBy(() -> client.asyncRun(null)).withMessage("action");
    assertThatNullPointerException()
        .isThrownBy(() -> client.watch(Duration.ofMillis(5), null, "MYINT"))
        .withMessage("listener");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aVariableHasNoValueBeforeItIsReadOrSet() throws Exception {
    KRLInt i = new KRLInt("MYINT");

    assertThat(i.getValue()).isNull();
    assertThat(i.toString()).contains("value=null");
    assertThat(i.getReadTimeNano()).isEqualTo(-1);
    assertThatIllegalStateException()
        .isThrownBy(() -> client.writeVariable(i))
        .withMessage("MYINT has no value: it was neither set nor read");
    assertThatIllegalStateException()
        .isThrownBy(() -> client.writeVariable(new KRLIntArray("MYINTS")));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void theReadTimeIsThatOfTheLastAccess() throws Exception {
    KRLInt i = new KRLInt("MYINT");
    client.readVariable(i);

    assertThat(i.getReadTimeNano()).isPositive();
    assertThat(i.getReadTimeSec()).isEqualTo(i.getReadTimeNano() / 1e9);
    assertThat(i.getReadTimeMillis()).isEqualTo(i.getReadTimeNano() / 1_000_000);
  }

  @Test
  void anEmptyCharArrayIsTheEmptyText() throws Exception {
    KRLString s = new KRLString("MYSTRING[]");
    s.setValue("");
    client.writeVariable(s);
    s.setValue("other");
    client.readVariable(s);

    assertThat(s.getValue()).isEmpty();
    assertThat(written()).containsExactly("MYSTRING[] = \" \"");
  }

  @Test
  void wholeArraysAreReadInOneAccessAndWrittenElementByElement() throws Exception {
    KRLIntArray ints = new KRLIntArray("MYINTS");
    ints.setValue(1, 2, 3);
    client.writeVariable(ints);
    assertThat(written()).containsExactly("MYINTS[1] = 1", "MYINTS[2] = 2", "MYINTS[3] = 3");

    client.readVariable(ints);
    assertThat(ints.getValue()).containsExactly(1, 2, 3, 0, 0, 0, 0, 0, 0, 0);
    assertThat(robot.requests()).hasSize(4);

    KRLRealArray reals = new KRLRealArray("MYREALS[]");
    reals.setValue(1.5, -2.25);
    client.writeVariable(reals);
    client.readVariable(reals);
    assertThat(reals.getValue()).startsWith(1.5, -2.25, 0.0).hasSize(10);

    KRLBoolArray bools = new KRLBoolArray("MYBOOLS");
    bools.setValue(false, true);
    client.writeVariable(bools);
    client.readVariable(bools);
    assertThat(bools.getValue()).startsWith(false, true, false).hasSize(10);
    assertThat(bools.toString()).contains("value=[false, true, false,");
  }

  @Test
  void anArrayWriteThatIsRefusedNamesTheElementAndStops() throws Exception {
    KRLIntArray ints = new KRLIntArray("MYINTS");
    ints.setValue(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);

    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.writeVariable(ints))
        .satisfies(e -> assertThat(e.getVariable()).isEqualTo("MYINTS[11]"));
    assertThat(robot.variables().get("MYINTS[]")).startsWith("1 2 3 4 5 6 7 8 9 10");
    assertThat(robot.requests()).hasSize(11);
  }

  @Test
  void anyVariableCanBeReadAsATree() throws Exception {
    KRLAny load = new KRLAny("$LOAD");
    client.readVariable(load);

    assertThat(load.getValue()).isInstanceOf(KrlStruct.class);
    assertThat(((KrlStruct) load.getValue()).get("cm")).containsInstanceOf(KrlStruct.class);
    assertThat(client.readValue("$LOAD")).isEqualTo(load.getValue());
    assertThatExceptionOfType(UnsupportedOperationException.class)
        .isThrownBy(() -> client.writeVariable(load))
        .withMessageContaining("$LOAD is a read-only view");
  }

  @Test
  void textIsReadAndWrittenWithoutKnowingTheType() throws Exception {
    client.writeText("MYFRAME", "{X 1,Y -2.5}");

    assertThat(client.readText("MYFRAME"))
        .isEqualTo("{FRAME: X 1.00000, Y -2.50000, Z 0.0, A 0.0, B 0.0, C 0.0}");
    assertThat(client.readText("MYFRAME.Y")).isEqualTo("-2.50000");
  }

  @Test
  void aStructureIsWrittenWholeAndFieldsNeverSetAreZero() throws Exception {
    robot.variables().set("MYPOS", "{X 100.0,Z 300.0}");
    KRLE6Pos pos = new KRLE6Pos("MYPOS").setX(2).setE6(1e-7);
    pos.setS(6);
    client.writeVariable(pos);

    assertThat(robot.variables().get("MYPOS"))
        .isEqualTo(
            "{E6POS: X 2.00000, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0, S 6, T 0, E1 0.0, E2 0.0,"
                + " E3 0.0, E4 0.0, E5 0.0, E6 1.00000E-07}");
  }

  @Test
  void chosenFieldsAreWrittenAndTheOthersStayAsTheyAre() throws Exception {
    robot.variables().set("MYPOS", "{X 100.0,Z 300.0}");
    KRLPos pos = new KRLPos("MYPOS").setX(2).setY(1);
    client.writeFields(pos, "y", "X");

    assertThat(written()).containsExactly("MYPOS = {Y 1.0,X 2.0}");
    assertThat(robot.variables().get("MYPOS"))
        .startsWith("{E6POS: X 2.00000, Y 1.00000, Z 300.000");
    assertThat(pos.getZ()).as("not read").isZero();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.writeFields(pos, "Z"))
        .withMessageContaining("MYPOS.Z has no value");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.writeFields(pos, "Q"))
        .withMessageContaining("not Q");
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeFields(pos));
  }

  @Test
  void writingAStructureKeepsTheLocalCopy() throws Exception {
    KRLFrame frame = new KRLFrame("MYFRAME").setX(0.1);
    client.writeVariable(frame);

    assertThat(frame.getX()).isEqualTo(0.1);
    assertThat(frame.asArray()).containsExactly(0.1, 0, 0, 0, 0, 0);
  }

  @Test
  void aStructureKeepsFieldsThatAreNotItsOwnButDoesNotWriteThem() throws Exception {
    KRLE6Axis axes = new KRLE6Axis("$POS_ACT");
    client.readVariable(axes);

    assertThat(axes.getValue()).containsEntry("X", 525.0).containsEntry("S", 2.0);
    assertThat(axes.getValue().keySet()).startsWith("E1", "E2").doesNotContain("A1");
    assertThat(axes.getStringValue()).isEqualTo("{E1 0.0,E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}");
    assertThatIllegalStateException()
        .isThrownBy(axes::getA1)
        .withMessageContaining("$POS_ACT.A1 was not in the controller's answer");
  }

  static Stream<Arguments> structuresOfAnotherType() {
    return Stream.of(
        Arguments.of(new KRLE6Pos("$AXIS_ACT"), "found [A1, A2, A3, A4, A5, A6]"),
        Arguments.of(new KRLFrame("$AXIS_ACT"), "found [A1, A2, A3,"),
        Arguments.of(new KRLAxis("$TOOL"), "found [X, Y, Z, A, B, C]"),
        Arguments.of(new KRLE6Axis("$VEL"), "found [CP, ORI1, ORI2]"));
  }

  @ParameterizedTest
  @MethodSource("structuresOfAnotherType")
  void aStructureOfAnotherTypeIsRefused(KRLStruct variable, String reason) {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(variable))
        .withMessageContaining("the answer of the controller is not a value for")
        .withMessageContaining("expected fields of [")
        .withMessageContaining(reason);
  }

  @Test
  void aFrameIsReadIntoAnE6Pos() throws Exception {
    KRLE6Pos tool = new KRLE6Pos("$TOOL");
    client.readVariable(tool);

    assertThat(tool.asArrayXToZ()).containsExactly(0, 0, 0);
    assertThatIllegalStateException().isThrownBy(tool::getS);
  }

  @Test
  void anUninitialisedFieldIsAnErrorAndNoOldValue() throws Exception {
    robot.variables().declare("MYNEW", "FRAME", "{X 1.0,Y 2.0}");
    KRLFrame frame = new KRLFrame("MYNEW").setZ(99);
    client.readVariable(frame);

    assertThat(frame.getValue()).containsExactly(Map.entry("X", 1.0), Map.entry("Y", 2.0));
    assertThat(frame.isSet("X")).isTrue();
    assertThat(frame.isSet("Z")).isFalse();
    assertThatIllegalStateException().isThrownBy(frame::getZ);
    assertThatIllegalStateException().isThrownBy(frame::asArray);
    assertThat(frame.setZ(5).getZ()).isEqualTo(5);
  }

  @Test
  void jointAnglesThatAreMissingInTheAnswerAreAnErrorThatShowsTheOthers() {
    robot.enqueue(Fault.answer("{E6AXIS: A1 5.0}", Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(client::readJointAngles)
        .withMessage("$AXIS_ACT: the answer must have A1 to A6, is {A1 5.0}");
  }

  @Test
  void fieldsThatTheLastAnswerDidNotContainAreNotWrittenUnlessSetSince() throws Exception {
    robot.variables().declare("MYNEW", "E6AXIS", "{A1 5.0}");
    KRLE6Axis axes = new KRLE6Axis("MYNEW");
    client.readVariable(axes);
    axes.setA1(6);
    axes.setE1(7);
    client.writeVariable(axes);

    assertThat(written()).containsExactly("MYNEW = {A1 6.0,E1 7.0}");
    assertThat(robot.variables().get("MYNEW")).isEqualTo("{E6AXIS: A1 6.00000, E1 7.00000}");
  }

  @Test
  void aStructureWithoutAFieldToWriteIsNotSent() throws Exception {
    robot.enqueue(Fault.answer("{FRAME: }", Tail.SUCCESS));
    KRLFrame frame = new KRLFrame("MYFRAME").setX(1);
    client.readVariable(frame);

    assertThatIllegalStateException()
        .isThrownBy(() -> client.writeVariable(frame))
        .withMessageContaining("MYFRAME has no field to write");
    assertThat(written()).isEmpty();
  }

  @Test
  void aStructureOfTheProgramsOwnIsReadAndWritten() throws Exception {
    robot.variables().declareStruc("STRUC WELD REAL SPEED, INT SEAM, CHAR NAME[24]");
    robot.variables().declare("MYWELD", "WELD", "{SPEED 0.5,SEAM 1,NAME[] \"left, upper\"}");
    Weld weld = new Weld("MYWELD");
    client.readVariable(weld);

    assertThat(weld.fields)
        .containsExactly(
            Map.entry("SPEED", "0.500000"),
            Map.entry("SEAM", "1"),
            Map.entry("NAME[]", "\"left, upper\""));
    weld.setValue("SEAM", "12");
    client.writeVariable(weld);
    assertThat(written()).containsExactly("MYWELD = {SPEED 0.5,SEAM 12,NAME[] \"left, upper\"}");
  }

  private static final class Weld extends KRLStruct {
    private final HashMap<String, String> fields = new java.util.LinkedHashMap<>();

    Weld(String name) {
      super(name, new String[] {"SPEED", "SEAM", "NAME[]"});
    }

    @Override
    public HashMap<String, String> getValue() {
      return new java.util.LinkedHashMap<>(fields);
    }

    @Override
    public void setValue(String field, String text) {
      fields.put(field, text);
    }
  }

  @Test
  void aStructureIsSetFromARecordAndReturnsOne() {
    E6Pos e6pos = new E6Pos(1, 2, 3, 4, 5, 6, 2, 34, 7, 8, 9, 10, 11, 12);
    KRLE6Pos position = new KRLE6Pos("MYE6POS");
    position.setValue(e6pos);
    E6Axis e6axis = new E6Axis(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
    KRLE6Axis axes = new KRLE6Axis("MYE6AXIS");
    axes.setValue(e6axis);

    assertThat(position.toE6Pos()).isEqualTo(e6pos);
    assertThat(position.toPos()).isEqualTo(e6pos.pos());
    assertThat(position.toFrame()).isEqualTo(e6pos.frame());
    assertThat(axes.toE6Axis()).isEqualTo(e6axis);
    assertThat(axes.toAxis()).isEqualTo(e6axis.axis());
    position.setValue(new Pos(0, 0, 0, 0, 0, 0, 6, 3));
    axes.setValue(Axis.ZERO);
    assertThat(position.toE6Pos())
        .isEqualTo(new E6Pos(0, 0, 0, 0, 0, 0, 6, 3, 7, 8, 9, 10, 11, 12));
    assertThat(axes.toE6Axis()).isEqualTo(new E6Axis(0, 0, 0, 0, 0, 0, 7, 8, 9, 10, 11, 12));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> position.setValue(new Frame(1, 2, 3, 4, 5, 1e39)))
        .withMessageContaining("MYE6POS.C: ");
    assertThat(position.getX()).as("unchanged").isZero();
  }

  @Test
  void posActIsAnE6Pos() throws Exception {
    KRLE6Pos position = new KRLE6Pos("$POS_ACT");
    client.readVariable(position);

    assertThat(position.asArrayXToZ()).containsExactly(525, 0, 890);
    assertThat(position.asArrayAToC()).containsExactly(0, 90, 0);
    assertThat(position.getS()).isEqualTo(2);
    assertThat(position.getT()).isEqualTo(2);
    assertThat(position.asArrayE1ToE6()).containsExactly(0, 0, 0, 0, 0, 0);
  }

  @Test
  void jointTorquesAreThoseOfTheController() throws Exception {
    robot.variables().set("$TORQUE_AXIS_ACT[2]", "-12.5");

    assertThat(client.readJointTorques()).containsExactly(0, -12.5, 0, 0, 0, 0);
    assertThat(robot.requests()).hasSize(1);
  }

  @Test
  void jointTorquesThatCannotBeReadAreNotZero() throws Exception {
    robot.variables().remove("$TORQUE_AXIS_ACT");

    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(client::readJointTorques)
        .withMessageContaining("$TORQUE_AXIS_ACT[]");
  }

  @ParameterizedTest
  @EnumSource
  void anUnknownVariableIsAnExceptionThatNamesItWhateverTheServersWay(FailedRead way)
      throws Exception {
    try (MockServer other = MockServer.start(cfg -> cfg.failedRead(way));
        CrossComClient its = new CrossComClient(other.host(), other.port())) {
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> its.readText("NOSUCHVAR"))
          .withMessageContaining("the controller refused to read NOSUCHVAR")
          .satisfies(e -> assertThat(e.getVariable()).isEqualTo("NOSUCHVAR"))
          .satisfies(e -> assertThat(e.getOperation()).isEqualTo(Operation.READ))
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
      assertThat(its.readText("$OV_PRO")).as("the connection is usable").isEqualTo("100");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"NOSUCHVAR", "$POS_ACT.X", "MYBOOL", "MYPOS.Q", "MYINTS[11]", "MYINT"})
  void aRefusedWriteIsAnExceptionAndChangesNothing(String name) throws Exception {
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.writeText(name, "1.25"))
        .satisfies(e -> assertThat(e.getVariable()).isEqualTo(name))
        .satisfies(e -> assertThat(e.getOperation()).isEqualTo(Operation.WRITE))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(refusal()))
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    assertThat(client.readText("MYINT")).isEqualTo("0");
  }

  @Test
  void aRefusalSaysTheServersCodeItsNameAndTheLikelyCause() {
    robot.enqueue(
        Fault.answer("5", new Tail(2, 0)),
        Fault.answer("", new Tail(0, 0)),
        Fault.answer("", new Tail(77, 0)),
        Fault.answer("", new Tail(1, 0)));

    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.writeText("$ROBRUNTIME", "5"))
        .withMessageContaining("code 2 (ACCESS); likely cause: the variable is read-only")
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.ACCESS));
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readText("NOSUCHVAR"))
        .withMessageContaining("code 0 (GENERAL); likely cause: the variable is unknown");
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readText("NOSUCHVAR"))
        .withMessageContaining("code 77 (unknown)")
        .satisfies(e -> assertThat(e.getErrorCode()).isEmpty())
        .satisfies(e -> assertThat(e.getCode()).isEqualTo(77));
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readText("NOSUCHVAR"))
        .withMessageContaining("code 1 (the server gives no reason)");
  }

  @Test
  void aValueOfAnotherTypeIsAnExceptionWithItsTextAndKeepsTheLocalValue() throws Exception {
    KRLInt mode = new KRLInt("$MODE_OP");
    mode.setValue(5);

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(mode))
        .withMessageContaining("$MODE_OP")
        .withMessageContaining("not a value for INT")
        .withMessageContaining("expected an INT at position 0, found '#'")
        .satisfies(e -> assertThat(e.getText()).isEqualTo("#T1"))
        .satisfies(e -> assertThat(e.getVariable()).isEqualTo("$MODE_OP"));
    assertThat(mode.getValue()).isEqualTo(5);
    assertThat(client.readText("$OV_PRO")).as("the connection is usable").isEqualTo("100");
  }

  @Test
  void anAggregateWithOneWrongFieldChangesNoField() throws Exception {
    robot.enqueue(Fault.answer("{FRAME: X 1.0, Y TRUE}", Tail.SUCCESS));
    KRLFrame frame = new KRLFrame("MYFRAME").setX(7).setY(8);

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(frame));
    assertThat(frame.asArray()).containsExactly(7, 8, 0, 0, 0, 0);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"{FRAME: X 1.0, X 2.0}", "{X 1.0", "X 1.0", "{X 1.0} x", "{X 1E99}", "5", "\"a\""})
  void anAnswerThatIsNoAggregateIsAnException(String answer) throws Exception {
    robot.enqueue(Fault.answer(answer, Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(new KRLFrame("MYFRAME")))
        .satisfies(e -> assertThat(e.getText()).isEqualTo(answer));
  }

  @Test
  void aWriteWhoseEchoCannotBeReadSaysThatItWasDone() throws Exception {
    robot.enqueue(Fault.answer("??", Tail.SUCCESS));
    KRLInt i = new KRLInt("MYINT");
    i.setValue(3);

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeVariable(i))
        .withMessageContaining("the write was done")
        .satisfies(e -> assertThat(e.isSent()).isTrue());
    assertThat(i.getValue()).isEqualTo(3);
  }

  @Test
  void aWriteUpdatesTheLocalVariableFromTheAnswer() throws Exception {
    robot.enqueue(Fault.answer("9", Tail.SUCCESS));
    KRLInt i = new KRLInt("MYINT");
    i.setValue(3);
    client.writeVariable(i);

    assertThat(i.getValue()).isEqualTo(9);
  }

  @Test
  void aTextIsCheckedWithoutSendingAnything() throws Exception {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.checkText("MYFRAME", "{X 1.0" + " ".repeat(250) + "}"))
        .withMessageContaining("must have at most 255 bytes, has 257");
    assertThatIllegalArgumentException().isThrownBy(() -> client.checkText(" ", "1"));
    client.checkText("MYINT", "5");

    assertThat(robot.requests()).isEmpty();
    assertThat(robot.variables().get("MYINT")).isEqualTo("0");
  }

  @Test
  void anAggregateLongerThan255BytesIsNotSent() throws Exception {
    String text = "{X 1.0" + " ".repeat(250) + "}";
    assertThat(text).hasSize(257);

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeText("MYFRAME", text))
        .withMessageContaining("must have at most 255 bytes, has 257")
        .satisfies(e -> assertThat(e.getText()).isEqualTo(text))
        .satisfies(e -> assertThat(e.isSent()).isFalse());
    assertThat(robot.requests()).isEmpty();
    client.writeText("MYFRAME", "{X 1.0" + " ".repeat(248) + "}");
    assertThat(robot.variables().get("MYFRAME.X")).isEqualTo("1.00000");
  }

  @Test
  void theLimitOfAggregatesAndRequestsCanBeChanged() throws Exception {
    ClientConfig config =
        ClientConfig.create(
            robot.host(),
            cfg -> cfg.port(robot.port()).maxAggregateLength(0).maxRequestLength(100));
    try (CrossComClient other = new CrossComClient(config)) {
      assertThatExceptionOfType(CrossComValueException.class)
          .isThrownBy(() -> other.writeText("MYFRAME", "{X 1.0" + " ".repeat(250) + "}"))
          .withMessageContaining("a request must have at most 100 bytes, has 273");
    }
  }

  @Test
  void aFullE6PosOfAnyValuesFitsIntoOneWrite() throws Exception {
    KRLE6Pos pos = new KRLE6Pos("MYPOS");
    double worst = -1.17549435E-38;
    pos.setXToZ(worst, worst, worst);
    pos.setAToC(worst, worst, worst);
    pos.setS(63);
    pos.setT(4095);
    pos.setE1ToE6(worst, worst, worst, worst, worst, worst);
    client.writeVariable(pos);

    assertThat(written().get(0).length() - "MYPOS = ".length()).isLessThanOrEqualTo(255);
    client.readVariable(pos);
    assertThat(pos.getE6()).isEqualTo(worst);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, 3.5e38, -1e300})
  void aNumberThatNoFloatHoldsIsRefusedWhereItIsSet(double value) {
    assertThatIllegalArgumentException().isThrownBy(() -> new KRLReal("MYREAL").setValue(value));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLFrame("MYFRAME").setB(value))
        .withMessageContaining("MYFRAME.B");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLRealArray("MYREALS").setValue(1, value));
    KRLFrame frame = new KRLFrame("MYFRAME");
    assertThatIllegalArgumentException().isThrownBy(() -> frame.setXToZ(1, 2, value));
    assertThat(frame.getX()).as("all or nothing").isZero();
  }

  @Test
  void statusAndTurnMustBeWholeNumbers() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KRLPos("MYPOS").setS(2.5))
        .withMessage("MYPOS.S must be an INT, is 2.5");
  }

  /**
   * Types 0 and 1 give no reason (docs/reference/c3-messages.md#error-codes), in the way of each
   * server.
   */
  private ErrorCode refusal() {
    return server == ServerType.C3_BRIDGE ? ErrorCode.GENERAL : ErrorCode.SUCCESS;
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " "})
  void aNameThatCannotBeSentIsRefused(String name) {
    assertThatIllegalArgumentException().isThrownBy(() -> new KRLInt(name));
    assertThatIllegalArgumentException().isThrownBy(() -> client.readText(name));
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeText(name, "1"));
    assertThat(robot.requests()).isEmpty();
  }

  /** Restarts the server on a Windows with another code page. */
  private void codePage(int number, String charset) throws Exception {
    client.close();
    robot.close();
    robot = MockServer.start(cfg -> cfg.server(server).codePage(number));
    client = client(cfg -> cfg.charset(Charset.forName(charset)));
  }

  @ParameterizedTest
  @CsvSource({
    "1252, windows-1252, 5 µm € Größe",
    "1251, windows-1251, Привет",
    "1250, windows-1250, Łódź",
    "936, GBK, 你好"
  })
  void textsOfTheCodePageAreReadAndWrittenExactly(int page, String charset, String text)
      throws Exception {
    codePage(page, charset);
    robot.variables().declareStruc("STRUC LABEL CHAR TEXT[20], INT COUNT");
    robot.variables().declare("MYLABEL", "LABEL", "{TEXT[] \"x\",COUNT 1}");
    KRLString s = new KRLString("MYSTRING[]");
    s.setValue(text);
    client.writeVariable(s);
    assertThat(robot.variables().get("MYSTRING[]")).isEqualTo('"' + text + '"');
    client.writeText("MYLABEL", "{TEXT[] \"" + text + "\"}");
    assertThat(robot.variables().get("MYLABEL.TEXT[]")).isEqualTo('"' + text + '"');

    assertThat(s.getValue()).isEqualTo(text);
    KRLString copy = new KRLString("MYSTRING[]");
    client.readVariable(copy);
    assertThat(copy.getValue()).isEqualTo(text);
    assertThat(client.readText("MYSTRING[]")).isEqualTo('"' + text + '"');
    assertThat(client.readValue("MYSTRING[]")).isEqualTo(new KrlString(text));
    assertThat(client.readValue("MYLABEL").print()).contains('"' + text + '"');
    KRLAny any = new KRLAny("MYLABEL");
    assertThat(client.readVariables(any, copy)).allMatch(VariableResult::isOk);
    assertThat(copy.getValue()).isEqualTo(text);
    assertThat(client.simpleRead("MYSTRING[]")).endsWith('"' + text + '"');
  }

  @ParameterizedTest
  @ValueSource(ints = {936, 1251, 1252})
  void c3BridgeCarriesTextsOfAnyScriptOnEachCodePage(int page) throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    codePage(page, "windows-1252");
    for (String text : List.of("Größe", "ö", "你好", "Привет", "Łódź", "5 € ok?")) {
      client.writeText("MYSTRING[]", '"' + text + '"');
      assertThat(robot.variables().get("MYSTRING[]")).isEqualTo('"' + text + '"');
      assertThat(client.readText("MYSTRING[]")).isEqualTo('"' + text + '"');
    }
    assertThat(robot.requests())
        .extracting(r -> r.request().type())
        .doesNotContain(MessageType.WRITE);
  }

  @Test
  void anArrayOfNumbersOfUnknownTypeMayBeTooLongForUtf16() throws Exception {
    robot.variables().declare("MANY[6000]", "INT", "1000000");

    assertThat(client.readText("MANY[]")).startsWith("1000000 1000000").hasSizeGreaterThan(40_000);
  }

  @Test
  void whatTheCharsetLacksIsRefusedBeforeItIsSent() throws Exception {
    assumeThat(server).isEqualTo(ServerType.KUKAVARPROXY);
    KRLString s = new KRLString("MYSTRING[]");
    s.setValue("5 Ω");
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeVariable(s))
        .withMessageContaining("MYSTRING[]: the value cannot be sent: the charset for KUKAVARPROXY")
        .withMessageContaining("is windows-1252, which does not have Ω (U+03A9) at index 3")
        .satisfies(e -> assertThat(e.getText()).isEqualTo("\"5 Ω\""));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.readText("Ω"))
        .withMessageContaining("a variable's name cannot be sent: ");
    assertThatIllegalArgumentException().isThrownBy(() -> client.readVariable(new KRLInt("Ω")));
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeText("Ω", "1"));
    assertThat(requests()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"¥, U+00A5", "«, U+00AB", "‾, U+203E", "𠮷, U+20BB7"})
  void aCharacterThatTheCharsetWouldReplaceIsRefused(String character, String codePoint)
      throws Exception {
    assumeThat(server).isEqualTo(ServerType.KUKAVARPROXY);
    codePage(932, "windows-31j");
    String name = "LABEL" + character;

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeText("MYSTRING[]", "\"日" + character + "\""))
        .withMessageContaining(
            "which does not have " + character + " (" + codePoint + ") at index 2");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.readText(name))
        .withMessageContaining("does not have " + character + " (" + codePoint + ") at index 5");
    assertThat(requests()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-16", "ISO-2022-JP", "ISO-2022-KR", "IBM037"})
  void aCharsetWhoseBytesAreNotAsciiIsRefused(String charset) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ClientConfig.create("kr", c -> c.charset(Charset.forName(charset))))
        .withMessage("charset must have ASCII in the same bytes, is " + charset);
  }

  @Test
  void aByteThatTheCharsetLacksIsNotRead() throws Exception {
    assumeThat(server).isEqualTo(ServerType.KUKAVARPROXY);
    robot.fault(r -> r.name().equals("MYSTRING[]"), Fault.answer("\"a\u0081\"", Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readText("MYSTRING[]"))
        .withMessageContaining("windows-1252 has no character for the byte 81 at index 2");
    assertThat(client.readText("MYINT")).as("the connection is usable").isEqualTo("0");
  }

  @Test
  void aNameOutsideAsciiIsAskedForInUtf16() throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readText("Ω"))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.GENERAL));
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readVariable(new KRLInt("Ω")));
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.writeText("Ω", "1"));
  }

  @Test
  void aQuestionMarkIsReadAsItIs() throws Exception {
    client.writeText("MYSTRING[]", "\"ready?\"");

    assertThat(client.readText("MYSTRING[]")).isEqualTo("\"ready?\"");
    assertThat(client.readText("MYSTRING[]")).isEqualTo("\"ready?\"");
    assertThat(robot.requests())
        .extracting(RecordedRequest::name)
        .filteredOn("@PROXY_TYPE"::equals)
        .as("the server is asked for once")
        .hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"{A", "{A 1,B", "{A {B 1}", "{"})
  void anAggregateThatIsTooLongAndBrokenIsRefusedToo(String beginning) {
    String text = beginning + " ".repeat(300);
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeText("MYFRAME", text))
        .withMessageContaining("must have at most 255 bytes");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aNameThatMakesARequestTooLongIsRefused() {
    assumeThat(server).isEqualTo(ServerType.KUKAVARPROXY);
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readText("A".repeat(3000)))
        .withMessageContaining("a request must have at most 2048 bytes, has 3007");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void refusesANameThatIsTooLongForAMessageAndShowsItsBeginning() {
    String name = "LONGNAME".repeat(10_000);

    for (ThrowingCallable access :
        List.<ThrowingCallable>of(
            () -> client.readText(name),
            () -> client.writeText(name, "1"),
            () -> client.readVariable(new KRLInt(name)))) {
      assertThatIllegalArgumentException()
          .isThrownBy(access)
          .withMessage(
              "a variable's name must have at most 65532 characters, has 80000: "
                  + "LONGNAME".repeat(5)
                  + "...");
    }
  }
}
