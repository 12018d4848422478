package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;

/** Answers a {@link VariableRequest}, unless it is a text in UTF-16. */
public sealed interface VariableResponse extends TypedResponse {

  /**
   * Answers {@link ReadRequest}, {@link WriteRequest} and {@link WriteArrayRequest}: {@code id,
   * length, type, value length, value, tail}.
   *
   * @param id u16, of the request
   * @param type u8; {@link MessageType#READ}, {@link MessageType#WRITE} or {@link
   *     MessageType#WRITE_ARRAY}
   * @param value u16 byte count and ISO 8859-1 bytes; 65,529 at most. The value read, or empty if
   *     the read failed, which some servers report with a success tail
   *     (docs/reference/kukavarproxy.md#refused-accesses). Of a write the text sent, which the
   *     controller may have stored in another form (docs/reference/wire-format.md#answers); of an
   *     array empty
   * @param tail the end of the answer
   */
  record ValueResponse(int id, MessageType type, String value, Tail tail)
      implements VariableResponse {
    /** Checks the ranges. */
    public ValueResponse {
      Ranges.u16("id", id);
      Ranges.type(type, MessageType.READ, MessageType.WRITE, MessageType.WRITE_ARRAY);
      Ranges.latin1("value", value);
      Ranges.frame("value", 1 + 2 + value.length() + Tail.LENGTH);
    }
  }

  /**
   * Answers {@link ReadArrayRequest}: {@code id, length, 02, value length, numbers, tail}.
   *
   * @param id u16, of the request
   * @param elements u16 each; empty if the access failed
   * @param tail the end of the answer
   */
  record ReadArrayResponse(int id, List<Integer> elements, Tail tail) implements VariableResponse {
    /** Checks the ranges. */
    public ReadArrayResponse {
      elements = List.copyOf(elements);
      Ranges.u16("id", id);
      Ranges.words("element", elements);
      Ranges.frame("elements", 1 + 2 + 2 * elements.size() + Tail.LENGTH);
    }
  }

  /**
   * Answers {@link ReadMultipleRequest} and {@link WriteMultipleRequest} (types 6 and 7): {@code
   * count u8, results}.
   *
   * @param id u16, of the request
   * @param type u8, of the request
   * @param results u8 code and WSTRING value each; 255 at most. Empty if the request was malformed
   *     or the answer is too long
   * @param tail the end of the answer; a failure if one access failed
   */
  record MultipleResponse(int id, MessageType type, List<AccessResult> results, Tail tail)
      implements VariableResponse {
    /** Checks the ranges. */
    public MultipleResponse {
      results = List.copyOf(results);
      Ranges.u16("id", id);
      Ranges.type(type, MessageType.READ_MULTIPLE, MessageType.WRITE_MULTIPLE);
      Ranges.count("results", results, 255);
      long length = results.stream().mapToLong(r -> 1 + Ranges.wide(r.value())).sum();
      Ranges.frame("results", 1 + 1 + length + Tail.LENGTH);
    }
  }

  /**
   * Answers {@link BenchmarkReadRequest} and {@link BenchmarkWriteRequest} (type 17): {@code write,
   * count, iterations, start, stop, difference}.
   *
   * @param id u16, of the request
   * @param write u8, 0 or 1, of the request
   * @param count u8, of the request
   * @param iterations u32, of the request
   * @param startMillis u32, in ms
   * @param stopMillis u32, in ms
   * @param differenceMillis u32, in ms
   * @param tail the end of the answer
   */
  record BenchmarkResponse(
      int id,
      boolean write,
      int count,
      long iterations,
      long startMillis,
      long stopMillis,
      long differenceMillis,
      Tail tail)
      implements VariableResponse {
    /** Checks the ranges. */
    public BenchmarkResponse {
      Ranges.u16("id", id);
      Ranges.u8("count", count);
      Ranges.u32("iterations", iterations);
      Ranges.u32("start", startMillis);
      Ranges.u32("stop", stopMillis);
      Ranges.u32("difference", differenceMillis);
    }
  }
}
