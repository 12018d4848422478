package no.hials.crosscom.protocol.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.TypedResponse;
import org.junit.jupiter.api.Test;

class LayoutsTest {
  private static final List<MessageType> TYPES = List.of(MessageType.values());

  @Test
  void everyMessageCanBeWritten() {
    assertThat(Layouts.ALL.writers.keySet())
        .hasSizeGreaterThan(40)
        .containsExactlyInAnyOrderElementsOf(
            Stream.concat(records(Request.class), records(TypedResponse.class)).toList());
  }

  @Test
  void theRequestsAndAnswersOfEveryTypeCanBeRead() {
    assertThat(Layouts.ALL.requests.keySet()).containsExactlyElementsOf(TYPES);
    assertThat(Layouts.ALL.answers.keySet()).containsExactlyElementsOf(TYPES);
  }

  private static Stream<Class<?>> records(Class<?> family) {
    return family.isSealed()
        ? Stream.of(family.getPermittedSubclasses()).flatMap(LayoutsTest::records)
        : Stream.of(family);
  }
}
