package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import org.jline.terminal.Attributes;
import org.jline.terminal.Attributes.ControlChar;
import org.jline.terminal.Attributes.LocalFlag;
import org.jline.terminal.Size;
import org.jline.terminal.TerminalBuilder;
import org.jline.utils.AttributedString;
import org.jline.utils.ClosedException;
import org.jline.utils.Curses;
import org.jline.utils.Display;
import org.jline.utils.InfoCmp.Capability;
import org.jspecify.annotations.Nullable;

/**
 * The whole terminal, for content that changes in place. Closing it restores the previous content.
 */
public final class Screen implements AutoCloseable {
  private static final long PERIOD_NANOS = 100_000_000;

  private final Console console;
  private final org.jline.terminal.Terminal terminal;
  private final Display display;
  private final String leave;
  private final boolean colours;
  private Size size = Size.of(0, 0);
  private long next = System.nanoTime();
  private boolean left;

  /** Supplies the lines of the screen. */
  @FunctionalInterface
  public interface ScreenLines {
    /** Returns at most as many lines as fit, none wider than the screen. */
    List<AttributedString> lines(int columns, int rows, boolean colours);
  }

  private Screen(Console console, org.jline.terminal.Terminal terminal) {
    this.console = console;
    this.terminal = terminal;
    this.colours = console.environment("NO_COLOR") == null;
    // keys come at once and are not shown; in the raw mode Ctrl-C would be no signal any more
    Attributes keys = new Attributes(terminal.getAttributes());
    keys.setLocalFlags(EnumSet.of(LocalFlag.ICANON, LocalFlag.ECHO), false);
    keys.setControlChar(ControlChar.VMIN, 0);
    keys.setControlChar(ControlChar.VTIME, 1);
    terminal.setAttributes(keys);
    this.display = new Display(terminal, true);
    // not through the terminal, which may be closed when it is left
    this.leave = sequence(Capability.exit_ca_mode) + sequence(Capability.cursor_normal);
    write(sequence(Capability.enter_ca_mode) + sequence(Capability.cursor_invisible));
  }

  private String sequence(Capability capability) {
    String text = terminal.getStringCapability(capability);
    return text == null ? "" : Curses.tputs(text);
  }

  /** Opens the terminal; returns null if it cannot show a screen. */
  public static @Nullable Screen open(Console console) {
    try {
      return new Screen(
          console, TerminalBuilder.builder().system(true).dumb(false).nativeSignals(false).build());
    } catch (IOException | IllegalStateException e) {
      return null;
    }
  }

  /** Shows the content, at most ten times a second. */
  public void show(ScreenLines content) throws IOException {
    try {
      readKeys();
      if (System.nanoTime() - next >= 0) {
        next = System.nanoTime() + PERIOD_NANOS;
        showNow(content);
      }
    } catch (ClosedException | IllegalStateException e) {
      // a signal ends the JVM, and JLine has closed the terminal already
      left = true;
    }
  }

  private void showNow(ScreenLines content) {
    Size now = terminal.getSize();
    if (now.getRows() != size.getRows() || now.getColumns() != size.getColumns()) {
      size = now;
      display.resize(now);
      display.clear();
    }
    if (Terminal.isForeground()) {
      display.update(content.lines(now.getColumns(), now.getRows(), colours), 0);
    }
  }

  private void readKeys() throws IOException {
    int key = terminal.reader().read(1);
    while (key >= 0) {
      left |= key == 'q' || key == 'Q';
      key = terminal.reader().read(1);
    }
  }

  /** Returns whether the user has pressed q. */
  public boolean isLeft() {
    return left;
  }

  @Override
  public void close() throws IOException {
    // it sets the attributes back, also if JLine has closed the terminal, or is about to
    terminal.close();
    write(leave);
  }

  private void write(String sequence) {
    console.out().print(sequence);
    console.out().flush();
  }
}
