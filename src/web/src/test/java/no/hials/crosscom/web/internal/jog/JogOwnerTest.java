package no.hials.crosscom.web.internal.jog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.web.internal.jog.JogOwner.Person;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Who may jog, on a clock that the test steps. */
class JogOwnerTest {
  private static final Person ANNA = new Person(1, "Anna");
  private static final Person BEN = new Person(2, "Ben");
  private static final Person CARL = new Person(3, "Carl");

  private final AtomicLong clock = new AtomicLong();
  private final JogOwner owner = new JogOwner(clock::get);

  private void pass(long millis) {
    clock.addAndGet(millis * 1_000_000);
  }

  /** Lets the time pass while the pages of some persons show that they are there. */
  private void pass(long millis, Person... present) {
    for (long passed = 0; passed < millis; passed += 1000) {
      pass(Math.min(1000, millis - passed));
      for (Person person : present) {
        owner.see(person);
      }
    }
  }

  private static void assertRefused(ThrowingCallable call, String message) {
    assertThatExceptionOfType(CommandException.class).isThrownBy(call).withMessage(message);
  }

  @Test
  void theFirstTakesItAndKeepsIt() throws Exception {
    owner.take(ANNA);
    owner.take(ANNA);

    assertThat(owner.isOwner(ANNA)).isTrue();
    assertRefused(() -> owner.take(BEN), "Anna jogs this robot: ask to take over");
    assertThat(owner.isOwner(BEN)).isFalse();
  }

  @Test
  void whoLeavesFreesIt() throws Exception {
    owner.take(ANNA);
    assertThat(owner.leave(BEN)).isFalse();
    assertThat(owner.isOwner(ANNA)).isTrue();

    assertThat(owner.leave(ANNA)).isTrue();

    owner.take(BEN);
    assertThat(owner.isOwner(BEN)).isTrue();
  }

  @Test
  void theOwnerGivesIt() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);
    assertThat(owner.isOwner(ANNA)).isTrue();

    owner.answer(ANNA, BEN.id(), true);

    assertThat(owner.isOwner(BEN)).isTrue();
    assertThat(owner.isOwner(ANNA)).isFalse();
  }

  @Test
  void theOwnerRefuses() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);

    owner.answer(ANNA, BEN.id(), false);

    assertThat(owner.isOwner(ANNA)).isTrue();
    assertRefused(() -> owner.answer(ANNA, BEN.id(), true), "the question is over");
  }

  @Test
  void noAnswerIsANo() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);
    pass(10_001, ANNA);

    assertRefused(() -> owner.answer(ANNA, BEN.id(), true), "the question is over");
    assertThat(owner.isOwner(ANNA)).isTrue();
    owner.ask(CARL); // the next may ask
  }

  @Test
  void onlyOneAsksAtATime() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);
    pass(2000, ANNA);

    assertRefused(() -> owner.ask(CARL), "Ben has already asked Anna");
    assertRefused(() -> owner.ask(BEN), "Ben has already asked Anna"); // does not prolong it
  }

  @Test
  void onlyTheOwnerAnswersAndOnlyTheQuestionThatItSaw() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);

    assertRefused(
        () -> owner.answer(BEN, BEN.id(), true),
        "only the page that jogs the robot can hand it over");
    assertRefused(() -> owner.answer(ANNA, CARL.id(), true), "the question is over");
    assertThat(owner.isOwner(ANNA)).isTrue();
  }

  @Test
  void anOwnerWhoIsGoneLosesIt() throws Exception {
    owner.take(ANNA);
    pass(5000);
    assertThat(owner.isOwner(ANNA)).isTrue();
    pass(1);

    assertThat(owner.see(ANNA)).isFalse();
    owner.ask(BEN);
    assertThat(owner.isOwner(BEN)).isTrue();
  }

  @Test
  void anOwnerWhoIsThereKeepsIt() throws Exception {
    owner.take(ANNA);
    pass(60_000, ANNA);

    assertThat(owner.isOwner(ANNA)).isTrue();
  }

  @Test
  void onlyTheOwnerProvesThatTheOwnerIsThere() throws Exception {
    owner.take(ANNA);
    pass(6000, BEN);

    assertThat(owner.isOwner(ANNA)).isFalse();
  }

  @Test
  void whoAskedGetsItIfTheOwnerGoesMeanwhile() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);
    pass(5001);
    assertThat(owner.isOwner(BEN)).isTrue();

    owner.ask(CARL);
    owner.leave(BEN);
    assertThat(owner.isOwner(CARL)).isTrue();
  }

  @Test
  void whoAskedAndLeftDoesNotGetIt() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);

    assertThat(owner.leave(BEN)).isTrue();

    assertRefused(() -> owner.answer(ANNA, BEN.id(), true), "the question is over");
  }

  @Test
  void allSeeTheOwnerAndTheQuestion() throws Exception {
    owner.take(ANNA);
    owner.ask(BEN);
    pass(4000, ANNA);
    ObjectNode event = Json.object();

    owner.show(event);

    assertThat(event)
        .hasToString(
            "{'owner':{'id':1,'name':'Anna'},'asker':{'id':2,'name':'Ben'},'answer_ms':6000}"
                .replace('\'', '"'));
  }
}
