package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.protocol.value.KrlValue;
import org.antlr.v4.runtime.Lexer;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.Logger;

/** Runs the program of a CAM system in a JVM of its own, to bound the memory. */
class LargeProgramTest {
  /**
   * 256 MB are promised for a program of 20 MB. The simulation takes 16 MB of them, so there are 12
   * bytes for each byte of the program.
   */
  private static final String HEAP = "-Xmx52m";

  private static final int LENGTH = 3_000_000;

  private static final String POINT = "{X %d.%03d,Y 100.25,Z 690.5,A 0,B 90,C 0%s}";

  private static final List<String> LINES =
      List.of(
          "LIN " + POINT.formatted(600, 125, "") + " C_DIS",
          "LIN " + POINT.formatted(600, 500, ""),
          "SLIN " + POINT.formatted(601, 250, ""),
          "$VEL.CP=0.125",
          "PTP " + POINT.formatted(602, 375, ",S 2,T 35") + " C_PTP",
          "LIN " + POINT.formatted(603, 500, "") + " C_DIS",
          "TRIGGER WHEN DISTANCE=0 DELAY=10 DO $OUT[3]=TRUE",
          "LIN " + POINT.formatted(604, 625, ""),
          "SPLINE\nSPL " + POINT.formatted(605, 750, "") + "\nENDSPLINE",
          "IF $IN[3]==FALSE THEN",
          "LIN " + POINT.formatted(606, 875, ""),
          "ENDIF");

  @TempDir Path folder;

  /** Runs in the other JVM: moves along the first points, jumps to the end and moves again. */
  public static void main(String... args) throws IOException, KrlFileException {
    try (Cell cell = new Cell()) {
      cell.controller.connect(FileTree.inMemory());
      cell.controller.robot().select(cell.controller.load(Path.of(args[0])));
      cell.controller.robot().start();
      cell.runToTheEnd();
      System.out.print(cell.controller.axes().a1() + " " + cell.get("MYINT"));
    }
  }

  @Test
  void aProgramTakesAtMostTwelveTimesTheMemoryOfItsFile() throws Exception {
    StringBuilder text = new StringBuilder("DEF CAM()\nMYINT=1\n");
    LINES.forEach(line -> text.append(line).append('\n'));
    text.append("GOTO LAST\n");
    while (text.length() < LENGTH) {
      LINES.forEach(line -> text.append(line).append('\n'));
    }
    text.append("LAST:\nMYINT=MYINT+1\nPTP {A1 10}\nEND\n");
    Path program = Files.writeString(folder.resolve("cam.src"), text, StandardCharsets.US_ASCII);

    Path shown = folder.resolve("shown");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                HEAP,
                "-cp",
                classPath(),
                LargeProgramTest.class.getName(),
                program.toString())
            .redirectOutput(shown.toFile())
            .redirectError(folder.resolve("errors").toFile())
            .start();
    try {
      int code = process.waitFor();
      assertThat(code).as(Files.readString(folder.resolve("errors"))).isZero();
    } finally {
      process.destroyForcibly();
    }
    assertThat(shown).hasContent("10.0 2");
  }

  private static String classPath() {
    return Stream.of(
            LargeProgramTest.class,
            Controller.class,
            KrlParser.class,
            RobotModel.class,
            KrlValue.class,
            Lexer.class,
            Logger.class,
            Assertions.class)
        .map(LargeProgramTest::place)
        .distinct()
        .collect(Collectors.joining(System.getProperty("path.separator")));
  }

  private static String place(Class<?> type) {
    try {
      return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
