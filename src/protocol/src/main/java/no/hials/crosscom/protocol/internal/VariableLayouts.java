package no.hials.crosscom.protocol.internal;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;

/** The layouts of the messages about variables: types 0 to 7 and 17. */
public final class VariableLayouts {
  /**
   * The variables of a benchmark that C3 Bridge parses; those after them can be cut off
   * (docs/reference/c3-messages.md#benchmark-17).
   */
  private static final int MAX_BENCHMARK_VARIABLES = 10;

  private VariableLayouts() {}

  static void addTo(Layouts all) {
    all.writer(ValueResponse.class, (m, out) -> out.string(m.value()));
    for (MessageType type : List.of(MessageType.READ, MessageType.WRITE, MessageType.WRITE_ARRAY)) {
      all.answer(type, (id, in, tail) -> new ValueResponse(id, type, in.string("value"), tail));
    }
    all.request(
        MessageType.READ,
        ReadRequest.class,
        (m, out) -> out.string(m.name()),
        (id, in) -> new ReadRequest(id, in.string("name")));
    all.request(
        MessageType.WRITE,
        WriteRequest.class,
        (m, out) -> write(m.name(), m.value(), out),
        (id, in) -> new WriteRequest(id, in.string("name"), in.string("value")));
    all.request(
        MessageType.READ_ARRAY,
        ReadArrayRequest.class,
        (m, out) -> out.string(m.name()),
        (id, in) -> new ReadArrayRequest(id, in.string("name")));
    all.answer(
        MessageType.READ_ARRAY,
        ReadArrayResponse.class,
        (m, out) -> out.words(m.elements()),
        (id, in, tail) -> new ReadArrayResponse(id, in.words("elements"), tail));
    all.request(
        MessageType.WRITE_ARRAY,
        WriteArrayRequest.class,
        (m, out) -> out.string(m.name()).words(m.elements()),
        (id, in) -> new WriteArrayRequest(id, in.string("name"), in.words("elements")));
    all.request(
        MessageType.READ_UTF16,
        ReadUtf16Request.class,
        (m, out) -> out.wide(m.name()),
        (id, in) -> new ReadUtf16Request(id, in.wide("name")));
    all.textAnswer(MessageType.READ_UTF16);
    all.request(
        MessageType.WRITE_UTF16,
        WriteUtf16Request.class,
        (m, out) -> out.wide(m.name()).wide(m.value()),
        (id, in) -> new WriteUtf16Request(id, in.wide("name"), in.wide("value")));
    all.textAnswer(MessageType.WRITE_UTF16);
    addMultiple(all);
    addBenchmark(all);
  }

  private static void addMultiple(Layouts all) {
    all.request(
        MessageType.READ_MULTIPLE,
        ReadMultipleRequest.class,
        (m, out) -> {
          out.u8(m.names().size());
          m.names().forEach(out::wide);
        },
        (id, in) -> new ReadMultipleRequest(id, in.wides(in.u8("count"), "name")));
    all.request(
        MessageType.WRITE_MULTIPLE,
        WriteMultipleRequest.class,
        (m, out) -> {
          out.u8(m.count());
          write(m.assignments(), out);
        },
        (id, in) -> {
          int count = in.u8("count");
          return new WriteMultipleRequest(id, count, assignments(count, in, 0));
        });
    all.writer(
        MultipleResponse.class,
        (m, out) -> {
          out.u8(m.results().size());
          for (AccessResult result : m.results()) {
            out.u8(result.code().number());
            out.wide(result.value());
          }
        });
    for (MessageType type : List.of(MessageType.READ_MULTIPLE, MessageType.WRITE_MULTIPLE)) {
      all.answer(type, (id, in, tail) -> new MultipleResponse(id, type, results(in), tail));
    }
  }

  private static void addBenchmark(Layouts all) {
    all.request(MessageType.BENCHMARK, VariableLayouts::readBenchmark);
    all.writer(
        MessageType.BENCHMARK,
        BenchmarkReadRequest.class,
        (m, out) -> {
          out.bool(false);
          out.u8(m.names().size());
          out.u32(m.iterations());
          m.names().forEach(out::wide);
        });
    all.writer(
        MessageType.BENCHMARK,
        BenchmarkWriteRequest.class,
        (m, out) -> {
          out.bool(true);
          out.u8(m.assignments().size());
          out.u32(m.iterations());
          write(m.assignments(), out);
        });
    all.answer(
        MessageType.BENCHMARK,
        BenchmarkResponse.class,
        (m, out) ->
            out.bool(m.write())
                .u8(m.count())
                .u32(m.iterations())
                .u32(m.startMillis())
                .u32(m.stopMillis())
                .u32(m.differenceMillis()),
        (id, in, tail) ->
            new BenchmarkResponse(
                id,
                in.bool("write"),
                in.u8("count"),
                in.u32("iterations"),
                in.u32("start"),
                in.u32("stop"),
                in.u32("difference"),
                tail));
  }

  /** Writes the fields of a {@link WriteRequest}. */
  public static void write(CharSequence name, CharSequence value, FieldWriter out) {
    out.string(name).string(value);
  }

  private static void write(List<Assignment> assignments, FieldWriter out) {
    for (Assignment assignment : assignments) {
      out.wide(assignment.name()).wide(assignment.value());
    }
  }

  /** Reads assignments, of which a lenient decoder needs only the first ones. */
  private static List<Assignment> assignments(int count, FieldReader in, int needed)
      throws MalformedFrameException {
    return items(count, in, needed, it -> new Assignment(it.wide("name"), it.wide("value")));
  }

  private interface Item<T> {
    T read(FieldReader in) throws MalformedFrameException;
  }

  private static <T> List<T> items(int count, FieldReader in, int needed, Item<T> item)
      throws MalformedFrameException {
    List<T> items = new ArrayList<>();
    try {
      while (items.size() < count) {
        items.add(item.read(in));
      }
    } catch (MalformedFrameException e) {
      if (!in.isLenient() || items.size() < Math.min(count, needed)) {
        throw e;
      }
    }
    return items;
  }

  private static List<AccessResult> results(FieldReader in) throws MalformedFrameException {
    int count = in.u8("count");
    List<AccessResult> results = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      results.add(new AccessResult(new Code<>(ErrorCode.class, in.u8("code")), in.wide("value")));
    }
    return results;
  }

  private static Request readBenchmark(int id, FieldReader in) throws MalformedFrameException {
    boolean write = in.bool("write");
    int count = in.u8("count");
    long iterations = in.u32("iterations");
    return write
        ? new BenchmarkWriteRequest(id, iterations, assignments(count, in, MAX_BENCHMARK_VARIABLES))
        : new BenchmarkReadRequest(
            id, iterations, items(count, in, MAX_BENCHMARK_VARIABLES, it -> it.wide("name")));
  }
}
