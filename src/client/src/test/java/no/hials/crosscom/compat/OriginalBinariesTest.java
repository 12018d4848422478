package no.hials.crosscom.compat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.tools.JavaFileObject;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs programs that were compiled against the original's signatures, without compiling them again:
 * their class files meet only the classes of this client. Each runs in a class loader of its own.
 */
class OriginalBinariesTest {
  /** Closed at the end only: a client's last callbacks run after its program. */
  private static final List<URLClassLoader> LOADERS = new ArrayList<>();

  @TempDir private static Path folder;

  @KukaController private MockServer robot;

  static List<String> programs() {
    return List.of(
        "Console",
        "Window",
        "Setters",
        "RawTypes",
        "Requests",
        "OwnClasses",
        "Ids",
        "Factories",
        "Version01");
  }

  /** The class loaders have slf4j without a provider, as the original's users have. */
  @BeforeAll
  static void silenceMissingProvider() {
    System.setProperty("slf4j.internal.verbosity", "ERROR");
  }

  @AfterAll
  static void closeLoaders() throws IOException {
    for (URLClassLoader loader : LOADERS) {
      loader.close();
    }
  }

  @BeforeAll
  static void compileAgainstTheOriginal() throws Exception {
    new OriginalApi().compileTo(folder.resolve("original"));
    List<JavaFileObject> sources = new ArrayList<>();
    for (String program : programs()) {
      sources.add(OriginalApi.program(program));
    }
    assertThat(
            OriginalApi.compile(
                folder.resolve("programs"),
                sources,
                "--release",
                "8",
                "-classpath",
                folder.resolve("original").toString()))
        .isEmpty();
  }

  @BeforeEach
  void declareVariables() {
    robot.variables().set("$OV_PRO", "100");
    robot.variables().set("$OV_JOG", "10");
    robot.variables().set("MYREAL", "1.25");
    robot.variables().set("MYINT", "4");
    robot.variables().set("MYFRAME", "{X 1.0,Y 2.0,Z 3.0,A 0.0,B 0.0,C 0.0}");
  }

  private List<String> run(String program) throws Exception {
    return run(program, robot);
  }

  private static List<String> run(String program, MockServer server) throws Exception {
    List<URL> places = new ArrayList<>();
    places.add(folder.resolve("programs").toUri().toURL());
    for (Path place : OriginalApi.client()) {
      places.add(place.toUri().toURL());
    }
    URLClassLoader loader =
        new URLClassLoader(places.toArray(new URL[0]), ClassLoader.getPlatformClassLoader());
    LOADERS.add(loader);
    Object printed =
        loader
            .loadClass("program." + program)
            .getMethod("run", String.class, int.class)
            .invoke(null, server.host(), server.port());
    return String.valueOf(printed).replaceAll("\\d+ms", "Nms").lines().toList();
  }

  @ParameterizedTest
  @MethodSource("programs")
  void theSourceOfAProgramCompilesUnchanged(String program) throws Exception {
    String classes =
        OriginalApi.client().stream()
            .map(Path::toString)
            .collect(Collectors.joining(File.pathSeparator));

    assertThat(
            OriginalApi.compile(
                folder.resolve("again-" + program),
                List.of(OriginalApi.program(program)),
                "-classpath",
                classes))
        .isEmpty();
  }

  @Test
  void aConsoleGoesOnAfterAnUnknownName() throws Exception {
    assertThat(run("Console"))
        .containsExactly(
            "$OV_PRO #read time=Nms  #value=100",
            "NOSUCH #read time=Nms  #value=",
            "$MODE_OP #read time=Nms  #value=#T1",
            "NOSUCH #read time=Nms  #value=",
            "$OV_PRO #read time=Nms  #value=50",
            "3[]",
            "Callback{variable=NOSUCH, id=4, option=1, readTime=Nms, value=}");
  }

  @Test
  void aConsoleGoesOnWithC3BridgeToo(
      @KukaController(server = ServerType.C3_BRIDGE) MockServer bridge) throws Exception {
    assertThat(run("Console", bridge))
        .hasSize(7)
        .startsWith("$OV_PRO #read time=Nms  #value=100", "NOSUCH #read time=Nms  #value=")
        .endsWith("Callback{variable=NOSUCH, id=4, option=1, readTime=Nms, value=}");
  }

  @Test
  void whatIsNewStillThrows() throws Exception {
    try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> client.readVariable(new KRLInt("NOSUCH")));
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> client.readText("NOSUCH"));
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> client.writeText("NOSUCH", "1"));
    }
  }

  @Test
  void aWindowShowsTheVariablesAfterAnUnknownName() throws Exception {
    assertThat(run("Window"))
        .containsExactly(
            "$OV_JOG is 10",
            "TYPO was not found",
            "$MODE_OP is #T1",
            "MISSING was not found",
            "$OUT[1] is false");
  }

  @Test
  void theSettersAreFoundByTheirDescriptors() throws Exception {
    assertThat(run("Setters"))
        .containsExactly(
            "{A1 1.0,A2 2.0,A3 3.0,A4 4.0,A5 5.0,A6 6.0}",
            "{A1 0.0,A2 2.0,A3 3.0,A4 4.0,A5 5.0,A6 6.0,E1 1.0,E2 2.0,E3 3.0,E4 4.0,E5 5.0,E6 6.0}",
            "{X 7.0,Y 8.0,Z 9.0,A 10.0,B 11.0,C 12.0}",
            "{X 7.0,Y 8.0,Z 9.0,A 10.0,B 11.0,C 12.0,S 2,T 34}",
            "{X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0,E1 1.0,E2 2.0,E3 3.0,E4 4.0,E5 5.0,E6 6.0,S 2,"
                + "T 34}");
  }

  @Test
  void rawTypesHoldTheValuesAndChangeTheStructure() throws Exception {
    assertThat(run("RawTypes"))
        .containsExactly(
            "2.5",
            "X 1.0;Y 2.0;Z 3.0;A 0.0;B 0.0;C 0.0;X",
            "{FRAME: X 1.00000, Y 7.00000, Z 2.00000, A 0.0, B 0.0, C 0.0}");
  }

  @Test
  void classesDerivedFromRequestAreSent() throws Exception {
    assertThat(run("Requests"))
        .containsExactly(
            "01",
            "value 42 18",
            "42",
            "Callback{variable=$OV_PRO, id=5, option=0, readTime=Nms, value=42}");
  }

  @Test
  void classesDerivedFromVariablesUseTheirFieldsAndConstructors() throws Exception {
    assertThat(run("OwnClasses"))
        .containsExactly(
            "1.5 6",
            "2",
            "{X=1.5, Y=2.0, Z=3.0, A=0.0, B=0.0, C=0.0}",
            "{A1 0.0,A2 -90.0}",
            "{M 2.5}",
            "null Text abc 7",
            "def6",
            "#T1");
  }

  @Test
  void idsStartWithOneAndTextsAreAsBefore() throws Exception {
    assertThat(run("Ids"))
        .containsExactly(
            "1 2",
            "KRLVariable{id=1, name=MYINT, value=4, readTime=Nms}",
            "Callback{variable=MYINT, id=1, option=0, readTime=Nms, value=4}",
            "Boolean");
  }

  @Test
  void theFactoriesAreFoundByTheirDescriptors() throws Exception {
    assertThat(run("Factories")).containsExactly("10.0 100.0", "-90.0");
  }

  @Test
  void aProgramOfVersion01Runs() throws Exception {
    assertThat(run("Version01"))
        .containsExactly(
            "Resources//Var_list.txt Resources//Robot_IP.txt",
            "truetrue",
            "8 100",
            "NOSUCH was not found",
            "8 #T1",
            "Callback{variable=$OV_PRO, id=9, option=1, readTime=Nms, value=17}",
            "Callback{variable=MYINT, id=3, option=0, readTime=Nms, value=42}80",
            "lost track",
            "true");
  }
}
