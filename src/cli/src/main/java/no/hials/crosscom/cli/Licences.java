package no.hials.crosscom.cli;

import java.io.IOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Writes the list of the libraries in the jar, and the texts of their licences: those in the
 * libraries themselves, and those that {@code libraries.tsv} names. The build runs it, and fails if
 * a library has no line or no text; the jar is without it.
 */
final class Licences {
  private static final String OURS = "jopenshowvar";
  private static final Pattern TEXT = Pattern.compile("META-INF/[^/]*(LICENSE|NOTICE)[^/]*");

  private final Path texts;
  private final Path output;

  /** The written texts, without blanks, and their file names. */
  private final Map<String, String> written = new LinkedHashMap<>();

  private Licences(Path texts, Path output) {
    this.texts = texts;
    this.output = output;
  }

  /** A line of {@code libraries.tsv}. */
  private record Line(String artifact, String licence, String home, List<String> files) {
    static Line of(String line) {
      String[] fields = line.split("\t", -1);
      String files = fields[3];
      return new Line(
          fields[0],
          fields[1],
          fields[2],
          files.equals("-") ? List.of() : List.of(files.split(" ")));
    }

    boolean matches(String name) {
      return artifact.endsWith("*")
          ? name.startsWith(artifact.substring(0, artifact.length() - 1))
          : name.equals(artifact);
    }
  }

  /**
   * Runs it on its own class path.
   *
   * @param args the folder of the texts, and the folder that becomes {@code META-INF}
   */
  public static void main(String... args) throws IOException, URISyntaxException {
    List<Path> jars = new ArrayList<>();
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    for (URL url : ((URLClassLoader) loader).getURLs()) {
      jars.add(Path.of(url.toURI()));
    }
    write(jars, Path.of(args[0]), Path.of(args[1]));
  }

  /**
   * Writes {@code NOTICE} and the folder {@code licenses}.
   *
   * @param jars the class path, in the layout of a Maven repository: ARTIFACT/VERSION/FILE.jar;
   *     folders and our own jars are skipped
   * @param texts the folder with {@code libraries.tsv} and texts
   * @param output the folder to write to
   * @throws IllegalStateException if a library has no line or no text, or a line no library
   */
  static void write(List<Path> jars, Path texts, Path output) throws IOException {
    Map<String, Path> libraries = new TreeMap<>();
    for (Path jar : jars) {
      String file = String.valueOf(jar.getFileName());
      if (file.endsWith(".jar") && !file.startsWith(OURS)) {
        libraries.put(jar.getName(jar.getNameCount() - 3).toString(), jar);
      }
    }
    new Licences(texts, output).write(libraries);
  }

  private void write(Map<String, Path> libraries) throws IOException {
    Path table = texts.resolve("libraries.tsv");
    List<Line> lines = Files.readAllLines(table).stream().map(Line::of).toList();
    for (Line line : lines) {
      if (libraries.keySet().stream().noneMatch(line::matches)) {
        throw new IllegalStateException(table + ": " + line.artifact + " is not in the jar");
      }
    }
    Files.createDirectories(output.resolve("licenses"));
    StringBuilder notice =
        new StringBuilder(
            "JOpenShowVar contains these libraries. The texts of their licences are in META-INF/licenses.\n");
    for (Map.Entry<String, Path> library : libraries.entrySet()) {
      String name = library.getKey();
      Line line =
          lines.stream()
              .filter(it -> it.matches(name))
              .findFirst()
              .orElseThrow(() -> new IllegalStateException(table + " has no line for " + name));
      List<String> files = textsOf(name, library.getValue(), line);
      if (files.isEmpty()) {
        throw new IllegalStateException(
            name + " has no text of its licence, neither in its jar nor in " + table);
      }
      notice
          .append(
              "\n" + name + " " + library.getValue().getName(library.getValue().getNameCount() - 2))
          .append("\n  licence: " + line.licence)
          .append("\n  home: " + line.home)
          .append("\n  texts: " + String.join(", ", files) + "\n");
    }
    Files.writeString(output.resolve("NOTICE"), notice);
  }

  /** Writes the texts of a library; returns the names of the files. */
  private List<String> textsOf(String name, Path jar, Line line) throws IOException {
    List<String> files = new ArrayList<>();
    for (String file : line.files) {
      files.add(write(file, Files.readString(texts.resolve(file))));
    }
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : (Iterable<ZipEntry>) zip.stream().map(ZipEntry.class::cast)::iterator) {
        if (TEXT.matcher(entry.getName()).matches()) {
          String text =
              new String(zip.getInputStream(entry).readAllBytes(), StandardCharsets.UTF_8);
          String file = entry.getName().substring(entry.getName().indexOf('/') + 1);
          files.add(write(name + "-" + file.replaceFirst("\\.(txt|md)$", "") + ".txt", text));
        }
      }
    }
    return files.stream().distinct().toList();
  }

  /** Writes a text, unless it is there with other line breaks; returns the name of its file. */
  private String write(String file, String text) throws IOException {
    String known = written.putIfAbsent(text.replaceAll("\\s+", ""), file);
    if (known != null) {
      return known;
    }
    Files.writeString(output.resolve("licenses").resolve(file), text);
    return file;
  }
}
