package no.hials.crosscom.cli.base;

import java.io.PrintWriter;
import java.io.StringWriter;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;

/** Prints stack traces whose messages can have text from outside. */
final class StackTrace extends PrintWriter {
  private StackTrace(StringWriter text) {
    super(text);
  }

  /** Returns the lines of the stack trace of a throwable; each message is on one line. */
  static String of(Throwable thrown) {
    StringWriter text = new StringWriter();
    thrown.printStackTrace(new StackTrace(text));
    return text.toString();
  }

  /** Called once for each line. */
  @Override
  public void println(@Nullable Object object) {
    String line = String.valueOf(object);
    String message = line.stripLeading();
    // the indentation is Java's own
    super.println(
        line.substring(0, line.length() - message.length()) + PrintableText.shortened(message));
  }
}
