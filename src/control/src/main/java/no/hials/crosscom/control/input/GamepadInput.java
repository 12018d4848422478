package no.hials.crosscom.control.input;

import com.badlogic.gdx.utils.SharedLibraryLoader;
import com.studiohartman.jamepad.Configuration;
import com.studiohartman.jamepad.ControllerAxis;
import com.studiohartman.jamepad.ControllerButton;
import com.studiohartman.jamepad.ControllerIndex;
import com.studiohartman.jamepad.ControllerManager;
import com.studiohartman.jamepad.ControllerUnpluggedException;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Reads the first gamepad of this computer. Its six axes are X, Y, Z and the rotations A, B, C, or
 * A1 to A6; the directions are those of a person who stands behind the robot.
 *
 * <table>
 *   <caption>The axes</caption>
 *   <tr><th>axis</th><th>control</th><th>+</th></tr>
 *   <tr><td>1</td><td>left stick</td><td>up</td></tr>
 *   <tr><td>2</td><td>left stick</td><td>left</td></tr>
 *   <tr><td>3</td><td>triggers</td><td>right trigger</td></tr>
 *   <tr><td>4</td><td>right stick</td><td>left</td></tr>
 *   <tr><td>5</td><td>right stick</td><td>up</td></tr>
 *   <tr><td>6</td><td>cross</td><td>right</td></tr>
 * </table>
 *
 * <p>The buttons are A, B, X, Y, back and start. The dead-man is either of the two shoulder buttons
 * above the triggers: nothing moves unless one is held. Sticks do not rest at exactly 0, so use a
 * dead zone of 0.1 or more ({@link #shaped}). If the gamepad is unplugged or its radio connection
 * is lost, {@link #read} fails, which stops the robot.
 *
 * <p>It needs Jamepad ({@code com.badlogicgames.jamepad:jamepad}), which is not a dependency of
 * this library. Its jar contains SDL 2 with native code for Linux, macOS and Windows, and it needs
 * no display. The native code is unpacked into a new private folder each time. <b>This class was
 * tested only without a gamepad</b>: SDL starts and finds none. It was never used with a real
 * gamepad.
 *
 * <p>It runs the daemon thread {@code crosscom-input-gamepad}, which polls SDL 200 times a second,
 * until it is closed.
 */
public final class GamepadInput implements InputDevice {
  private static final long POLL_MILLIS = 5;
  private static final long LONGEST_START_SECONDS = 10;

  private final Thread thread = new Thread(this::run, "crosscom-input-gamepad");
  private final CompletableFuture<@Nullable Void> start = new CompletableFuture<>();
  private volatile Input latest = Input.NONE;
  private volatile @Nullable IOException failure;
  private volatile boolean closed;

  /** The state of a gamepad, if it is connected. */
  interface Pad {
    /** Returns an axis, about -1 to 1; a trigger starts at 0. */
    double axis(ControllerAxis axis) throws ControllerUnpluggedException;

    boolean button(ControllerButton button) throws ControllerUnpluggedException;
  }

  /** Uses only SDL's own list of gamepads; the default list causes warnings on stderr. */
  private static final class Manager extends ControllerManager {
    private static boolean loaded;

    private Manager(Configuration configuration) {
      super(configuration);
    }

    /**
     * Loads SDL and creates a manager. Jamepad's own loader would load a file of a predictable
     * folder, which another user can create.
     */
    static synchronized Manager create() throws IOException {
      if (!loaded) {
        NativeLibrary.load(
            ControllerManager.class, new SharedLibraryLoader().mapLibraryName("jamepad"));
        loaded = true;
      }
      Configuration configuration = new Configuration();
      configuration.loadNativeLibrary = false;
      return new Manager(configuration);
    }

    @Override
    public void addMappingsFromFile(String path) {
      // see the stream above
    }
  }

  private GamepadInput() {
    thread.setDaemon(true);
  }

  /**
   * Opens the first gamepad.
   *
   * @return the device; the caller must close it
   * @throws IOException without a gamepad, or if the native library cannot be used
   */
  public static GamepadInput open() throws IOException {
    GamepadInput gamepad = new GamepadInput();
    gamepad.thread.start();
    try {
      gamepad.start.get(LONGEST_START_SECONDS, TimeUnit.SECONDS);
      return gamepad;
    } catch (ExecutionException e) {
      throw new IOException(Objects.requireNonNull(e.getCause()).getMessage(), e.getCause());
    } catch (java.util.concurrent.TimeoutException e) {
      gamepad.closed = true;
      throw new IOException("the gamepad does not answer", e);
    } catch (InterruptedException e) {
      gamepad.closed = true;
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while looking for a gamepad", e);
    }
  }

  /** Runs all SDL calls; SDL must be used by one thread. */
  private void run() {
    ControllerManager manager;
    try {
      manager = Manager.create();
      manager.initSDLGamepad();
    } catch (IOException | RuntimeException | LinkageError e) {
      start.completeExceptionally(new IOException("SDL cannot be used: " + e.getMessage(), e));
      return;
    }
    try {
      poll(manager);
    } catch (ControllerUnpluggedException e) {
      fail(new IOException("the gamepad was unplugged", e));
    } catch (RuntimeException e) {
      fail(new IOException("the gamepad failed: " + e.getMessage(), e));
    } finally {
      manager.quitSDLGamepad();
    }
  }

  private void poll(ControllerManager manager) throws ControllerUnpluggedException {
    manager.update();
    ControllerIndex first = manager.getControllerIndex(0);
    if (!first.isConnected()) {
      start.completeExceptionally(new IOException("no gamepad found"));
      return;
    }
    Pad pad =
        new Pad() {
          @Override
          public double axis(ControllerAxis axis) throws ControllerUnpluggedException {
            return first.getAxisState(axis);
          }

          @Override
          public boolean button(ControllerButton button) throws ControllerUnpluggedException {
            return first.isButtonPressed(button);
          }
        };
    while (!closed) {
      // not update(), which would replace it with another gamepad
      latest = input(pad, System.nanoTime());
      start.complete(null);
      java.util.concurrent.locks.LockSupport.parkNanos(POLL_MILLIS * 1_000_000);
    }
  }

  private void fail(IOException e) {
    failure = e;
    start.completeExceptionally(e);
  }

  /** Converts the state of a gamepad to an input. In SDL, down and right are positive. */
  static Input input(Pad pad, long nanoTime) throws ControllerUnpluggedException {
    List<Double> axes =
        List.of(
            within(-pad.axis(ControllerAxis.LEFTY)),
            within(-pad.axis(ControllerAxis.LEFTX)),
            within(pad.axis(ControllerAxis.TRIGGERRIGHT) - pad.axis(ControllerAxis.TRIGGERLEFT)),
            within(-pad.axis(ControllerAxis.RIGHTX)),
            within(-pad.axis(ControllerAxis.RIGHTY)),
            (pad.button(ControllerButton.DPAD_RIGHT) ? 1.0 : 0)
                - (pad.button(ControllerButton.DPAD_LEFT) ? 1 : 0));
    List<Boolean> buttons =
        List.of(
            pad.button(ControllerButton.A),
            pad.button(ControllerButton.B),
            pad.button(ControllerButton.X),
            pad.button(ControllerButton.Y),
            pad.button(ControllerButton.BACK),
            pad.button(ControllerButton.START));
    boolean deadMan =
        pad.button(ControllerButton.LEFTBUMPER) || pad.button(ControllerButton.RIGHTBUMPER);
    return new Input(axes, buttons, deadMan, nanoTime);
  }

  /** Limits -32768 to -32767. */
  private static double within(double axis) {
    return Math.max(-1, Math.min(1, axis));
  }

  @Override
  public Input read() throws IOException {
    if (failure != null) {
      throw failure;
    }
    return latest;
  }

  @Override
  public void close() {
    closed = true;
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
