package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Jar;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Runs the program as it is in the distribution, by its start script. */
@Timeout(120)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no sh")
class DistributionIT {
  private static final String JAVA_HOME = System.getProperty("java.home");

  @TempDir private static Path unpacked;
  @TempDir private Path dir;

  private static Path program;

  @BeforeAll
  static void unpack() throws Exception {
    Path archive;
    try (Stream<Path> files = Files.list(Path.of("target"))) {
      archive = files.filter(file -> file.toString().endsWith(".tar.gz")).findAny().orElseThrow();
    }
    Process tar =
        new ProcessBuilder("tar", "xzf", archive.toString(), "-C", unpacked.toString()).start();
    assertThat(tar.waitFor()).isZero();
    try (Stream<Path> folders = Files.list(unpacked)) {
      program = folders.findAny().orElseThrow().resolve("bin").resolve("jopenshowvar");
    }
  }

  private ProcessBuilder command(Path script, String... args) {
    ProcessBuilder builder = new ProcessBuilder(script.toString());
    builder.command().addAll(List.of(args));
    Map<String, String> environment = builder.environment();
    environment.keySet().removeIf(name -> name.startsWith("JOPENSHOWVAR_"));
    environment.keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
    environment.put("JAVA_HOME", JAVA_HOME);
    // a file, in which no folder can be made: no run leaves an archive, but those that ask for it
    environment.put("XDG_CACHE_HOME", program.toString());
    return builder;
  }

  private Cli.Result run(ProcessBuilder builder) throws Exception {
    return Jar.run(builder, dir);
  }

  private static void isTheVersion(Cli.Result result) {
    assertThat(result.err()).isEmpty();
    assertThat(result.lines()).singleElement().asString().startsWith("jopenshowvar ");
    assertThat(result.code()).isZero();
  }

  @Test
  void holdsWhatTheReadmeSays() {
    assertThat(program.resolve("../..").normalize())
        .isDirectoryRecursivelyContaining("glob:**/README.md")
        .isDirectoryRecursivelyContaining("glob:**/LICENSE")
        .isDirectoryRecursivelyContaining("glob:**/bin/jopenshowvar.bat")
        .isDirectoryRecursivelyContaining("glob:**/krl/actuator.src")
        .isDirectoryRecursivelyContaining("glob:**/completion/jopenshowvar.bash")
        .isDirectoryRecursivelyContaining("glob:**/completion/jopenshowvar.fish")
        .isDirectoryRecursivelyContaining("glob:**/man/man1/jopenshowvar-read.1");
  }

  @Test
  void readsAVariableWithDollarAndBrackets() throws Exception {
    try (MockServer server = MockServer.start()) {
      Cli.Result result = run(command(program, Cli.argsOn(server, "read", "$MODEL_NAME[]")));

      assertThat(result.err()).isEmpty();
      assertThat(result.lines()).containsExactly("$MODEL_NAME[] = \"#KR6R900 C4SR FLR 230\"");
    }
  }

  @Test
  void passesTheExitCodeOn() throws Exception {
    assertThat(run(command(program, "read")).code()).isEqualTo(2);
  }

  @Test
  void runsFromAnyFolderThroughLinksAndWithBlanksInThePath() throws Exception {
    Path blanks = Files.createDirectory(unpacked.resolve("a folder with 'blanks'"));
    Path home = program.getParent().getParent();
    Path inside = Files.createSymbolicLink(blanks.resolve("in stalled"), home);
    Files.createSymbolicLink(blanks.resolve("link"), inside.resolve("bin/jopenshowvar"));
    Path relative = Files.createSymbolicLink(blanks.resolve("other"), Path.of("link"));

    isTheVersion(run(command(relative, "--version").directory(blanks.toFile())));
    isTheVersion(run(command(Path.of("./other"), "--version").directory(blanks.toFile())));
  }

  @Test
  void runsInAFolderWithOtherLettersWithoutALocale() throws Exception {
    // the shell creates the name, as this process may have no locale either
    String home = program.getParent().getParent().toString();
    ProcessBuilder builder =
        command(
            Path.of("sh"),
            "-c",
            "o=$(printf '\\303\\266'); cp -r \"$1\" \"$2/$o\" && \"$2/$o/bin/jopenshowvar\" --version",
            "sh",
            home,
            dir.toString());
    builder.environment().keySet().removeAll(List.of("LANG", "LC_CTYPE"));
    builder.environment().put("LC_ALL", "C");

    isTheVersion(run(builder));
  }

  @Test
  void takesTheCollectorOfGarbageThatTheUserWants() throws Exception {
    ProcessBuilder builder = command(program, "--version");
    builder.environment().put("JDK_JAVA_OPTIONS", "-Dx=y -XX:+UseParallelGC");

    Cli.Result result = run(builder);

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.out()).isNotBlank();
  }

  @Test
  void simulatesWithTheFirstCompilerUnlessAtAnotherSpeed() throws Exception {
    Path java = Files.createDirectories(dir.resolve("java/bin")).resolve("java");
    Files.writeString(java, "#!/bin/sh\necho \"$@\"\n");
    Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwx------"));
    Files.writeString(dir.resolve("java/release"), "JAVA_VERSION=\"17.0.1\"\n");
    ProcessBuilder builder = command(program, "mock", "--port", "0");
    builder.environment().put("JAVA_HOME", dir.resolve("java").toString());

    assertThat(run(builder).out()).startsWith("-XX:TieredStopAtLevel=1 -jar");
    builder.command().addAll(List.of("--speed", "max"));
    assertThat(run(builder).out()).startsWith("-jar");
  }

  @Test
  void isFoundInPathAndFindsJavaThere() throws Exception {
    ProcessBuilder builder = command(Path.of("sh"), "-c", "jopenshowvar --version");
    builder.environment().remove("JAVA_HOME");
    builder
        .environment()
        .put("PATH", program.getParent() + ":" + JAVA_HOME + "/bin:" + System.getenv("PATH"));

    isTheVersion(run(builder));
  }

  @Test
  void saysThatThereIsNoJava() throws Exception {
    Path tools = Files.createDirectory(dir.resolve("tools"));
    ProcessBuilder builder = command(program, "--version");
    builder.environment().remove("JAVA_HOME");
    builder.environment().put("PATH", tools.toString());

    run(builder)
        .failsInLines(127)
        .containsExactly(
            "jopenshowvar: needs Java 17 or later; there is no java in PATH, and JAVA_HOME is not"
                + " set");
  }

  @Test
  void saysThatJavaHomeIsWrong() throws Exception {
    ProcessBuilder builder = command(program, "--version");
    builder.environment().put("JAVA_HOME", dir.toString());

    run(builder)
        .fails(127)
        .isEqualTo("jopenshowvar: JAVA_HOME is " + dir + ", where there is no bin/java\n");
  }

  @Test
  void saysThatJavaIsTooOldWhetherOrNotItsFileSaysSo() throws Exception {
    Path java = Files.createDirectories(dir.resolve("bin")).resolve("java");
    Files.writeString(java, "#!/bin/sh\necho 'openjdk version \"1.8.0_392\"' >&2\n");
    assumeThat(java.toFile().setExecutable(true)).isTrue();
    ProcessBuilder builder = command(program, "--version");
    builder.environment().put("JAVA_HOME", dir.toString());

    Cli.Result asked = run(builder);
    Files.writeString(dir.resolve("release"), "JAVA_VERSION=\"11.0.2\"\n");
    Cli.Result read = run(builder);

    asked.fails(127).isEqualTo("jopenshowvar: needs Java 17 or later; " + java + " is 1.8.0_392\n");
    assertThat(read.err())
        .isEqualTo("jopenshowvar: needs Java 17 or later; " + java + " is 11.0.2\n");
  }

  @Test
  @Timeout(600) // the archive is made by a process that leaves others all they want of the computer
  @EnabledOnOs(OS.LINUX)
  void archivesItsClassesOnTheFirstRunAndDoesNotMindIfTheArchiveIsBad() throws Exception {
    Path cache = Files.createDirectories(dir.resolve("cache").resolve("jopenshowvar"));
    ProcessBuilder builder = command(program, "--version");
    builder.environment().put("XDG_CACHE_HOME", cache.getParent().toString());

    Path archive;
    try (WatchService watch = FileSystems.getDefault().newWatchService()) {
      cache.register(
          watch, StandardWatchEventKinds.ENTRY_CREATE, StandardWatchEventKinds.ENTRY_DELETE);
      isTheVersion(run(builder));
      archive = nextArchive(watch, cache);
    }

    assertThat(memoryOfMock(cache.getParent())).contains(archive.toString());
    isTheVersion(run(builder));
    assumeThat(archive.toFile().setWritable(true)).isTrue();
    byte[] whole = Files.readAllBytes(archive);
    Files.write(archive, List.of("this is not an archive"));
    isTheVersion(run(builder));
    Files.write(archive, Arrays.copyOf(whole, whole.length / 2));
    isTheVersion(run(builder));
  }

  /** Returns the files that a running program has in its memory. */
  private String memoryOfMock(Path cacheHome) throws Exception {
    ProcessBuilder builder = command(program, "mock", "--port", "0", "--no-discovery");
    builder.environment().put("XDG_CACHE_HOME", cacheHome.toString());
    Process mock = builder.redirectError(dir.resolve("err").toFile()).start();
    try (BufferedReader out = mock.inputReader()) {
      assertThat(out.readLine()).startsWith("listening on ");
      return Files.readString(Path.of("/proc", Long.toString(mock.pid()), "maps"));
    } finally {
      mock.destroyForcibly();
    }
  }

  /** Waits until the archive is there, and what was needed to make it is gone. */
  private static Path nextArchive(WatchService watch, Path cache)
      throws InterruptedException, IOException {
    while (true) {
      WatchKey key = watch.take();
      key.pollEvents();
      key.reset();
      try (Stream<Path> files = Files.list(cache)) {
        List<Path> all = files.toList();
        if (all.size() == 1 && all.get(0).toString().endsWith(".jsa")) {
          return all.get(0);
        }
      }
    }
  }
}
