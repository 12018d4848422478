package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.List;

/** Says that a frame is whole but of a function that the server does not have. */
public final class UnknownFunctionException extends MalformedFrameException {
  private static final long serialVersionUID = 1L;

  private final int id;
  private final int function;

  /**
   * Makes the exception.
   *
   * @param id the frame's id
   * @param function its function byte
   * @param server whose functions were known
   * @param frame a buffer that begins with the frame
   * @param length its length
   */
  UnknownFunctionException(int id, int function, ServerType server, byte[] frame, int length) {
    super("function must be " + functions(server) + ", is " + function, frame, length);
    this.id = id;
    this.function = function;
  }

  /** Lists the functions: numbers that follow each other as the first and the last. */
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
   * Gives the frame's id, by which a server answers it.
   *
   * @return 0 to 65535
   */
  public int id() {
    return id;
  }

  /**
   * Gives the function byte.
   *
   * @return 0 to 255
   */
  public int function() {
    return function;
  }
}
