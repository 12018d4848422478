package no.hials.crosscom.control.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.badlogic.gdx.utils.SharedLibraryLoader;
import com.studiohartman.jamepad.ControllerAxis;
import com.studiohartman.jamepad.ControllerButton;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Converts the state of a gamepad to input, without a real gamepad. */
class GamepadInputTest {
  private final Map<ControllerAxis, Double> sticks = new EnumMap<>(ControllerAxis.class);
  private final Set<ControllerButton> pressed = EnumSet.noneOf(ControllerButton.class);

  private Input input() throws Exception {
    return GamepadInput.input(
        new GamepadInput.Pad() {
          @Override
          public double axis(ControllerAxis axis) {
            return sticks.getOrDefault(axis, 0.0);
          }

          @Override
          public boolean button(ControllerButton button) {
            return pressed.contains(button);
          }
        },
        7);
  }

  @ParameterizedTest
  @CsvSource({
    "LEFTY, -1, 0, 1",
    "LEFTX, -1, 1, 1",
    "LEFTX, 0.5, 1, -0.5",
    "TRIGGERRIGHT, 1, 2, 1",
    "TRIGGERLEFT, 0.25, 2, -0.25",
    "RIGHTX, -1, 3, 1",
    "RIGHTY, -1, 4, 1"
  })
  void aStickDeflectsOneAxis(ControllerAxis stick, double raw, int axis, double deflection)
      throws Exception {
    sticks.put(stick, raw);

    Input input = input();

    for (int i = 0; i < 6; i++) {
      assertThat(input.axis(i)).isEqualTo(i == axis ? deflection : 0.0, offset());
    }
    assertThat(input.deadMan()).isFalse();
    assertThat(input.nanoTime()).isEqualTo(7);
  }

  private static org.assertj.core.data.Offset<Double> offset() {
    return org.assertj.core.api.Assertions.within(1e-12);
  }

  @ParameterizedTest
  @CsvSource({"DPAD_RIGHT, 1", "DPAD_LEFT, -1"})
  void theCrossDeflectsTheLastAxis(ControllerButton button, double deflection) throws Exception {
    pressed.add(button);

    assertThat(input().axis(5)).isEqualTo(deflection);
  }

  @ParameterizedTest
  @CsvSource({"LEFTBUMPER, true", "RIGHTBUMPER, true", "A, false", "START, false"})
  void onlyAShoulderButtonIsTheDeadMan(ControllerButton button, boolean deadMan) throws Exception {
    pressed.add(button);

    assertThat(input().deadMan()).isEqualTo(deadMan);
  }

  @Test
  void aStickBeyondTheRangeThatSdlHasOnOneSideIsAtTheEndOfIt() throws Exception {
    sticks.put(ControllerAxis.LEFTX, -32768 / 32767.0);

    assertThat(input().axis(1)).isEqualTo(1);
  }

  @Test
  void buttonsHaveTheirOrder() throws Exception {
    pressed.addAll(EnumSet.of(ControllerButton.B, ControllerButton.START));

    assertThat(input().buttons()).containsExactly(false, true, false, false, false, true);
  }

  @Test
  void withoutAGamepadItSaysSoEachTime() {
    assumeThat(Files.exists(Path.of("/dev/input"))).as("this computer has no devices").isFalse();
    assumeThat(System.getProperty("os.name")).isEqualTo("Linux");

    for (int i = 0; i < 2; i++) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(GamepadInput::open)
          .withMessage("no gamepad found");
    }
    assertThat(SharedLibraryLoader.isLoaded("jamepad"))
        .as("loaded from the predictable folder of Jamepad's loader")
        .isFalse();
  }
}
