package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.List;

/** Thrown when the server does not support the function of a complete frame. */
public final class UnknownFunctionException extends MalformedFrameException {
  private static final long serialVersionUID = 1L;

  private final int id;
  private final int function;

  /**
   * Creates the exception.
   *
   * @param id the frame's id
   * @param function the function byte
   * @param server the server whose functions are listed
   * @param frame a buffer that begins with the frame
   * @param length the length of the frame
   */
  UnknownFunctionException(int id, int function, ServerType server, byte[] frame, int length) {
    super("function must be " + functions(server) + ", is " + function, frame, length);
    this.id = id;
    this.function = function;
  }

  /** Returns the functions of a server, as ranges. */
  private static String functions(ServerType server) {
    List<String> ranges = new ArrayList<>();
    int first = 0;
    int last = -1;
    for (MessageType type : server.types()) {
      if (type.code() != last + 1) {
        add(ranges, first, last);
        first = type.code();
      }
      last = type.code();
    }
    add(ranges, first, last);
    return String.join(", ", ranges);
  }

  private static void add(List<String> ranges, int first, int last) {
    ranges.add(first == last ? String.valueOf(first) : first + " to " + last);
  }

  /**
   * Returns the frame's id, which the answer repeats.
   *
   * @return 0 to 65535
   */
  public int id() {
    return id;
  }

  /**
   * Returns the function byte.
   *
   * @return 0 to 255
   */
  public int function() {
    return function;
  }
}
