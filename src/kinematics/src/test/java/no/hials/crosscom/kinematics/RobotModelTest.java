package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Robots.KR6;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Properties;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class RobotModelTest {

  @Test
  void anotherModelIsAFile() {
    RobotModel robot = Robots.INVENTED;
    // The arm stretched upwards: A1 to A6 at the offsets of the file.
    Frame stretched = robot.forward(Axis.of(10, -90, 90, 5, 0, -20));

    assertThat(robot.name()).isEqualTo("Invented R700");
    assertThat(stretched.x()).isEqualTo(30 + 20, within(1e-9));
    assertThat(stretched.y()).isEqualTo(15, within(1e-9));
    assertThat(stretched.z()).isEqualTo(380 + 335 + 365 + 90, within(1e-9));
    assertThat(angle(stretched, Frame.IDENTITY)).isLessThan(1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "a1; ; a1: expected a value, found none",
        "home; ; home: expected a value, found none",
        "c4; long; c4: expected a number, found long",
        "b; NaN; b: expected a number, found NaN",
        "c2; 0; c2: expected a number above 0, found 0",
        "c3; -420; c3: expected a number above 0, found -420",
        "offset; 0 -90 0 0 0; offset: expected six numbers, found 0 -90 0 0 0",
        "sign; 1 1 1 1 1 2; sign: expected six numbers, each 1 or -1, found 2",
        "speed; 1 1 -1 1 1 1; speed: expected six numbers above 0, found -1",
        "acceleration; 1 1 1 1 1 0; acceleration: expected six numbers above 0, found 0",
        "minimum; 0 45 0 0 0 0; minimum: expected less than the maximum of A2, 45.0, found 45.0",
        "home; 0 -90 157 0 0 0; home: expected A3 from -120.0 to 156.0, found 157.0",
        "c5; 1; c5: expected one of [a1, a2, acceleration, b, c1, c2, c3, c4, home, maximum,"
            + " minimum, name, offset, sign, speed], found this key"
      })
  void namesFileKeyAndRule(String key, String value, String message) throws IOException {
    String text = changed(key, value);

    assertThatIOException()
        .isThrownBy(() -> RobotModel.load(new StringReader(text), "mine.properties"))
        .withMessage("mine.properties: " + message);
  }

  @Test
  void namesTheFileThatIsNoPropertiesFile() {
    assertThatIOException()
        .isThrownBy(() -> RobotModel.load(new StringReader("name = \\u12"), "mine.properties"))
        .withMessageStartingWith("mine.properties: expected a properties file, found ");
  }

  @Test
  void aFileThatIsNotThereIsSaidSo() {
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> RobotModel.load(Path.of("no-such-robot.properties")));
  }

  @Test
  void findsTheAxesOutsideTheirLimits() {
    assertThat(KR6.axesOutsideLimits(KR6.home())).isEmpty();
    assertThat(KR6.axesOutsideLimits(Axis.of(-170, 45, 0, 0, 0, 350))).isEmpty();
    assertThat(KR6.axesOutsideLimits(Axis.of(-170.1, 45, 0, 0, 0, 350.1))).containsExactly(0, 5);
  }

  @Test
  void findsTheAxesThatDoNotKeepAMargin() {
    Axis axes = Axis.of(-165, 40.1, 0, 0, 0, 0);

    assertThat(KR6.axesOutsideLimits(axes, 5)).containsExactly(1);
    assertThat(KR6.axesOutsideLimits(axes, 5.1)).containsExactly(0, 1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY})
  void refusesAMarginThatIsNotFinite(double margin) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> KR6.axesOutsideLimits(Axis.ZERO, margin))
        .withMessage("margin must be finite, is " + margin);
  }

  @Test
  void narrowerLimitsHoldForTheInverse() throws Exception {
    Axis axes = Axis.of(20, -80, 100, 30, 60, 40);
    Frame flange = KR6.forward(axes);
    Axis widest = Axis.of(190, 190, 190, 190, 190, 360);
    RobotModel narrow = KR6.withLimits(Axis.ZERO.minus(widest), widest.with(0, 15));

    assertThat(KR6.inverse(flange, axes).a1()).isEqualTo(20, within(1e-9));
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> narrow.inverse(flange, axes))
        .withMessage("axis limit A1 15.0 exceeded, would be 20.0000 degrees");
    assertThat(narrow.maximum(0)).isEqualTo(15);
    assertThat(KR6.maximum(0)).isEqualTo(170);
  }

  @Test
  void refusesLimitsThatLeaveNoRoom() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> KR6.withLimits(Axis.ZERO, Axis.of(1, 1, 0, 1, 1, 1)))
        .withMessage("the minimum of A3 must be less than its maximum, are 0.0 and 0.0");
  }

  /** Returns the file of the KR 6 R900 sixx with one key changed or omitted. */
  private static String changed(String key, String value) throws IOException {
    Properties properties = new Properties();
    try (InputStream file = RobotModel.class.getResourceAsStream("kr6r900sixx.properties")) {
      properties.load(Objects.requireNonNull(file));
    }
    if (value == null) {
      properties.remove(key);
    } else {
      properties.setProperty(key, value);
    }
    StringWriter text = new StringWriter();
    properties.store(text, null);
    return text.toString();
  }
}
