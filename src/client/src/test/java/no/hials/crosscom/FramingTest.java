package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Reads answers however TCP cuts them. */
class FramingTest extends RobotTest {
  @Test
  void anAnswerInSingleBytesReadsRight() throws Exception {
    robot.enqueue(Fault.oneByteAtATime(Duration.ofMillis(1)));
    KRLE6Pos position = new KRLE6Pos("$POS_ACT");
    client.readVariable(position);

    assertThat(position.getZ()).isEqualTo(890);
    assertThat(client.readText("$OV_PRO")).isEqualTo("100");
  }

  @Test
  void anAnswerCutAnywhereReadsRight() throws Exception {
    int length = 13; // of the answer "100"
    for (int cut = 1; cut < length; cut++) {
      robot.enqueue(Fault.split(cut));
      assertThat(client.readText("$OV_PRO")).as("cut after %d bytes", cut).isEqualTo("100");
    }
  }

  @Test
  void twoAnswersInOnePieceAreAnsweredOneByOneOrRefused() throws Exception {
    // the second came without a request: the next request must not accept it as its answer
    robot.enqueue(Fault.answerTwice());
    assertThat(client.readText("$OV_PRO")).isEqualTo("100");

    assertThatExceptionOfType(CrossComProtocolException.class)
        .isThrownBy(() -> client.readText("$OV_JOG"))
        .withMessageContaining("00 01 00 09 00 00 03 31 30 30 00 01 01");
    assertThat(client.isClosed()).isTrue();
    assertThat(robot.requests()).as("the second request was not sent").hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 255, 256, 2041, 2048, 4096, 65_000, 65_529})
  void valuesOfAnyLengthReadRight(int length) throws Exception {
    StringBuilder text = new StringBuilder();
    Random random = new Random(length);
    while (text.length() < length) {
      text.append((char) ('0' + random.nextInt(10)));
    }
    String value = text.toString();
    robot.enqueue(Fault.answer(value, Tail.SUCCESS));

    assertThat(client.readText("MYINTS[]")).hasSize(length).isEqualTo(value);
    assertThat(client.readText("$OV_PRO")).isEqualTo("100");
  }

  @Test
  void aLongValueInManyPiecesReadsRight() throws Exception {
    String value = "123456789" + " 123456789".repeat(6_500);
    // pieces that fall into the header, the value, and the tail
    robot.enqueue(Fault.answer(value, Tail.SUCCESS));
    KRLAny any = new KRLAny("MYINTS[]");
    client.readVariable(any);

    assertThat(any.getValue().print().strip()).isEqualTo(value);
  }

  @Test
  void aRequestIsOneSegment() throws Exception {
    // KUKAVARPROXY does not join what arrives in two pieces; see the raw server of the mock's tests
    client.readText("$OV_PRO");

    assertThat(robot.requests()).hasSize(1).allSatisfy(r -> assertThat(r.hex()).isNull());
  }

  @Test
  void severalThreadsGetTheirOwnAnswers() throws Exception {
    int threads = 8;
    for (int t = 1; t <= threads; t++) {
      robot.variables().set("MYINTS[" + t + "]", String.valueOf(t));
    }
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    try {
      List<Future<?>> all = new ArrayList<>();
      for (int t = 1; t <= threads; t++) {
        int own = t;
        all.add(
            pool.submit(
                () -> {
                  KRLInt i = new KRLInt("MYINTS[" + own + "]");
                  for (int n = 0; n < 500; n++) {
                    client.readVariable(i);
                    assertThat(i.intValue()).isEqualTo(own);
                    assertThat(client.readText("MYINTS[" + own + "]")).isEqualTo("" + own);
                  }
                  return null;
                }));
      }
      for (Future<?> one : all) {
        one.get();
      }
    } finally {
      pool.shutdownNow();
    }
  }
}
