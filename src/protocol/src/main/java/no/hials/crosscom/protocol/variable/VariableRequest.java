package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.internal.Ranges;

/** Asks to read or write variables, or to measure how long that takes. */
public sealed interface VariableRequest extends Request {

  /**
   * Asks for the text of a variable: {@code id, length, 00, name length, name}.
   *
   * @param id u16, echoed in the answer
   * @param name u16 byte count and ISO 8859-1 bytes; 65,532 at most
   */
  record ReadRequest(int id, String name) implements VariableRequest {
    /** Checks the ranges. */
    public ReadRequest {
      Ranges.u16("id", id);
      Ranges.latin1("name", name);
      Ranges.frame("name", 1 + 2 + name.length());
    }
  }

  /**
   * Sets a variable from text: {@code id, length, 01, name length, name, value length, value}.
   *
   * @param id u16, echoed in the answer
   * @param name u16 byte count and ISO 8859-1 bytes
   * @param value u16 byte count and ISO 8859-1 bytes; name and value have 65,530 together at most
   */
  record WriteRequest(int id, String name, String value) implements VariableRequest {
    /** Checks the ranges. */
    public WriteRequest {
      Ranges.u16("id", id);
      Ranges.assignment(name, value);
    }
  }

  /**
   * Asks for an INT array as 16-bit numbers: {@code id, length, 02, name length, name}.
   *
   * @param id u16, echoed in the answer
   * @param name u16 byte count and ISO 8859-1 bytes; 65,532 at most
   */
  record ReadArrayRequest(int id, String name) implements VariableRequest {
    /** Checks the ranges. */
    public ReadArrayRequest {
      Ranges.u16("id", id);
      Ranges.latin1("name", name);
      Ranges.frame("name", 1 + 2 + name.length());
    }
  }

  /**
   * Sets the elements of an array from 16-bit numbers: {@code id, length, 03, name length, name,
   * value length, numbers}. Assumed: the value length counts bytes, as in every other message, and
   * not numbers (docs/reference/wire-format.md#integer-arrays).
   *
   * @param id u16, echoed in the answer
   * @param name u16 byte count and ISO 8859-1 bytes
   * @param elements u16 each, for {@code NAME[1]}, {@code NAME[2]}, ...
   */
  record WriteArrayRequest(int id, String name, List<Integer> elements) implements VariableRequest {
    /** Checks the ranges. */
    public WriteArrayRequest {
      elements = List.copyOf(elements);
      Ranges.u16("id", id);
      Ranges.latin1("name", name);
      Ranges.words("element", elements);
      Ranges.frame("name and elements", 1 + 2 + name.length() + 2 + 2 * elements.size());
    }
  }

  /**
   * Asks for the text of a variable (type 4): {@code name}.
   *
   * @param id u16, echoed in the answer
   * @param name WSTRING: u16 count of characters and UTF-16, little-endian; 32,766 at most
   */
  record ReadUtf16Request(int id, String name) implements VariableRequest {
    /** Checks the ranges. */
    public ReadUtf16Request {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + Ranges.wide(name));
    }
  }

  /**
   * Sets a variable from text (type 5): {@code name, value}.
   *
   * @param id u16, echoed in the answer
   * @param name WSTRING
   * @param value WSTRING; name and value have 32,765 characters together at most
   */
  record WriteUtf16Request(int id, String name, String value) implements VariableRequest {
    /** Checks the ranges. */
    public WriteUtf16Request {
      Ranges.u16("id", id);
      Ranges.frame("name and value", 1 + Ranges.wide(name) + Ranges.wide(value));
    }
  }

  /**
   * Asks for the texts of several variables (type 6): {@code count u8, names}.
   *
   * @param id u16, echoed in the answer
   * @param names WSTRING each; 255 at most
   */
  record ReadMultipleRequest(int id, List<String> names) implements VariableRequest {
    /** Checks the ranges. */
    public ReadMultipleRequest {
      names = List.copyOf(names);
      Ranges.u16("id", id);
      Ranges.count("names", names, 255);
      Ranges.frame("names", 1 + 1 + Ranges.wide(names));
    }
  }

  /**
   * Sets several variables from texts (type 7): {@code count u8, assignments}.
   *
   * @param id u16, echoed in the answer
   * @param count u8; the announced number of assignments. If fewer follow, a server does those and
   *     then reports an error (docs/reference/c3-messages.md#framing); only {@link
   *     Strictness#LENIENT} reads such a request
   * @param assignments WSTRING name and WSTRING value each; 255 at most
   */
  record WriteMultipleRequest(int id, int count, List<Assignment> assignments)
      implements VariableRequest {
    /** Checks the ranges. */
    public WriteMultipleRequest {
      assignments = List.copyOf(assignments);
      Ranges.u16("id", id);
      Ranges.count("assignments", assignments, 255);
      Ranges.u8("count", count);
      Ranges.count("assignments", assignments, count);
      Ranges.frame("assignments", 1 + 1 + Assignment.length(assignments));
    }

    /**
     * Creates a request that announces the number of its assignments.
     *
     * @param id 0 to 65535
     * @param assignments 255 at most
     */
    public WriteMultipleRequest(int id, List<Assignment> assignments) {
      this(id, assignments.size(), assignments);
    }
  }

  /**
   * Asks to measure how long reading takes (type 17): {@code 00, count u8, iterations, names}.
   *
   * @param id u16, echoed in the answer
   * @param iterations u32
   * @param names WSTRING each; 255 at most, of which the server uses 10
   */
  record BenchmarkReadRequest(int id, long iterations, List<String> names)
      implements VariableRequest {
    /** Checks the ranges. */
    public BenchmarkReadRequest {
      names = List.copyOf(names);
      Ranges.u16("id", id);
      Ranges.u32("iterations", iterations);
      Ranges.count("names", names, 255);
      Ranges.frame("names", 1 + 1 + 1 + 4 + Ranges.wide(names));
    }
  }

  /**
   * Asks to measure how long writing takes (type 17): {@code 01, count u8, iterations,
   * assignments}.
   *
   * @param id u16, echoed in the answer
   * @param iterations u32
   * @param assignments WSTRING name and WSTRING value each; 255 at most, of which the server uses
   *     10
   */
  record BenchmarkWriteRequest(int id, long iterations, List<Assignment> assignments)
      implements VariableRequest {
    /** Checks the ranges. */
    public BenchmarkWriteRequest {
      assignments = List.copyOf(assignments);
      Ranges.u16("id", id);
      Ranges.u32("iterations", iterations);
      Ranges.count("assignments", assignments, 255);
      Ranges.frame("assignments", 1 + 1 + 1 + 4 + Assignment.length(assignments));
    }
  }
}
