package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Runs the Python example if a suitable Python is installed. */
class PythonExampleTest {
  private static final String PYTHON =
      System.getenv().getOrDefault("PYTHON", "python3"); // for example of a virtual environment

  private record Result(int exitCode, String output) {}

  private static Result python(String... arguments) throws IOException, InterruptedException {
    ProcessBuilder builder = new ProcessBuilder(PYTHON);
    builder.command().addAll(List.of(arguments));
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    Process process = builder.redirectErrorStream(true).start();
    try {
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return new Result(process.waitFor(), output);
    } finally {
      process.destroyForcibly();
    }
  }

  @BeforeAll
  static void findPython() throws InterruptedException {
    boolean found;
    try {
      found = python("-c", "import jpype").exitCode() == 0;
    } catch (IOException e) {
      found = false;
    }
    assumeTrue(
        found,
        PYTHON
            + " with examples/python/requirements.txt must be there, is not; the environment"
            + " variable PYTHON names another one");
  }

  @Test
  @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD, unit = TimeUnit.SECONDS)
  void readAndMoveDoesWhatTheJavaExampleDoes() throws Exception {
    Path script = Path.of("python", "read_and_move.py").toAbsolutePath();

    Result result = python(script.toString(), "--jar", classPath());

    assertThat(result.output().lines())
        .contains(
            "mode #T1",
            "A1 to A6 in degrees: [0.0, -90.0, 90.0, 0.0, 0.0, 0.0]",
            "override in %: 50",
            "refused: NO_SUCH_VARIABLE",
            "A1 is at 3.0 degrees");
    assertThat(result.exitCode()).isZero();
  }

  /** Returns the classes of this build, so that no jar is needed. */
  private static String classPath() {
    return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
  }
}
