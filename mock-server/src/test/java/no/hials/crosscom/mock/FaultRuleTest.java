package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.LongStream;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FaultRuleTest {
  private static final FaultRule DROP = FaultRule.of(Fault.drop());

  private static RecordedRequest request(long number, String name) {
    return new RecordedRequest(number, 1, Instant.EPOCH, new ReadRequest(0, name), null, null);
  }

  private static boolean hits(FaultRule rule, String name) {
    return rule.apply(request(1, name)).isPresent();
  }

  /** Returns the numbers of the first requests that the rule applies to. */
  private static List<Long> hitsOf(FaultRule rule, long requests) {
    return LongStream.rangeClosed(1, requests)
        .filter(number -> rule.apply(request(number, "MYINT")).isPresent())
        .boxed()
        .toList();
  }

  // the choice of requests

  @Test
  void hitsEveryRequestUnlessRestricted() {
    assertThat(hitsOf(DROP, 3)).containsExactly(1L, 2L, 3L);
    assertThat(DROP.apply(request(1, ""))).contains(Fault.drop());
  }

  @Test
  void hitsByNumber() {
    assertThat(hitsOf(DROP.onRequest(3), 5)).containsExactly(3L);
    assertThat(hitsOf(DROP.onRequests(2, 4), 5)).containsExactly(2L, 3L, 4L);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"$POS_ACT", "$pos_act", " $Pos_Act ", "$POS_ACT.X", "$POS_ACT[1]", "$POS_ACT[]"})
  void hitsAVariableWholeOrInPartsInAnyCase(String name) {
    assertThat(hits(DROP.onVariable("$Pos_act"), name)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "$POS_AC", "$POS_ACT_MES", "X$POS_ACT", "MYINT"})
  void doesNotHitOtherVariables(String name) {
    assertThat(hits(DROP.onVariable("$POS_ACT"), name)).isFalse();
  }

  @Test
  void hitsOnePartOfAVariable() {
    FaultRule rule = DROP.onVariable("LOAD_DATA[1].CM");
    assertThat(hits(rule, "load_data[1].cm")).isTrue();
    assertThat(hits(rule, "LOAD_DATA[1].CM.X")).isTrue();
    assertThat(hits(rule, "LOAD_DATA[1]")).isFalse();
    assertThat(hits(rule, "LOAD_DATA[11].CM")).isFalse();
  }

  @Test
  void hitsAsOftenAsItsProbabilitySays() {
    int requests = 100_000;
    assertThat(hitsOf(DROP.withProbability(0.25, 1), requests).size() / (double) requests)
        .isCloseTo(0.25, within(0.005));
    assertThat(hitsOf(DROP.withProbability(0, 1), 1000)).isEmpty();
    assertThat(hitsOf(DROP.withProbability(1, 1), 1000)).hasSize(1000);
  }

  @Test
  void hitsTheSameRequestsForTheSameSeedOnly() {
    List<Long> hit = hitsOf(DROP.withProbability(0.5, 7), 100);
    assertThat(hitsOf(DROP.withProbability(0.5, 7), 100)).isEqualTo(hit);
    assertThat(hitsOf(DROP.withProbability(0.5, 8), 100)).isNotEqualTo(hit);
  }

  @Test
  void hitsIndependentlyForAnotherTextOfTheSameSeed() {
    List<Long> one = hitsOf(FaultRule.parse("drop%0.5", 1), 1000);
    List<Long> both =
        hitsOf(FaultRule.parse("closeAfter%0.5", 1), 1000).stream().filter(one::contains).toList();
    assertThat(both).hasSizeBetween(200, 300);
  }

  @Test
  void needsAllThatItIsRestrictedTo() {
    FaultRule rule = DROP.onRequests(2, 3).onVariable("MYINT").withProbability(1, 1);
    assertThat(rule.apply(request(2, "MYINT"))).contains(Fault.drop());
    assertThat(rule.apply(request(2, "MYREAL"))).isEmpty();
    assertThat(rule.apply(request(4, "MYINT"))).isEmpty();
    assertThat(rule.withProbability(0, 1).apply(request(2, "MYINT"))).isEmpty();
  }

  @Test
  void isTakenByAServer() throws IOException {
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      server.faults(FaultRule.parse("wrongId:2@2", 1));
      server.faults(FaultRule.of(Fault.wrongId()).onVariable("$OV_PRO"));
      assertThat(client.read("$OV_PRO").id()).isEqualTo(8);
      assertThat(client.read("$OV_PRO").id()).isEqualTo(9);
      assertThat(client.read("MYINT").id()).isEqualTo(7);
    }
  }

  @Test
  void refusesRestrictionsThatMakeNoSense() {
    assertThatThrownBy(() -> DROP.onRequest(0)).hasMessageContaining("first to last from 1");
    assertThatThrownBy(() -> DROP.onRequests(3, 2)).hasMessageContaining("are 3 to 2");
    assertThatThrownBy(() -> DROP.onVariable(" ")).hasMessageContaining("must not be blank");
    assertThatThrownBy(() -> DROP.withProbability(1.1, 1)).hasMessageContaining("0 to 1, is 1.1");
    assertThatThrownBy(() -> DROP.withProbability(-0.1, 1)).hasMessageContaining("0 to 1");
    assertThatThrownBy(() -> DROP.withProbability(Double.NaN, 1)).hasMessageContaining("0 to 1");
  }

  // the text form: faults

  private static void assertFault(String text, Fault fault) {
    assertThat(FaultRule.parse(text, 1)).as(text).isEqualTo(FaultRule.of(fault));
  }

  @Test
  void readsFaultsWithoutArgument() {
    assertFault("none", Fault.none());
    assertFault("emptyAnswer", Fault.emptyAnswer());
    assertFault("drop", Fault.drop());
    assertFault("dropAnswer", Fault.dropAnswer());
    assertFault("closeBefore", Fault.closeBefore());
    assertFault("resetBefore", Fault.resetBefore());
    assertFault("closeAfter", Fault.closeAfter());
    assertFault("answerTwice", Fault.answerTwice());
    assertFault("glueToNext", Fault.glueToNext());
    assertFault("GLUETONEXT", Fault.glueToNext());
  }

  @Test
  void readsFaultsWithAnArgument() {
    assertFault("raw:00 01ff", Fault.raw("00 01 FF"));
    assertFault("raw:DE,AD", Fault.raw("DE", "AD"));
    assertFault("answer:{X 1.5,Y -2}", Fault.answer("{X 1.5,Y -2}", Tail.SUCCESS));
    assertFault("answer:", Fault.answer("", Tail.SUCCESS));
    assertFault("failure", Fault.answer("", Tail.FAILURE));
    assertFault("failure:50", Fault.answer("50", Tail.FAILURE));
    assertFault("closeDuring:0", Fault.closeDuring(0));
    assertFault("delay:200ms", Fault.delay(Duration.ofMillis(200)));
    assertFault("split:1,2", Fault.split(1, 2));
    assertFault("split:3,1.5ms", new Fault.Split(List.of(3), Duration.ofNanos(1_500_000)));
    assertFault("oneByteAtATime", Fault.oneByteAtATime());
    assertFault("oneByteAtATime:1ms", Fault.oneByteAtATime(Duration.ofMillis(1)));
    assertFault("wrongId", Fault.wrongId());
    assertFault("wrongId:-2", new Fault.WrongId(-2));
    assertFault("wrongFunction:255", Fault.wrongFunction(255));
    assertFault("wrongLength:+3", Fault.wrongLength(3));
    assertFault("truncate:4", Fault.truncate(4));
  }

  @Test
  void readsGarbageThatTheSeedDecides() {
    Fault.Garbage garbage = (Fault.Garbage) FaultRule.parse("garbage:10", 1).fault();
    assertThat(garbage.length()).isEqualTo(10);
    assertThat(FaultRule.parse("garbage:10", 1).fault()).isEqualTo(garbage);
    assertThat(FaultRule.parse("garbage:10", 2).fault()).isNotEqualTo(garbage);
  }

  @Test
  void takesABackslashForTheSignsOfTheForm() {
    assertFault("answer:5\\%\\@1\\\\", Fault.answer("5%@1\\", Tail.SUCCESS));
    assertFault("answer:\\", Fault.answer("\\", Tail.SUCCESS));
  }

  // the text form: requests

  @Test
  void readsWhichRequests() {
    assertThat(FaultRule.parse("drop@3", 1)).isEqualTo(DROP.onRequest(3));
    assertThat(FaultRule.parse("drop@5-10", 1)).isEqualTo(DROP.onRequests(5, 10));
    assertThat(FaultRule.parse("drop@5-", 1)).isEqualTo(DROP.onRequests(5, Long.MAX_VALUE));
    assertThat(FaultRule.parse("drop@$ov_pro", 1)).isEqualTo(DROP.onVariable("$OV_PRO"));
    assertThat(FaultRule.parse("drop@LOAD_DATA[1].M", 1))
        .isEqualTo(DROP.onVariable("LOAD_DATA[1].M"));
    FaultRule rule = FaultRule.parse("delay:5ms@MYINT@2-%.25", 1);
    assertThat(rule.fault()).isEqualTo(Fault.delay(Duration.ofMillis(5)));
    assertThat(rule.first()).isEqualTo(2);
    assertThat(rule.variable()).isEqualTo("MYINT");
    assertThat(rule.probability()).isEqualTo(0.25);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "drp@3|1|expected none, raw,|found 'drp'",
        "``|1|expected none, raw,|found nothing",
        "drop:1|6|expected no argument of drop|found '1'",
        "answer|7|expected :VALUE|found nothing",
        "raw|4|expected pairs of hexadecimal digits|found nothing",
        "raw:ABC|5|expected pairs of hexadecimal digits|found 'ABC'",
        "raw:AB,|5|expected pairs of hexadecimal digits|found 'AB,'",
        "closeDuring|12|expected a number from 0|found nothing",
        "truncate:x|10|expected a number from 0|found 'x'",
        "truncate:-1|10|expected a number from 0|found '-1'",
        "truncate:9999999999|10|expected a number from 0|found '9999999999'",
        "wrongFunction:256|15|expected a number from 0 to 255|found '256'",
        "wrongId:65536|9|expected a number from -65535 to 65535|found '65536'",
        "delay:5x|7|expected a time up to an hour such as|found '5x'",
        "delay:61m|7|expected a time up to an hour such as|found '61m'",
        "split:1,0|9|expected a number from 1|found '0'",
        "split:1ms|7|expected a number from 1|found '1ms'",
        "split:1ms,2|7|expected a number from 1|found '1ms'",
        "answer:€|8|expected value must be ISO 8859-1|found '€'",
        "drop@|6|expected a request's number or a variable's name|found nothing",
        "drop@.X|6|expected a request's number or a variable's name|found '.X'",
        "drop@0|6|expected a number from 1|found '0'",
        "drop@3-2|6|expected a number from 1|found '3-2'",
        "drop@3x|6|expected a number from 1|found '3x'",
        "drop@3@4|8|expected one @NUMBERS and one @NAME at most|found '4'",
        "drop@A@B|8|expected one @NUMBERS and one @NAME at most|found 'B'",
        "drop%|6|expected a probability from 0 to 1|found nothing",
        "drop%1.5|6|expected a probability from 0 to 1|found '1.5'",
        "drop%50|6|expected a probability from 0 to 1|found '50'",
        "drop%0.5@3|6|expected a probability from 0 to 1|found '0.5@3'"
      })
  void saysWhereATextIsWrong(String text, int column, String expected, String found) {
    assertThatThrownBy(() -> FaultRule.parse(text, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("fault '" + text + "', column " + column + ": " + expected)
        .hasMessageEndingWith(found);
  }
}
