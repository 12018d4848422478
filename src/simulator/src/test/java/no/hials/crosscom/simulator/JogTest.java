package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Jogging by axes and in the directions of base, tool and world. */
class JogTest {
  private static final Frame BASE = new Frame(100, 0, 0, 90, 0, 0);
  private static final Frame TOOL = new Frame(0, 0, 100, 0, 0, 30);

  private final Cell cell = new Cell();
  private final Controller controller = cell.controller;

  @BeforeEach
  void selectMode() {
    controller.setMode(OperatingMode.T1);
    cell.set("$BASE", "{X 100,Y 0,Z 0,A 90,B 0,C 0}");
    cell.set("$TOOL", "{X 0,Y 0,Z 100,A 0,B 0,C 30}");
  }

  @AfterEach
  void close() {
    controller.close();
  }

  private Frame tcp() {
    return Frames.product(controller.model().forward(controller.axes()), TOOL);
  }

  private void jog(JogCoordinates coordinates, int number, boolean positive) throws Exception {
    controller.jog(coordinates, number, positive);
    cell.cycles(200);
    controller.releaseJog();
    cell.untilStanding();
  }

  @Test
  void turnsOneAxis() throws Exception {
    jog(JogCoordinates.AXIS, 5, false);

    assertThat(controller.axes().a5()).isLessThan(44.9);
    assertThat(controller.axes().with(4, 45)).isEqualTo(Cell.START);
  }

  @ParameterizedTest
  @CsvSource({"T1, 100, 10", "T1, 10, 1", "T2, 100, 10", "T2, 50, 5"})
  void turnsAxesAtTheirShareForJogging(OperatingMode mode, String override, double percent)
      throws Exception {
    leaveSlowSpeeds();
    controller.setMode(mode);
    cell.set("$OV_JOG", override);
    controller.jog(JogCoordinates.AXIS, 6, true);
    cell.cycles(30); // 10 % of the acceleration: 0.3 s

    assertThat(cell.real("$VEL_AXIS_ACT[6]")).isEqualTo(percent, within(0.01));
  }

  @ParameterizedTest
  @CsvSource({"T1, 100, 0.1", "T1, 10, 0.01", "T2, 100, 0.1", "T2, 50, 0.05"})
  void movesTheToolAtItsSpeedForJogging(OperatingMode mode, String override, double speed)
      throws Exception {
    leaveSlowSpeeds();
    controller.setMode(mode);
    cell.set("$OV_JOG", override);
    controller.jog(JogCoordinates.BASE, 3, true);
    cell.cycles(20);

    assertThat(cell.real("$VEL_ACT")).isEqualTo(speed, within(1e-4));
  }

  /** Sets the speeds of the last program. */
  private void leaveSlowSpeeds() {
    cell.set("$VEL_AXIS[6]", "1");
    cell.set("$ACC_AXIS[6]", "1");
    cell.set("$VEL.CP", "0.001");
    cell.set("$ACC.CP", "0.001");
  }

  @Test
  void followsTheJogOverrideWhileAKeyIsPressed() throws Exception {
    cell.set("$OV_JOG", "50");
    controller.jog(JogCoordinates.BASE, 3, true);
    cell.cycles(20);
    cell.set("$OV_JOG", "10");
    cell.cycles(20);
    assertThat(cell.real("$VEL_ACT")).isEqualTo(0.01, within(1e-4));

    cell.set("$OV_JOG", "100"); // more than at the press from the next one
    cell.cycles(20);
    assertThat(cell.real("$VEL_ACT")).isEqualTo(0.05, within(1e-4));
  }

  @ParameterizedTest
  @CsvSource({"1, true", "2, false", "3, true"})
  void movesAlongTheAxesOfTheBase(int number, boolean positive) throws Exception {
    Frame before = Frames.product(Frames.inverse(BASE), tcp());
    jog(JogCoordinates.BASE, number, positive);

    assertMoved(before, Frames.product(Frames.inverse(BASE), tcp()), number, positive);
  }

  @ParameterizedTest
  @CsvSource({"1, true", "2, false", "3, true"})
  void movesAlongTheAxesOfTheWorld(int number, boolean positive) throws Exception {
    Frame before = tcp();
    jog(JogCoordinates.WORLD, number, positive);

    assertMoved(before, tcp(), number, positive);
  }

  @ParameterizedTest
  @CsvSource({"1, true", "2, false", "3, true"})
  void movesAlongTheAxesOfTheTool(int number, boolean positive) throws Exception {
    Frame before = tcp();
    jog(JogCoordinates.TOOL, number, positive);

    assertMoved(Frame.IDENTITY, Frames.product(Frames.inverse(before), tcp()), number, positive);
  }

  private static void assertMoved(Frame from, Frame to, int number, boolean positive) {
    double[] way = {to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
    for (int i = 0; i < way.length; i++) {
      if (i != number - 1) {
        assertThat(way[i]).isEqualTo(0, within(1e-3));
      } else {
        assertThat(positive ? way[i] : -way[i]).isGreaterThan(0.5);
      }
    }
    Frame turn = Frames.product(Frames.inverse(turn(from)), turn(to));
    assertThat(new double[] {turn.a(), turn.b(), turn.c()})
        .containsExactly(new double[] {0, 0, 0}, within(1e-4));
  }

  private static Frame turn(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  @ParameterizedTest
  @CsvSource({"BASE", "WORLD", "TOOL"})
  void turnsTheToolAboutZOfTheDirections(JogCoordinates coordinates) throws Exception {
    Frame before = tcp();
    jog(coordinates, 4, true);
    Frame after = tcp();

    assertThat(after.x()).isEqualTo(before.x(), within(1e-3));
    assertThat(after.z()).isEqualTo(before.z(), within(1e-3));
    // the turn before or after the orientation
    Frame turned =
        coordinates == JogCoordinates.TOOL
            ? Frames.product(Frames.inverse(turn(before)), turn(after))
            : Frames.product(turn(after), Frames.inverse(turn(before)));
    assertThat(turned.a()).isGreaterThan(0.1);
    assertThat(turned.b()).isEqualTo(0, within(1e-3));
    assertThat(turned.c()).isEqualTo(0, within(1e-3));
  }

  @Test
  void refusesOtherNumbers() {
    assertThatThrownBy(() -> controller.jog(JogCoordinates.TOOL, 7, true))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("jog: the number of the axis must be 1 to 6, is 7");
  }
}
