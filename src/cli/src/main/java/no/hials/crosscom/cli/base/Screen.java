package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
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
import org.jline.utils.Signals;
import org.jspecify.annotations.Nullable;

/**
 * The whole terminal, for content that changes in place. Closing it restores the previous content,
 * and so does Ctrl-Z, until the program is in the foreground again.
 */
public final class Screen implements AutoCloseable {
  private static final long PERIOD_NANOS = 100_000_000;
  private static final int CTRL_Z = 0x1A;
  private static final String CONTINUED = "CONT";

  private final Console console;
  private final org.jline.terminal.Terminal terminal;

  /** Whether the terminal is that of a shell, which stays open. */
  private final boolean borrowed;

  private final Attributes before;
  private final Attributes keys;
  private final Display display;
  private final String enter;
  private final String leave;
  private final boolean colours;

  /** The previous handler of the signal that comes after a stop. */
  private final @Nullable Object continuedBefore;

  /** Set by that signal: the shell has used the terminal meanwhile. */
  private final AtomicBoolean continued = new AtomicBoolean();

  private boolean entered;
  private Size size = Size.of(0, 0);
  private long next = System.nanoTime();
  private boolean left;

  /** Supplies the lines of the screen. */
  @FunctionalInterface
  public interface ScreenLines {
    /** Returns at most as many lines as fit, none wider than the screen. */
    List<AttributedString> lines(int columns, int rows, boolean colours);
  }

  private Screen(Console console, org.jline.terminal.Terminal terminal, boolean borrowed) {
    this.console = console;
    this.terminal = terminal;
    this.borrowed = borrowed;
    this.colours = console.environment("NO_COLOR") == null;
    this.before = new Attributes(terminal.getAttributes());
    // keys arrive at once and are not shown; in raw mode Ctrl-C would not send a signal
    this.keys = new Attributes(before);
    keys.setLocalFlags(EnumSet.of(LocalFlag.ICANON, LocalFlag.ECHO), false);
    keys.setControlChar(ControlChar.VMIN, 0);
    keys.setControlChar(ControlChar.VTIME, 1);
    // a key as well, so that the terminal is restored before the process stops
    keys.setControlChar(ControlChar.VSUSP, 0);
    this.display = new Display(terminal, true);
    this.enter = sequence(Capability.enter_ca_mode) + sequence(Capability.cursor_invisible);
    // not through the terminal, which may be closed when it is left
    this.leave = sequence(Capability.exit_ca_mode) + sequence(Capability.cursor_normal);
    this.continuedBefore = Signals.register(CONTINUED, () -> continued.set(true));
    enter();
  }

  private String sequence(Capability capability) {
    String text = terminal.getStringCapability(capability);
    return text == null ? "" : Curses.tputs(text);
  }

  /**
   * Opens the terminal; returns null if it cannot show a screen.
   *
   * @param console may have a terminal that is open already
   */
  public static @Nullable Screen open(Console console) {
    org.jline.terminal.Terminal open = console.terminal();
    if (open != null) {
      return new Screen(console, open, true);
    }
    try {
      return new Screen(
          console,
          TerminalBuilder.builder().system(true).dumb(false).nativeSignals(false).build(),
          false);
    } catch (IOException | IllegalStateException e) {
      return null;
    }
  }

  private void enter() {
    terminal.setAttributes(keys);
    write(enter);
    size = Size.of(0, 0); // draws everything
    entered = true;
  }

  /** Shows the content, at most ten times a second. */
  public void show(ScreenLines content) throws IOException {
    try {
      if (continued.getAndSet(false)) {
        entered = false;
      }
      if (!Terminal.isForeground()) {
        return;
      }
      if (!entered) {
        enter();
      }
      readKeys();
      if (System.nanoTime() - next >= 0) {
        next = System.nanoTime() + PERIOD_NANOS;
        showNow(content);
      }
    } catch (ClosedException | IllegalStateException e) {
      // a signal ends the JVM, and JLine has closed the terminal already
      left = true;
    } catch (InterruptedIOException e) {
      Thread.currentThread().interrupt(); // by Ctrl-C in a shell
    }
  }

  private void showNow(ScreenLines content) {
    Size now = terminal.getSize();
    if (now.getRows() != size.getRows() || now.getColumns() != size.getColumns()) {
      size = now;
      display.resize(now);
      display.clear();
    }
    display.update(content.lines(now.getColumns(), now.getRows(), colours), 0);
  }

  private void readKeys() throws IOException {
    int key = terminal.reader().read(1);
    while (key >= 0) {
      left |= key == 'q' || key == 'Q';
      if (key == CTRL_Z) {
        suspend();
      }
      key = terminal.reader().read(1);
    }
  }

  /** Stops the process as Ctrl-Z does elsewhere, if there is a shell to continue it. */
  private void suspend() throws IOException {
    terminal.setAttributes(before);
    write(leave);
    entered = false;
    try {
      // the whole job; without a shell that watches jobs, the system ignores it
      new ProcessBuilder("sh", "-c", "kill -TSTP 0").inheritIO().start().waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns whether the user has pressed q. */
  public boolean isLeft() {
    return left;
  }

  @Override
  public void close() throws IOException {
    if (continuedBefore != null) { // null where signals cannot be handled
      Signals.unregister(CONTINUED, continuedBefore);
    }
    if (borrowed) {
      terminal.setAttributes(before);
    } else {
      // this restores the attributes even if JLine has closed the terminal, or is about to
      terminal.close();
    }
    write(leave);
  }

  private void write(String sequence) {
    console.out().print(sequence);
    console.out().flush();
  }
}
