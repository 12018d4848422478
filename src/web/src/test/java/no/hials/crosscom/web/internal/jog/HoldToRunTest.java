package no.hials.crosscom.web.internal.jog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** Each rule of hold to run, on a clock that the test steps. */
class HoldToRunTest {
  private final AtomicLong clock = new AtomicLong(-5_000_000_000L);
  private final List<String> ended = new ArrayList<>();
  private final HoldToRun holds =
      new HoldToRun(clock::get, (press, reason) -> ended.add(press.id() + " " + reason));

  private void pass(long millis) {
    clock.addAndGet(millis * 1_000_000);
  }

  private static Press press(long id, int direction) {
    return new Press(id, direction, true, 1, 0);
  }

  /** Begins a hold with its first beat, at once. */
  private long hold(long id, int direction) throws CommandException {
    return holds.beat(id, 1, holds.press(press(id, direction)));
  }

  private List<Long> moving() {
    HoldToRun.Allowed allowed = holds.allowed();
    return allowed == null ? List.of() : allowed.presses().stream().map(Press::id).toList();
  }

  private static void assertRefused(ThrowingCallable call, String message) {
    assertThatExceptionOfType(CommandException.class).isThrownBy(call).withMessage(message);
  }

  // beats

  @Test
  void nothingIsAllowedWithoutAPress() {
    assertThat(holds.allowed()).isNull();
  }

  @Test
  void aPressAloneMovesNothing() throws Exception {
    holds.press(press(1, 0));

    assertThat(moving()).isEmpty();
  }

  @Test
  void aBeatThatShowsTheMarkOfThePressAllowsMotion() throws Exception {
    long mark = holds.press(press(1, 0));
    pass(20);

    holds.beat(1, 1, mark);

    assertThat(moving()).containsExactly(1L);
  }

  @Test
  void motionLastsFor150MillisecondsAfterABeat() throws Exception {
    hold(1, 0);

    pass(150);
    assertThat(moving()).containsExactly(1L);
    pass(1);
    assertThat(moving()).isEmpty();
    assertThat(ended).containsExactly("1 no beat for 150 ms");
  }

  @Test
  void beatsContinueTheMotion() throws Exception {
    long mark = hold(1, 0);
    for (int beat = 2; beat < 100; beat++) {
      pass(50);
      mark = holds.beat(1, beat, mark);
      assertThat(moving()).containsExactly(1L);
    }
    assertThat(ended).isEmpty();
  }

  @Test
  void theTimeOfTheMotionIsThatOfTheOldestLastBeat() throws Exception {
    long first = clock.get();
    hold(1, 0);
    pass(60);
    hold(2, 1);

    assertThat(holds.allowed().nanoTime()).isEqualTo(first);
    assertThat(moving()).containsExactly(1L, 2L);
  }

  @Test
  void aBeatAfterSilenceDoesNotResume() throws Exception {
    long mark = hold(1, 0);
    pass(151);

    assertRefused(() -> holds.beat(1, 2, mark), "the hold is over: no beat for 150 ms");

    assertThat(moving()).isEmpty();
    assertThat(hold(2, 0)).isEqualTo(151); // a new press does
    assertThat(moving()).containsExactly(2L);
  }

  @Test
  void aPressWithoutABeatIsOverAfterTheSameTime() throws Exception {
    long mark = holds.press(press(1, 0));
    pass(151);

    assertRefused(() -> holds.beat(1, 1, mark), "the hold is over: no beat for 150 ms");
    assertThat(moving()).isEmpty();
  }

  @Test
  void aReplayedBeatDoesNotCount() throws Exception {
    long mark = hold(1, 0);
    pass(100);
    holds.beat(1, 1, mark);
    pass(51);

    assertThat(moving()).isEmpty();
  }

  @Test
  void aBeatThatComesAfterALaterOneDoesNotCount() throws Exception {
    long mark = hold(1, 0);
    pass(50);
    mark = holds.beat(1, 3, mark);
    pass(100);
    holds.beat(1, 2, mark);
    pass(51);

    assertThat(moving()).isEmpty();
  }

  @Test
  void aBeatThatWasUnderWayForTooLongDoesNotCount() throws Exception {
    long mark = hold(1, 0);
    for (int beat = 2; beat < 5; beat++) {
      pass(50);
      holds.beat(1, beat, mark); // the page gets no newer mark
      assertThat(moving()).containsExactly(1L);
    }
    pass(100);
    holds.beat(1, 5, mark);
    pass(51);

    assertThat(moving()).isEmpty();
  }

  @Test
  void theFirstBeatOfASlowNetworkMovesNothing() throws Exception {
    pass(1000);
    holds.press(press(1, 0));
    pass(10);

    holds.beat(1, 1, 1000 - 141);

    assertThat(moving()).isEmpty();
  }

  @Test
  void aMarkFromTheFutureDoesNotCount() throws Exception {
    long mark = holds.press(press(1, 0));

    holds.beat(1, 1, mark + 1);

    assertThat(moving()).isEmpty();
  }

  @Test
  void aBeatOfAHoldThatNeverBeganIsRefused() {
    assertRefused(() -> holds.beat(7, 1, 0), "the hold is over");
  }

  // releases

  @Test
  void aReleaseStopsAtOnceAndLateBeatsDoNotResume() throws Exception {
    long mark = hold(1, 0);

    holds.release(1);

    assertThat(moving()).isEmpty();
    assertThat(ended).containsExactly("1 released");
    assertRefused(() -> holds.beat(1, 2, mark), "the hold is over: released");
    assertThat(moving()).isEmpty();
  }

  @Test
  void aReleaseBeforeItsPressPreventsIt() {
    holds.release(3);

    assertRefused(() -> holds.press(press(3, 0)), "hold must be more than 3, is 3");
    assertThat(ended).isEmpty();
  }

  @Test
  void aReleaseOfAnOldHoldDoesNotEndANewerOne() throws Exception {
    hold(1, 0);
    holds.release(1);
    hold(2, 0);

    holds.release(1);

    assertThat(moving()).containsExactly(2L);
  }

  @Test
  void aReplayedPressIsRefused() throws Exception {
    hold(5, 0);
    holds.release(5);

    assertRefused(() -> holds.press(press(5, 0)), "hold must be more than 5, is 5");
    assertRefused(() -> holds.press(press(4, 0)), "hold must be more than 5, is 4");
    assertThat(moving()).isEmpty();
  }

  // several holds

  @Test
  void twoDirectionsMoveTogetherAndEndAlone() throws Exception {
    long mark = hold(1, 0);
    hold(2, 4);
    assertThat(moving()).containsExactly(1L, 2L);

    holds.release(2);
    assertThat(moving()).containsExactly(1L);
    holds.beat(1, 2, mark);
    pass(151);
    assertThat(moving()).isEmpty();
  }

  @Test
  void beatsOfOneHoldDoNotContinueAnother() throws Exception {
    long mark = hold(1, 0);
    hold(2, 1);
    pass(100);
    holds.beat(2, 2, mark);
    pass(51);

    assertThat(moving()).containsExactly(2L);
  }

  @Test
  void eachDirectionKeepsTheReasonOfItsLastEnd() throws Exception {
    long mark = hold(1, 0);
    hold(2, 1);
    holds.release(1);
    holds.finish(2);

    assertRefused(() -> holds.beat(1, 2, mark), "the hold is over: released");
    assertRefused(() -> holds.beat(2, 2, mark), "the hold is over: the step is done");
  }

  @Test
  void theSecondButtonOfADirectionEndsBoth() throws Exception {
    long mark = hold(1, 2);

    assertRefused(
        () -> holds.press(new Press(2, 2, false, 1, 0)),
        "the other button of this direction is held: release both");

    assertThat(moving()).isEmpty();
    assertThat(ended).containsExactly("1 two buttons of one direction were held");
    assertRefused(
        () -> holds.beat(1, 2, mark), "the hold is over: two buttons of one direction were held");
    assertRefused(() -> holds.beat(2, 1, mark), "the hold is over");
    assertThat(moving()).isEmpty();
  }

  // other ends

  @Test
  void aStepThatIsDoneEndsItsHold() throws Exception {
    long mark = hold(1, 0);

    holds.finish(1);

    assertThat(moving()).isEmpty();
    assertRefused(() -> holds.beat(1, 2, mark), "the hold is over: the step is done");
  }

  @Test
  void aStopEndsAllHoldsForGood() throws Exception {
    long mark = hold(1, 0);
    hold(2, 1);

    holds.stop("the robot was locked");
    holds.stop("something else");

    assertThat(moving()).isEmpty();
    assertThat(ended).containsExactly("1 the robot was locked", "2 the robot was locked");
    assertRefused(() -> holds.beat(2, 2, mark), "the hold is over: the robot was locked");
    assertRefused(() -> holds.press(press(3, 0)), "the robot was locked");
    assertThat(moving()).isEmpty();
  }

  @Test
  void eachHoldEndsOnce() throws Exception {
    hold(1, 0);
    pass(200);
    assertThat(moving()).isEmpty();
    holds.release(1);
    holds.finish(1);
    holds.stop("closed");

    assertThat(ended).hasSize(1);
  }
}
