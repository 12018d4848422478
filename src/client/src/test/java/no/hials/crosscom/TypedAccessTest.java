package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.util.List;
import java.util.Optional;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KrlName;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.E6Axis;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.Load;
import no.hials.crosscom.protocol.value.Pos;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Reads and writes variables as Java values. */
class TypedAccessTest extends RobotTest {
  private enum Mode {
    T1,
    T2,
    AUT,
    @KrlName("EX")
    EXTERNAL
  }

  private record Seam(double x, int layers) {}

  @SuppressWarnings("ArrayRecordComponent")
  private record Weld(
      double speed, String name, Seam seam, int[] counts, Frame offset, Optional<Integer> gap) {}

  private record Speed(double speed) {}

  private List<String> written() {
    return robot.requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(r -> r.name() + " = " + r.value())
        .toList();
  }

  private void declareWeld() {
    robot.variables().declareStruc("STRUC SEAM REAL X, INT LAYERS, BOOL DONE");
    robot
        .variables()
        .declareStruc(
            "STRUC WELD REAL SPEED, CHAR NAME[24], SEAM SEAM, INT COUNTS[2], FRAME OFFSET,"
                + " INT GAP");
    robot
        .variables()
        .declare(
            "MYWELD",
            "WELD",
            "{SPEED 0.1,NAME[] \"left\",SEAM {X 1.5,LAYERS 2,DONE TRUE},COUNTS[] 3 4,"
                + "OFFSET {X 1,Y 2,Z 3,A 4,B 5,C 6}}");
  }

  @Test
  void scalarsAreReadAndWritten() throws Exception {
    client.writeInt("MYINT", -7);
    client.writeReal("MYREAL", 27.0000057);
    client.writeBool("MYBOOL", true);
    client.writeString("MYSTRING[]", "a, {b} #c");
    client.writeEnum("MYENUM", Mode.EXTERNAL);

    assertThat(written())
        .containsExactly(
            "MYINT = -7",
            "MYREAL = 27.000006",
            "MYBOOL = TRUE",
            "MYSTRING[] = \"a, {b} #c\"",
            "MYENUM = #EX");
    assertThat(client.readInt("MYINT")).isEqualTo(-7);
    assertThat(client.readReal("MYREAL")).isEqualTo(27.0000057);
    assertThat(client.readReal("MYINT")).isEqualTo(-7);
    assertThat(client.readBool("MYBOOL")).isTrue();
    assertThat(client.readString("MYSTRING[]")).isEqualTo("a, {b} #c");
    assertThat(client.readEnum("MYENUM", Mode.class)).isEqualTo(Mode.EXTERNAL);
    assertThat(client.read("MYCHAR", Character.class)).isEqualTo('A');
    assertThat(client.read("MYENUM", KrlValue.class)).isEqualTo(new KrlEnum("EX"));
  }

  @Test
  void aValueOfAnotherTypeIsReportedWithTheTypeAskedFor() {
    assertNoValueFor("INT", () -> client.readInt("$MODE_OP"));
    assertNoValueFor("REAL", () -> client.readReal("$MODE_OP"));
    assertNoValueFor("BOOL", () -> client.readBool("$MODE_OP"));
    assertNoValueFor("Mode", () -> client.readEnum("$OV_PRO", Mode.class));
  }

  private static void assertNoValueFor(String type, ThrowingCallable read) {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(read)
        .withMessageContaining("the answer of the controller is not a value for " + type + ": ")
        .withCauseInstanceOf(KrlSyntaxException.class);
  }

  @Test
  void aRealIsTheDoubleNearestToItsDigits() throws Exception {
    client.writeReal("MYREAL", 0.1);

    assertThat(client.readReal("MYREAL")).isEqualTo(0.1);
    assertThat((float) client.readReal("MYREAL")).isEqualTo(0.1f);
  }

  @Test
  void wholeArraysAreReadInOneAccess() throws Exception {
    client.writeIntArray("MYINTS", 4, 5);
    robot.clearRequests();

    assertThat(client.readIntArray("MYINTS")).startsWith(4, 5);
    assertThat(client.readRealArray("$TORQUE_AXIS_ACT[]")).hasSizeGreaterThanOrEqualTo(6);
    assertThat(robot.requests()).hasSize(2);

    robot.variables().declare("MYREALS[2]", "REAL", null);
    robot.variables().declare("MYBOOLS[2]", "BOOL", null);
    client.writeRealArray("MYREALS", 0.1, 2);
    client.writeBoolArray("MYBOOLS[]", true, false);
    assertThat(client.readRealArray("MYREALS[]")).containsExactly(0.1, 2);
    assertThat(client.readBoolArray("MYBOOLS")).containsExactly(true, false);
  }

  @Test
  void positionsAreRecords() throws Exception {
    Load load = new Load(5.5, new Frame(1, 2, 3, 4, 5, 6), new Load.Inertia(0.1, 0.2, 0.3));
    robot.variables().declare("MYPOS", "POS", null);
    robot.variables().declare("MYE6POS", "E6POS", null);
    robot.variables().declare("MYAXIS", "AXIS", null);
    robot.variables().declare("MYE6AXIS", "E6AXIS", null);
    E6Pos e6pos = new E6Pos(0.1, 2, 3, 4, 5, 6, 2, 34, 7, 8, 9, 10, 11, 12);
    E6Axis e6axis = new E6Axis(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);

    client.write("$BASE", e6pos.frame());
    client.write("MYPOS", e6pos.pos());
    client.write("MYE6POS", e6pos);
    client.write("MYAXIS", e6axis.axis());
    client.write("MYE6AXIS", e6axis);
    client.write("$LOAD", load);

    assertThat(client.read("$BASE", Frame.class)).isEqualTo(e6pos.frame());
    assertThat(client.read("MYPOS", Pos.class)).isEqualTo(e6pos.pos());
    assertThat(client.read("MYE6POS", E6Pos.class)).isEqualTo(e6pos);
    assertThat(client.read("MYAXIS", Axis.class)).isEqualTo(e6axis.axis());
    assertThat(client.read("MYE6AXIS", E6Axis.class)).isEqualTo(e6axis);
    assertThat(client.read("$LOAD", Load.class)).isEqualTo(load);
    assertThat(client.read("MYE6POS", Frame.class)).as("a part").isEqualTo(e6pos.frame());
  }

  @Test
  void aStrucIsARecordOfTheProgramWithoutSomeFields() throws Exception {
    declareWeld();

    Weld weld = client.read("MYWELD", Weld.class);
    assertThat(weld.speed()).isEqualTo(0.1);
    assertThat(weld.name()).isEqualTo("left");
    assertThat(weld.seam()).isEqualTo(new Seam(1.5, 2));
    assertThat(weld.counts()).containsExactly(3, 4);
    assertThat(weld.offset()).isEqualTo(new Frame(1, 2, 3, 4, 5, 6));
    assertThat(weld.gap()).isEmpty();

    client.write(
        "MYWELD",
        new Weld(0.2, "", new Seam(2, 3), new int[] {5, 6}, Frame.IDENTITY, Optional.of(7)));
    assertThat(robot.variables().get("MYWELD"))
        .contains("SPEED 0.200000", "NAME[] \" \"", "LAYERS 3, DONE TRUE", "5 6", "GAP 7");
    client.write("MYWELD", new Speed(1.5));
    assertThat(client.read("MYWELD", Speed.class)).isEqualTo(new Speed(1.5));
    assertThat(robot.variables().get("MYWELD.GAP")).isEqualTo("7");
  }

  @Test
  void aRecordOfNumbersIsReadWithoutAskingForTheKindOfServer() throws Exception {
    declareWeld();

    client.read("$POS_ACT", E6Pos.class);
    client.read("$LOAD", Load.class);
    client.read("MYWELD", Speed.class);

    assertThat(robot.requests())
        .extracting(RecordedRequest::name)
        .containsExactly("$POS_ACT", "$LOAD", "MYWELD");
  }

  @Test
  void aVariableThatIsReadIsReturned() throws Exception {
    KRLReal variable = new KRLReal("$OV_PRO");

    assertThat(client.read(variable)).isSameAs(variable);
    assertThat(client.read(new KRLInt("$OV_PRO")).intValue()).isEqualTo(100);
  }

  private static void assertRefused(ThrowingCallable read) {
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(read)
        .satisfies(e -> assertThat(e.getVariable()).startsWith("NOSUCH"));
  }

  @Test
  void aRefusedReadIsAnExceptionAndNoValue() {
    assertRefused(() -> client.readReal("NOSUCH"));
    assertRefused(() -> client.readInt("NOSUCH"));
    assertRefused(() -> client.readBool("NOSUCH"));
    assertRefused(() -> client.readString("NOSUCH[]"));
    assertRefused(() -> client.readEnum("NOSUCH", Mode.class));
    assertRefused(() -> client.readRealArray("NOSUCH"));
    assertRefused(() -> client.read("NOSUCH", E6Pos.class));
    assertRefused(() -> client.read("NOSUCH", Speed.class));
    assertRefused(() -> client.read("NOSUCH", KrlValue.class));
    assertRefused(() -> client.read(new KRLReal("NOSUCH")));
    assertRefused(() -> client.writeReal("NOSUCH", 1));
    assertRefused(() -> client.write("NOSUCH", Frame.IDENTITY));
  }

  private static void assertNoValue(ThrowingCallable read, String message) {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(read)
        .withMessageContaining(message);
  }

  @Test
  void aValueOfAnotherTypeIsAnException() {
    assertNoValue(() -> client.readInt("MYREAL"), "MYREAL: the answer of the controller is not");
    assertNoValue(() -> client.readReal("MYBOOL"), "expected a REAL");
    assertNoValue(() -> client.readBool("MYINT"), "expected TRUE or FALSE");
    assertNoValue(() -> client.readString("MYINTS[1]"), "expected a text in double quotes");
    assertNoValue(() -> client.readEnum("MYINT", Mode.class), "expected an ENUM constant");
    assertNoValue(() -> client.readRealArray("MYSTRING[]"), "expected a REAL");
    assertNoValue(() -> client.read("$AXIS_ACT", Frame.class), "$AXIS_ACT.X is missing");
    assertNoValue(() -> client.read("$POS_ACT.X", Frame.class), "not a value for Frame: ");
  }

  @Test
  void aValueOfAnEnumWithoutAConstantIsAnException() throws Exception {
    robot.enqueue(Fault.answer("#OTHER", Tail.SUCCESS));

    assertNoValue(
        () -> client.readEnum("MYENUM", Mode.class),
        "MYENUM: the answer of the controller must be one of #T1, #T2, #AUT, #EX, is #OTHER");
    assertThat(client.readInt("MYINT")).as("the connection can be used").isZero();
  }

  @Test
  void aMissingFieldIsAnExceptionThatNamesIt() {
    robot.variables().declare("MYPOS", "POS", "{X 1,Y 2,Z 3,A 4,B 5,C 6,S 2}");

    assertNoValue(() -> client.read("MYPOS", Pos.class), "MYPOS.T is missing");
  }

  private record Unmapped(List<String> names) {}

  private enum Unnamed {
    @KrlName("not a name")
    ONE
  }

  @Test
  void aTypeThatMapsToNoneIsRefusedBeforeAnythingIsSent() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.read("MYINT", Long.class))
        .withMessage(
            "MYINT: the Java type must be one of Boolean, Character, Double, Integer, KrlValue,"
                + " String, boolean[], double[], int[], an enum or a record, is java.lang.Long");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.read("MYINT", Unmapped.class))
        .withMessageContaining("component names of");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.readEnum("MYENUM", Unnamed.class))
        .withMessageMatching("MYENUM is of type .*Unnamed, whose ONE has no KRL name");
    assertThatIllegalArgumentException().isThrownBy(() -> client.handle(" ", Integer.class));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aValueThatNoControllerHasIsRefusedBeforeAnythingIsSent() {
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeReal("MYREAL", 1e39));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.write("$BASE", new Frame(0, 1e39, 0, 0, 0, 0)))
        .withMessageContaining("$BASE.Y: ");
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeString("MYSTRING[]", "\""));
    assertThatIllegalArgumentException().isThrownBy(() -> client.writeIntArray("MYINTS"));
    assertThatNullPointerException().isThrownBy(() -> client.writeString("MYSTRING[]", null));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void severalHandlesAreReadInAsFewMessagesAsTheServerAllows() throws Exception {
    Handle<E6Pos> position = client.handle("$POS_ACT", E6Pos.class);
    Handle.OfReal override = client.realHandle("$OV_PRO");
    Handle<Mode> mode = client.handle("$MODE_OP", Mode.class);
    Handle.OfInt unknown = client.intHandle("NOSUCH");
    Handle.OfInt wrong = client.intHandle("$MODE_OP");
    client.getServer();
    robot.clearRequests();

    ReadResults results = client.read(position, override, mode, unknown, wrong, override);

    assertThat(results.get(position).z()).isEqualTo(890);
    assertThat(results.get(override)).isEqualTo(100);
    assertThat(results.get(mode)).isEqualTo(Mode.T1);
    assertThatExceptionOfType(CrossComAccessException.class).isThrownBy(() -> results.get(unknown));
    assertThatExceptionOfType(CrossComValueException.class).isThrownBy(() -> results.get(wrong));
    assertThat(results.failures()).containsOnlyKeys(unknown, wrong);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> results.get(client.intHandle("$OV_PRO")))
        .withMessageStartingWith("the handles that were read are [Handle{$POS_ACT, E6Pos}, ")
        .withMessageContaining("not Handle{$OV_PRO, Integer}");
    assertThat(robot.requests()).hasSize(server == ServerType.C3_BRIDGE ? 1 : 6);
  }

  @Test
  void theHandleOfAnotherClientIsRefused() throws Exception {
    try (CrossComClient other = client(LONG)) {
      Handle.OfInt foreign = other.intHandle("MYINT");

      assertThatIllegalArgumentException()
          .isThrownBy(() -> client.read(client.intHandle("MYINT"), foreign))
          .withMessageStartingWith("Handle{MYINT, Integer} is a handle of CrossComClient{");
    }
    assertThat(robot.requests()).isEmpty();
  }
}
