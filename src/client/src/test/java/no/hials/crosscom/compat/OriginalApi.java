package no.hials.crosscom.compat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.protocol.Codec;
import org.slf4j.Logger;

/**
 * The signatures of the original, from {@code api-0.2.2.txt}: compiled into classes without
 * behaviour, which stand for its jar when old programs are compiled.
 */
public final class OriginalApi {
  private final Map<String, List<String>> types = new LinkedHashMap<>();
  private final Map<String, String> headers = new LinkedHashMap<>();

  /** Reads the list of signatures. */
  public OriginalApi() throws IOException {
    String type = "";
    for (String line : resource("/api-0.2.2.txt").lines().toList()) {
      if (line.endsWith("{")) {
        type = line.replaceFirst(".*?(?:class|interface) ([\\w.]+).*", "$1");
        headers.put(type, line);
        types.put(type, new ArrayList<>());
      } else if (line.startsWith("  ")) {
        types.get(type).add(line.strip().replaceFirst(";$", ""));
      }
    }
  }

  /** Returns the names of the classes. */
  public Set<String> types() {
    return types.keySet();
  }

  /** Returns the number of signatures of a class. */
  public int size(String type) {
    return types.get(type).size();
  }

  /** Compiles classes whose methods throw, for Java 8. */
  public void compileTo(Path folder) {
    List<JavaFileObject> sources = new ArrayList<>();
    types.keySet().forEach(type -> sources.add(source(type, stub(type))));
    assertThat(compile(folder, sources, "--release", "8")).as("errors in the stubs").isEmpty();
  }

  private String stub(String type) {
    int dot = type.lastIndexOf('.');
    StringBuilder text = new StringBuilder("package " + type.substring(0, dot) + ";\n");
    text.append(headers.get(type).replace(type, type.substring(dot + 1))).append('\n');
    Set<String> seen = new HashSet<>();
    for (String member : types.get(type)) {
      int open = member.indexOf('(');
      if (open < 0) {
        text.append(member).append(" = ").append(constant(member)).append(";\n");
        continue;
      }
      String before = member.substring(0, open);
      List<String> parameters = parameters(member);
      String name = before.substring(before.lastIndexOf(' ') + 1);
      if (!seen.add(name + parameters) || parameters.equals(List.of("java.lang.Object"))) {
        continue; // a bridge method, which the compiler adds again
      }
      String head = name.equals(type) ? before.replace(type, type.substring(dot + 1)) : before;
      text.append(head).append('(');
      for (int i = 0; i < parameters.size(); i++) {
        text.append(i == 0 ? "" : ", ").append(parameters.get(i)).append(" p").append(i);
      }
      text.append(member.substring(member.indexOf(')')));
      if (before.contains("abstract ")) {
        text.append(";\n");
      } else {
        String first = name.equals(type) ? superCall(type) : "";
        text.append(" { ").append(first);
        text.append("if (true) throw new UnsupportedOperationException(); ");
        text.append(returns(before, name, type)).append("}\n");
      }
    }
    return text.append("}\n").toString();
  }

  private static String returns(String before, String name, String type) {
    return name.equals(type) || before.contains(" void ") ? "" : "throw new AssertionError(); ";
  }

  /** Returns a value that the compiler does not copy into the programs. */
  private static String constant(String field) {
    if (field.contains(" char ")) {
      return "Character.valueOf('x')";
    }
    return field.contains("java.lang.String ") ? "String.valueOf(1)" : "null";
  }

  private String superCall(String type) {
    String header = headers.get(type);
    if (!header.contains(" extends no.hials")) {
      return "";
    }
    String above = header.replaceFirst(".* extends ([\\w.]+).*", "$1");
    String constructor =
        types.get(above).stream().filter(m -> m.contains(above + "(")).findFirst().orElseThrow();
    return parameters(constructor).stream()
        .map(p -> p.equals("int") || p.equals("long") ? "0" : "(" + p + ") null")
        .collect(Collectors.joining(", ", "super(", "); "));
  }

  private static List<String> parameters(String member) {
    String all = member.substring(member.indexOf('(') + 1, member.indexOf(')'));
    return all.isEmpty() ? List.of() : Arrays.asList(all.split(", (?![^<]*>)"));
  }

  /** Returns a program of the test resources. */
  static JavaFileObject program(String name) throws IOException {
    return source("program." + name, resource("/original/" + name + ".java"));
  }

  private static JavaFileObject source(String type, String text) {
    URI uri = URI.create("string:///" + type.replace('.', '/') + ".java");
    return new SimpleJavaFileObject(uri, JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text;
      }
    };
  }

  /**
   * Compiles sources.
   *
   * @return the errors; empty if there are none
   */
  static String compile(Path folder, List<JavaFileObject> sources, String... options) {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    List<String> all =
        Stream.concat(
                Stream.of("-proc:none", "-nowarn", "-Xlint:-options", "-d", folder.toString()),
                Arrays.stream(options))
            .toList();
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
    boolean compiled = compiler.getTask(messages, null, null, all, null, sources).call();
    return compiled ? "" : messages.toString();
  }

  /** Returns the places of this client's classes and of the classes it needs. */
  static List<Path> client() throws URISyntaxException {
    List<Path> places = new ArrayList<>();
    for (Class<?> type : List.of(CrossComClient.class, Codec.class, Logger.class)) {
      places.add(Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()));
    }
    return places;
  }

  private static String resource(String name) throws IOException {
    try (InputStream in = OriginalApi.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
