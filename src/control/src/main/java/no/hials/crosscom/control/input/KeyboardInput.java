package no.hials.crosscom.control.input;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.function.LongSupplier;
import org.jline.terminal.Attributes;
import org.jline.terminal.Attributes.ControlChar;
import org.jline.terminal.Attributes.InputFlag;
import org.jline.terminal.Attributes.LocalFlag;
import org.jline.terminal.Terminal;
import org.jline.utils.ClosedException;
import org.jline.utils.NonBlockingReader;
import org.jspecify.annotations.Nullable;

/**
 * Reads keys of the terminal. Its six axes are X, Y, Z and the rotations A, B, C, or A1 to A6:
 *
 * <table>
 *   <caption>The keys</caption>
 *   <tr><th>axis</th><th>1</th><th>2</th><th>3</th><th>4</th><th>5</th><th>6</th></tr>
 *   <tr><td>+</td><td>w, up</td><td>a, left</td><td>r, page up</td><td>u</td><td>i</td><td>o</td>
 *   </tr>
 *   <tr><td>-</td><td>s, down</td><td>d, right</td><td>f, page down</td><td>j</td><td>k</td>
 *   <td>l</td></tr>
 * </table>
 *
 * <p>{@code +} and {@code -} change the deflection by a tenth, space releases all keys, and {@code
 * q} ends the input ({@link #isEnded}). Capital letters work too.
 *
 * <p><b>The dead-man is the repeat of the key.</b> A terminal reports a key when it is pressed and
 * repeatedly while it is held; it never reports the release. So a key counts as held for {@link
 * #HOLD} after each report. As a consequence, the robot moves on for that time after the key is
 * released. It stops between the first and the second report, since keyboards wait 200 to 600 ms
 * before they repeat. Of several keys only the last is used, since only that key repeats. A repeat
 * slower than {@code HOLD} causes a motion with stops.
 *
 * <p>Keys are read at once and are not echoed. Ctrl-Z and Ctrl-S do nothing, since a suspended
 * program could not stop a robot; Ctrl-C still sends its signal. {@link #close} restores the
 * terminal, even while the JVM shuts down, as after Ctrl-C. The class needs JLine ({@code
 * org.jline:jline}), which is not a dependency of this library. It runs the daemon thread {@code
 * crosscom-input-keyboard} until it is closed.
 */
public final class KeyboardInput implements InputDevice {
  /**
   * The time for which a key counts as held after a report, in ms; longer than the repeat of
   * keyboards.
   */
  public static final int HOLD = 150;

  private static final int AXES = 6;
  private static final int STEPS = 10;
  private static final long POLL_MILLIS = 50;

  /** The longest wait for the end of the typing before and after the use. */
  private static final long DISCARD_MILLIS = 2000;

  /** The maximum time between the parts of an escape sequence. */
  private static final long SEQUENCE_MILLIS = 200;

  /** The keys of the axes, + and - of each axis in turn. */
  private static final String KEYS = "wsadrfujikol";

  /** The final characters of the arrow sequences (ECMA-48), in the order of the equivalent keys. */
  private static final String ARROWS = "ABDC";

  private static final String PAGE_UP = "5";
  private static final String PAGE_DOWN = "6";
  private static final int ESCAPE = 0x1b;
  private static final int FIRST_FINAL = 0x40;
  private static final int BELL = 7;

  /** The characters after the escape of a string from the terminal: DCS, OSC, SOS, PM, APC. */
  private static final String STRINGS = "P]X^_";

  private static final int STRING_END = '\\';

  private final Terminal terminal;
  private final LongSupplier clock;
  private final Thread thread;
  private volatile Press last = new Press(0, 0, 0);
  private volatile int steps = STEPS;
  private volatile boolean ended;
  private volatile boolean closed;
  private volatile @Nullable IOException failure;

  /** A key of an axis; the direction is 0 for no key. */
  private record Press(int axis, int direction, long nanos) {}

  private KeyboardInput(Terminal terminal, LongSupplier clock) {
    this.terminal = terminal;
    this.clock = clock;
    takeSingleKeys(terminal);
    thread = new Thread(this::run, "crosscom-input-keyboard");
    thread.setDaemon(true);
  }

  /** Passes keys on at once, without an echo; Ctrl-C still sends its signal. */
  private static void takeSingleKeys(Terminal terminal) {
    Attributes keys = new Attributes(terminal.getAttributes());
    keys.setLocalFlags(EnumSet.of(LocalFlag.ICANON, LocalFlag.ECHO), false);
    keys.setInputFlag(InputFlag.IXON, false);
    keys.setControlChar(ControlChar.VSUSP, 0);
    keys.setControlChar(ControlChar.VMIN, 0);
    keys.setControlChar(ControlChar.VTIME, 1);
    terminal.setAttributes(keys);
  }

  /**
   * Opens the terminal of this process. Discards the keys that were typed before, so that they move
   * nothing. While a key is still held it waits for its release, at most 2 s.
   *
   * @return the device; the caller must close it
   * @throws IOException without a terminal, or if a key is held
   */
  public static KeyboardInput open() throws IOException {
    Terminal terminal;
    try {
      terminal = TypedKeys.openTerminal();
    } catch (IOException e) {
      throw new IOException("the keyboard needs a terminal: " + e.getMessage(), e);
    }
    if (terminal.getType().startsWith(Terminal.TYPE_DUMB)) { // sends whole lines, not single keys
      terminal.close();
      throw new IOException("the keyboard needs a terminal that sends single keys, TERM is dumb");
    }
    try {
      TypedKeys.drop(terminal);
    } catch (IllegalStateException e) {
      // it is closed already, which is reported below
    }
    return on(terminal, System::nanoTime);
  }

  static KeyboardInput on(Terminal terminal, LongSupplier clock) throws IOException {
    KeyboardInput keyboard;
    try {
      keyboard = new KeyboardInput(terminal, clock);
    } catch (IllegalStateException e) {
      terminal.close();
      throw new IOException("the terminal is already closed, as while the JVM shuts down", e);
    }
    if (!keyboard.discardKeys()) {
      terminal.close();
      throw new IOException("a key is held down: release it and start again");
    }
    keyboard.thread.start();
    return keyboard;
  }

  private void run() {
    NonBlockingReader reader = terminal.reader();
    try {
      while (!closed) {
        // in pieces, so that this thread ends soon after close()
        int next = reader.read(POLL_MILLIS);
        if (next == ESCAPE) {
          sequence(reader);
        } else if (next >= 0) {
          take(Character.toLowerCase((char) next));
        } else if (next != NonBlockingReader.READ_EXPIRED) {
          throw new ClosedException();
        }
      }
    } catch (ClosedException e) {
      // not a failure if it was closed by this class, by its user, or by JLine at JVM shutdown
      ended = true;
    } catch (IOException | RuntimeException | java.io.IOError e) {
      if (!closed) {
        failure = e instanceof IOException io ? io : new IOException("no more keys: " + e, e);
      }
    }
  }

  /**
   * Reads the rest of an escape sequence, whether a key or a report of the terminal, so that no
   * part of it is taken for a key.
   */
  private void sequence(NonBlockingReader reader) throws IOException {
    int kind = reader.read(SEQUENCE_MILLIS);
    if (kind == 'O') {
      takeSequence("", reader.read(SEQUENCE_MILLIS));
    } else if (kind == '[') {
      StringBuilder parameters = new StringBuilder();
      int next = reader.read(SEQUENCE_MILLIS);
      while (next >= ' ' && next < FIRST_FINAL) {
        parameters.append((char) next);
        next = reader.read(SEQUENCE_MILLIS);
      }
      takeSequence(parameters.toString(), next);
    } else if (kind >= 0 && STRINGS.indexOf(kind) >= 0) {
      int next = reader.read(SEQUENCE_MILLIS);
      while (next >= 0 && next != BELL && next != STRING_END) {
        next = reader.read(SEQUENCE_MILLIS);
      }
    }
  }

  private void takeSequence(String parameters, int end) {
    int arrow = end >= 0 ? ARROWS.indexOf(end) : -1;
    if (parameters.isEmpty() && arrow >= 0) {
      take(KEYS.charAt(arrow));
    } else if (parameters.equals(PAGE_UP) && end == '~') {
      take('r');
    } else if (parameters.equals(PAGE_DOWN) && end == '~') {
      take('f');
    }
  }

  private void take(char key) {
    int move = KEYS.indexOf(key);
    if (move >= 0) {
      last = new Press(move / 2, move % 2 == 0 ? 1 : -1, clock.getAsLong());
    } else if (key == ' ') {
      last = new Press(0, 0, clock.getAsLong());
    } else if (key == '+') {
      steps = Math.min(STEPS, steps + 1);
    } else if (key == '-') {
      steps = Math.max(1, steps - 1);
    } else if (key == 'q') {
      ended = true;
    }
  }

  @Override
  public Input read() throws IOException {
    if (failure != null) {
      throw failure;
    }
    Press press = last;
    long age = clock.getAsLong() - press.nanos();
    if (ended || press.direction() == 0 || age > HOLD * 1_000_000L) {
      return new Input(Collections.nCopies(AXES, 0.0), List.of(), false, press.nanos());
    }
    List<Double> axes = new ArrayList<>(Collections.nCopies(AXES, 0.0));
    axes.set(press.axis(), press.direction() * scale());
    return new Input(axes, List.of(), true, press.nanos());
  }

  /**
   * Returns the deflection of an axis by a held key, which {@code +} and {@code -} change.
   *
   * @return 0.1 to 1, initially 1
   */
  public double scale() {
    return (double) steps / STEPS;
  }

  /**
   * Returns whether the user has pressed {@code q} or the terminal is closed. From then on nothing
   * moves.
   */
  public boolean isEnded() {
    return ended;
  }

  /** Discards keys until no key is held; returns false if one is still held after some time. */
  private boolean discardKeys() {
    long end = System.nanoTime() + DISCARD_MILLIS * 1_000_000;
    try {
      NonBlockingReader reader = terminal.reader();
      while (reader.read(HOLD) >= 0) {
        if (System.nanoTime() >= end) {
          return false;
        }
      }
    } catch (IOException | RuntimeException | java.io.IOError e) {
      // the terminal is closed, and has no more keys
    }
    return true;
  }

  /**
   * Discards the keys that were typed meanwhile, so that a shell does not run them, and restores
   * the terminal. While a key is still held it waits for its release, at most 2 s.
   */
  @Override
  public void close() throws IOException {
    closed = true;
    try {
      thread.join();
      discardKeys();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    // close() always restores the attributes. At JVM shutdown JLine closes its terminals itself,
    // after which setAttributes() is refused; close() waits for that.
    terminal.close();
  }
}
