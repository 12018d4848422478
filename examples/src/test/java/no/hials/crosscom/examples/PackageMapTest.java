package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Compares the map of packages in docs/CONTRIBUTING.md with the sources. */
class PackageMapTest {
  private static final Path SOURCES = Path.of("src", "main", "java");
  private static final Path ROOT_PACKAGE = Path.of("no", "hials", "crosscom");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| ?(.*?) ?\\| ?(.*?) ?\\|.*$");
  private static final Pattern NAME = Pattern.compile("`([^`]+)`");

  @Test
  void theMapHasEachPackageOnce() throws IOException {
    List<String> packages = packages();

    assertThat(packages).contains("crosscom", "mock.junit", "simulator.internal.core");
    assertThat(namesInTheMap()).containsExactlyInAnyOrderElementsOf(packages);
  }

  private static List<String> namesInTheMap() throws IOException {
    String page = Files.readString(MarkdownPages.ROOT.resolve("docs/CONTRIBUTING.md"));
    String map = page.split("\\| module \\| package \\| content \\|", 2)[1].split("\\R\\R", 2)[0];
    return ROW.matcher(map)
        .results()
        .flatMap(row -> NAME.matcher(row.group(2)).results())
        .map((MatchResult name) -> name.group(1))
        .toList();
  }

  private static List<String> packages() throws IOException {
    try (Stream<Path> modules = Files.list(MarkdownPages.ROOT.resolve("src"))) {
      return Stream.concat(modules, Stream.of(MarkdownPages.ROOT.resolve("mock-server")))
          .map(module -> module.resolve(SOURCES).resolve(ROOT_PACKAGE))
          .filter(Files::isDirectory)
          .flatMap(PackageMapTest::packagesIn)
          .toList();
    }
  }

  private static Stream<String> packagesIn(Path sources) {
    try (Stream<Path> files = Files.walk(sources)) {
      return files.filter(file -> file.endsWith("package-info.java")).toList().stream()
          .map(file -> sources.relativize(file.getParent()).toString())
          .map(name -> name.isEmpty() ? "crosscom" : name.replaceAll("[/\\\\]", "."));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
