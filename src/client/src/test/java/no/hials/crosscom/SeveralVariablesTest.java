package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLIntArray;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLRecord;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Reads and writes many variables, and arrays element by element. */
class SeveralVariablesTest extends RobotTest {
  @Test
  void eachVariableGetsItsResultAndOneBadNameDoesNotHideTheRest() throws Exception {
    KRLInt override = new KRLInt("$OV_PRO");
    KRLInt unknown = new KRLInt("NOSUCHVAR");
    KRLInt wrongType = new KRLInt("$MODE_OP");
    KRLFrame base = new KRLFrame("$BASE");

    List<VariableResult> results = client.readVariables(override, unknown, wrongType, base);

    assertThat(results)
        .extracting(r -> r.variable().getName())
        .containsExactly("$OV_PRO", "NOSUCHVAR", "$MODE_OP", "$BASE");
    assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, false, true);
    assertThat(results.get(1).failure()).isInstanceOf(CrossComAccessException.class);
    assertThat(results.get(2).failure()).isInstanceOf(CrossComValueException.class);
    assertThat(results.get(0).orThrow()).isSameAs(override);
    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> results.get(1).orThrow());
    assertThat(override.getValue()).isEqualTo(100);
    assertThat(unknown.getValue()).isNull();
    assertThat(requests())
        .extracting(RecordedRequest::names)
        .isEqualTo(
            server == ServerType.C3_BRIDGE
                ? List.of(List.of("$OV_PRO", "NOSUCHVAR", "$MODE_OP", "$BASE"))
                : List.of(
                    List.of("$OV_PRO"),
                    List.of("NOSUCHVAR"),
                    List.of("$MODE_OP"),
                    List.of("$BASE")));
  }

  @Test
  void tenVariablesTakeOneRoundTripOnC3BridgeAndTenOnKukavarproxy() throws Exception {
    client.getServer();
    robot.clearRequests();
    List<KRLInt> variables = new ArrayList<>();
    for (int i = 1; i <= 10; i++) {
      variables.add(new KRLInt("MYINTS[" + i + "]"));
    }

    assertThat(client.readVariables(variables)).allMatch(VariableResult::isOk);
    assertThat(robot.requests()).hasSize(server == ServerType.C3_BRIDGE ? 1 : 10);

    robot.clearRequests();
    assertThat(client.writeVariables(variables)).allMatch(VariableResult::isOk);
    assertThat(robot.requests()).hasSize(server == ServerType.C3_BRIDGE ? 1 : 10);
  }

  @Test
  void aNameThatTheServerCannotBeAskedForDoesNotHideWhatCameOfTheOthers() {
    KRLInt good = new KRLInt("MYINT");
    KRLInt strange = new KRLInt("Ω");
    KRLInt last = new KRLInt("MYINTS[1]");
    List.of(good, strange, last).forEach(v -> v.setValue(5));

    List<VariableResult> written = client.writeVariables(good, strange, last);
    List<VariableResult> read = client.readVariables(good, strange, last);

    for (List<VariableResult> results : List.of(written, read)) {
      assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, true);
      assertThat(results.get(1).failure())
          .isInstanceOf(
              server == ServerType.C3_BRIDGE
                  ? CrossComAccessException.class
                  : CrossComUnsupportedException.class);
    }
    assertThat(robot.variables().get("MYINTS[1]")).isEqualTo("5");
  }

  @Test
  void writesAreDoneInOrderAndARefusedOneDoesNotKeepTheOthers() {
    KRLInt good = new KRLInt("MYINT");
    good.setValue(1);
    KRLInt readOnly = new KRLInt("$POS_ACT.X");
    readOnly.setValue(2);
    KRLReal last = new KRLReal("MYREAL");
    last.setValue(3);

    List<VariableResult> results = client.writeVariables(List.of(good, readOnly, last));

    assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, true);
    assertThat(robot.variables().get("MYINT")).isEqualTo("1");
    assertThat(robot.variables().get("MYREAL")).isEqualTo("3.00000");
  }

  @Test
  void afterABrokenExchangeTheRestIsNotTriedAndSaysSo() throws Exception {
    KRLInt first = new KRLInt("MYINT");
    first.setValue(1);
    KRLInt second = new KRLInt("MYINTS[1]");
    second.setValue(2);
    KRLIntArray third = new KRLIntArray("MYINTS");
    third.setValue(3);
    client.getServer();
    robot.enqueue(Fault.closeBefore());

    List<VariableResult> results = client.writeVariables(first, second, third);

    assertThat(results.get(0).failure().isOutcomeUnknown()).isTrue();
    if (server == ServerType.C3_BRIDGE) {
      assertThat(results.get(1).failure().isOutcomeUnknown()).as("it was under way too").isTrue();
    } else {
      assertThat(results.get(1).failure())
          .isInstanceOf(CrossComConnectionLostException.class)
          .hasMessageContaining("MYINTS[1] was not written, since an exchange before it failed");
      assertThat(results.get(1).failure().isOutcomeUnknown()).isFalse();
    }
    assertThat(results.get(2).failure())
        .isInstanceOf(CrossComConnectionLostException.class)
        .hasMessageContaining("MYINTS[] was not written, since an exchange before it failed");
    assertThat(results.get(2).failure().isOutcomeUnknown()).isFalse();
    assertThat(requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
  }

  @Test
  void nothingIsWrittenIfOneVariableHasNoValue() {
    KRLInt good = new KRLInt("MYINT");
    good.setValue(1);

    assertThatIllegalStateException()
        .isThrownBy(() -> client.writeVariables(good, new KRLInt("MYREAL")));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aVariableTooLongForAnAnswerFailsAloneAndALongArrayIsReadElementByElement() throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    robot.variables().declare("LONGTEXT[40000]", "CHAR", "\"" + "x".repeat(40_000) + "\"");
    robot.variables().declare("LONGREALS[3500]", "REAL", "-1.2345678");
    KRLString text = new KRLString("LONGTEXT[]");
    KRLRealArray reals = new KRLRealArray("LONGREALS", 3500);

    List<VariableResult> results =
        client.readVariables(new KRLInt("MYINT"), text, reals, new KRLReal("MYREAL"));

    assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, true, true);
    assertThat(results.get(1).failure())
        .isInstanceOf(CrossComValueException.class)
        .hasMessage("LONGTEXT[]: the value is too long for an answer (code 10)");
    assertThat(reals.getValue()).hasSize(3500);
    assertThat(robot.requests()).extracting(RecordedRequest::connection).containsOnly(1);
  }

  /** Returns a client that reconnects to a C3 Bridge with values too long for an answer. */
  private CrossComClient clientOfLongValues() throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    robot.variables().declare("LONGTEXT[40000]", "CHAR", "\"" + "x".repeat(40_000) + "\"");
    robot.variables().declare("LONGREALS[9000]", "REAL", "-1.2345678");
    return client(cfg -> cfg.requestTimeout(LONG));
  }

  @Test
  void anArrayTooLongForAnAnswerIsReadElementByElement() throws Exception {
    try (CrossComClient reading = clientOfLongValues()) {
      KRLRealArray reals = new KRLRealArray("LONGREALS", 9000);
      List<Integer> progress = new ArrayList<>();

      reading.readVariable(reals, (done, total) -> progress.add(done));

      assertThat(reals.getValue()).hasSize(9000).containsOnly(-1.23456776);
      assertThat(progress).hasSize(9000);
      assertThat(robot.requests())
          .extracting(RecordedRequest::names)
          .filteredOn(names -> names.contains("LONGREALS[]"))
          .as("once as usual, once by message 6")
          .hasSize(2);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"LONGTEXT[]", "LONGREALS[]"})
  void aReadOfAValueTooLongForAnAnswerSaysSoAndTheConnectionStaysUsable(String name)
      throws Exception {
    try (CrossComClient reading = clientOfLongValues()) {
      List<ThrowingCallable> reads =
          List.of(
              () -> reading.readText(name),
              () -> reading.readValue(name),
              () ->
                  reading.read(
                      name.startsWith("LONGTEXT") ? new KRLString(name) : new KRLRealArray(name)));
      for (ThrowingCallable read : reads) {
        assertThatExceptionOfType(CrossComValueException.class)
            .isThrownBy(read)
            .withMessageStartingWith(name + ": the value is too long for an answer");
        assertThat(reading.readInt("MYINT")).isZero();
      }
    }
  }

  @Test
  void withoutReconnectingALostReadOfAWholeArrayNamesItsLengthAsAPossibleReason() throws Exception {
    clientOfLongValues().close();

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> client.readRealArray("LONGREALS"))
        .withMessageEndingWith("C3 Bridge does so if the value is too long for an answer");
  }

  @Test
  void aReadOfAnArrayWhoseConnectionBreaksForAnotherReasonIsRepeatedOnce() throws Exception {
    robot.variables().set("MYREALS[2]", "2.5");
    try (CrossComClient reading = client(cfg -> cfg.requestTimeout(LONG))) {
      robot.enqueue(Fault.closeBefore());
      assertThat(reading.readRealArray("MYREALS")[1]).isEqualTo(2.5);
      robot.enqueue(Fault.closeBefore());
      assertThat(reading.readText("MYREALS[]")).contains(" 2.50000 ");

      robot.fault(r -> r.names().contains("MYREALS[]"), Fault.closeBefore());
      robot.clearRequests();
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> reading.readRealArray("MYREALS"));
      assertThat(robot.requests()).filteredOn(r -> r.names().contains("MYREALS[]")).hasSize(2);
    }
  }

  @Test
  void anArrayOfKnownLengthIsReadElementByElementIfTheServerCannotReadItWhole() throws Exception {
    robot.fault(r -> r.name().endsWith("[]"), Fault.answer("", Tail.FAILURE));
    for (int i = 1; i <= 10; i++) {
      robot.variables().set("MYREALS[" + i + "]", String.valueOf(i / 2.0));
    }
    KRLRealArray reals = new KRLRealArray("MYREALS", 10);
    List<String> progress = new ArrayList<>();
    client.readVariable(reals, (done, total) -> progress.add(done + "/" + total));

    assertThat(reals.getValue()).containsExactly(0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5);
    assertThat(progress).hasSize(10).startsWith("1/10", "2/10").endsWith("10/10");
    assertThat(robot.requests()).hasSize(11);

    assertThatExceptionOfType(CrossComAccessException.class)
        .as("without a length there is no telling where it ends")
        .isThrownBy(() -> client.readVariable(new KRLRealArray("MYREALS")));
  }

  @Test
  void anArrayReadThatFailsSaysHowFarItCameAndKeepsTheOldElements() throws Exception {
    robot.fault(r -> r.name().endsWith("[]"), Fault.answer("", Tail.FAILURE));
    KRLIntArray ints = new KRLIntArray("MYINTS", 12);
    ints.setValue(7, 8);

    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.readVariable(ints))
        .withMessageContaining("MYINTS[11]")
        .withMessageEndingWith("; 10 of 12 elements were done")
        .satisfies(e -> assertThat(e.getElementsDone()).hasValue(10));
    assertThat(ints.getValue()).containsExactly(7, 8);
  }

  @Test
  void anArrayElementOfAnotherTypeSaysHowFarItCame() throws Exception {
    robot.fault(r -> r.name().endsWith("[]"), Fault.answer("", Tail.FAILURE));
    robot.fault(r -> r.name().equals("MYINTS[3]"), Fault.answer("TRUE", Tail.SUCCESS));

    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.readVariable(new KRLIntArray("MYINTS", 5)))
        .satisfies(e -> assertThat(e.getElementsDone()).hasValue(2))
        .satisfies(e -> assertThat(e.getText()).isEqualTo("TRUE"));
  }

  @Test
  void anArrayWriteTellsItsProgressAndHowFarItCame() throws Exception {
    KRLIntArray ints = new KRLIntArray("MYINTS");
    ints.setValue(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11);
    List<Integer> progress = new ArrayList<>();

    assertThatExceptionOfType(CrossComAccessException.class)
        .isThrownBy(() -> client.writeVariable(ints, (done, total) -> progress.add(done)))
        .withMessageEndingWith("; 10 of 11 elements were done")
        .satisfies(e -> assertThat(e.getElementsDone()).hasValue(10));
    assertThat(progress).containsExactly(1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
  }

  @Test
  void aValueThatCannotBeSentIsTheFailureOfItsVariableOnly() {
    KRLInt good = new KRLInt("MYINT");
    good.setValue(1);
    KRLString euro = new KRLString("MYSTRING[]");
    euro.setValue("5 Ω");
    KRLReal last = new KRLReal("MYREAL");
    last.setValue(3);

    List<VariableResult> results = client.writeVariables(good, euro, last);

    boolean wide = server == ServerType.C3_BRIDGE;
    assertThat(results).extracting(VariableResult::isOk).containsExactly(true, wide, true);
    if (!wide) {
      assertThat(results.get(1).failure()).isInstanceOf(CrossComValueException.class);
    }
  }

  @Test
  void anAggregateThatIsTooLongIsTheFailureOfItsVariableOnly() throws Exception {
    KRLFrame frame = new KRLFrame("MYFRAME");
    KRLInt good = new KRLInt("MYINT");
    good.setValue(1);
    KRLReal last = new KRLReal("MYREAL");
    last.setValue(3);
    try (CrossComClient strict = client(cfg -> cfg.maxAggregateLength(10))) {
      List<VariableResult> results = strict.writeVariables(good, frame, last);

      assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, true);
      assertThat(results.get(1).failure()).hasMessageContaining("must have at most 10 bytes");
    }
  }

  @Test
  void anArrayAmongOthersIsReadElementByElementIfItMustBeAndWrittenInItsPlace() throws Exception {
    robot.fault(r -> r.name().endsWith("[]"), Fault.answer("", Tail.FAILURE));
    KRLIntArray ints = new KRLIntArray("MYINTS", 2);
    KRLInt i = new KRLInt("MYINT");
    i.setValue(1);
    ints.setValue(5, 6);
    KRLInt element = new KRLInt("MYINTS[2]");
    element.setValue(7);

    assertThat(client.writeVariables(i, ints, element)).allMatch(VariableResult::isOk);
    assertThat(client.readVariables(i, ints)).allMatch(VariableResult::isOk);

    assertThat(ints.getValue()).startsWith(5, 7);
  }

  /** Declares positions whose text is long: each number has nine digits. */
  private List<String> declarePositions(int count) {
    List<String> names = new ArrayList<>();
    StringBuilder value = new StringBuilder("{X -1234.56789");
    for (String field : List.of("Y", "Z", "A", "B", "C", "E1", "E2", "E3", "E4", "E5", "E6")) {
      value.append(",").append(field).append(" -1234.56789");
    }
    for (int i = 0; i < count; i++) {
      names.add("POSITION_OF_PART_" + i);
      robot.variables().declare(names.get(i), "E6POS", value.append("}").toString());
      value.setLength(value.length() - 1);
    }
    return names;
  }

  @Test
  void aWriteOfManyPositionsIsDividedSoThatItsAnswersFit() {
    List<KRLE6Pos> positions =
        declarePositions(300).stream()
            .map(KRLE6Pos::new)
            .peek(position -> position.setXToZ(1.5, -0.000123456789, 4e-12))
            .toList();

    assertThat(client.writeVariables(positions)).hasSize(300).allMatch(VariableResult::isOk);
    assertThat(robot.variables().get("POSITION_OF_PART_299.X")).isEqualTo("1.50000");
  }

  @Test
  void aWriteOfManyFramesToE6PosIsDividedSoThatItsAnswersFit() {
    List<KRLFrame> frames = declarePositions(255).stream().map(KRLFrame::new).toList();

    assertThat(client.writeVariables(frames)).hasSize(255).allMatch(VariableResult::isOk);
    assertThat(robot.variables().get("POSITION_OF_PART_254.X")).isEqualTo("0.0");
    assertThat(robot.variables().get("POSITION_OF_PART_254.E6")).isEqualTo("-1234.56787");
  }

  /** One field of a LOAD. */
  private record Mass(double m) {}

  @Test
  void writesWhoseAnswerDoesNotFitAreUnknownAndTheRestIsWritten() {
    List<KRLVariable> masses = new ArrayList<>();
    for (int i = 0; i < 255; i++) {
      KRLRecord<Mass> mass = new KRLRecord<>("LOAD_OF_PART_" + i, Mass.class);
      mass.setValue(new Mass(0));
      masses.add(mass);
      // the server answers the whole LOAD
      robot
          .variables()
          .declare(
              mass.getName(),
              "LOAD",
              "{M 1.0,CM {X -1234.56789,Y -1234.56789,Z -1234.56789,A -1234.56789,B -1234.56789,"
                  + "C -1234.56789},J {X -1234.56789,Y -1234.56789,Z -1234.56789}}");
    }
    KRLInt last = new KRLInt("MYINT");
    last.setValue(7);
    masses.add(last);

    List<VariableResult> results = client.writeVariables(masses);

    assertThat(results.get(255).isOk()).isTrue();
    assertThat(robot.variables().get("MYINT")).isEqualTo("7");
    assertThat(robot.variables().get("LOAD_OF_PART_0.M")).isEqualTo("0.0");
    if (server == ServerType.C3_BRIDGE) {
      assertThat(results.get(0).failure())
          .hasMessageContaining("code 10 (it does not fit into one message)")
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    } else {
      assertThat(results).allMatch(VariableResult::isOk);
    }
  }
}
