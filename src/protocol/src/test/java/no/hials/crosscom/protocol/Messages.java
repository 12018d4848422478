package no.hials.crosscom.protocol;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Arbitrary messages of every type. */
final class Messages {
  private Messages() {}

  static Arbitrary<Request> requests() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text()).as(ReadRequest::new),
        Combinators.combine(u16(), text(), text()).as(WriteRequest::new),
        Combinators.combine(u16(), text()).as(ReadArrayRequest::new),
        Combinators.combine(u16(), text(), words()).as(WriteArrayRequest::new));
  }

  static Arbitrary<Response> responses() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text(), tail()).as(ReadResponse::new),
        Combinators.combine(u16(), text(), tail()).as(WriteResponse::new),
        Combinators.combine(u16(), words(), tail()).as(ReadArrayResponse::new),
        Combinators.combine(u16(), text(), tail()).as(WriteArrayResponse::new),
        u16().map(EmptyResponse::new));
  }

  private static Arbitrary<Integer> u16() {
    return Arbitraries.integers().between(0, 65535);
  }

  private static Arbitrary<String> text() {
    return Arbitraries.strings().withCharRange('\0', '\u00FF').ofMaxLength(600);
  }

  private static Arbitrary<List<Integer>> words() {
    return u16().list().ofMaxSize(300);
  }

  private static Arbitrary<Tail> tail() {
    return Combinators.combine(u16(), Arbitraries.integers().between(0, 255)).as(Tail::new);
  }
}
