package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class RoundTripsTest {
  private final List<CompletableFuture<Void>> questions = new ArrayList<>();
  private final RoundTrips trips =
      new RoundTrips(
          () -> {
            CompletableFuture<Void> question = new CompletableFuture<>();
            questions.add(question);
            return question;
          });

  @Test
  void whatIsSentDuringAQuestionSharesTheNextOne() {
    CompletableFuture<?> first = trips.next(1, 8_000);
    CompletableFuture<?> second = trips.next(1, 8_000);
    CompletableFuture<?> third = trips.next(1, 8_000);
    assertThat(questions).hasSize(1);

    questions.get(0).complete(null);

    assertThat(first).isCompleted();
    assertThat(second).isNotDone();
    assertThat(questions).hasSize(2);

    questions.get(1).complete(null);

    assertThat(second).isCompleted();
    assertThat(third).isCompleted();
    assertThat(trips.next(1, 8_000)).isNotDone();
    assertThat(questions).hasSize(3);
  }

  @Test
  void manyBytesHaveAQuestionOfTheirOwn() {
    CompletableFuture<?> first = trips.next(1, 8_000);
    CompletableFuture<?> second = trips.next(7_999, 8_000);
    assertThat(questions).hasSize(1);
    CompletableFuture<?> third = trips.next(1, 8_000);
    assertThat(questions).hasSize(2);

    questions.get(0).complete(null);

    assertThat(first).isCompleted();
    assertThat(second).isNotDone();

    questions.get(1).complete(null);

    assertThat(second).isCompleted();
    assertThat(third).isCompleted();
  }

  @Test
  void aQuestionThatFailsIsNoAnswer() {
    CompletableFuture<?> first = trips.next(1, 8_000);
    CompletableFuture<?> second = trips.next(1, 8_000);

    questions.get(0).completeExceptionally(new IllegalStateException("lost"));

    assertThat(first).isCompletedExceptionally();
    assertThat(second).isNotDone();
    assertThat(questions).hasSize(2);
  }
}
