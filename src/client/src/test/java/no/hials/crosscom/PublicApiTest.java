package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;

/**
 * Guards what programs are compiled against: the list in {@code public-api.txt} may grow, and must
 * never lose a line.
 *
 * <p>After adding to the API, put the lines that the test names into the list.
 */
class PublicApiTest {
  @Test
  void nothingThatWasPublishedIsGone() throws Exception {
    assertThat(api()).containsAll(published());
  }

  @Test
  void everythingThatIsPublicIsOnTheList() throws Exception {
    assertThat(published()).containsAll(api());
  }

  private static List<String> published() throws IOException {
    try (InputStream in = PublicApiTest.class.getResourceAsStream("/public-api.txt")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    }
  }

  private static TreeSet<String> api() throws Exception {
    TreeSet<String> api = new TreeSet<>();
    for (Class<?> root : List.of(CrossComClient.class, KrlValue.class)) {
      for (Class<?> type : classes(root)) {
        if (isVisible(type) && !type.getPackageName().endsWith(".internal")) {
          describe(type, api);
        }
      }
    }
    return api;
  }

  private static List<Class<?>> classes(Class<?> root) throws IOException, URISyntaxException {
    Path location = Path.of(root.getProtectionDomain().getCodeSource().getLocation().toURI());
    if (Files.isRegularFile(location)) {
      try (var jar = java.nio.file.FileSystems.newFileSystem(location)) {
        return classes(jar.getPath("/"));
      }
    }
    return classes(location);
  }

  private static List<Class<?>> classes(Path directory) throws IOException {
    try (Stream<Path> files = Files.walk(directory)) {
      List<Class<?>> classes = new ArrayList<>();
      for (Path file : files.filter(f -> f.toString().endsWith(".class")).toList()) {
        String name = directory.relativize(file).toString();
        if (name.equals("module-info.class")) {
          continue;
        }
        classes.add(
            Class.forName(
                name.substring(0, name.length() - ".class".length()).replace('/', '.'),
                false,
                PublicApiTest.class.getClassLoader()));
      }
      return classes;
    } catch (ClassNotFoundException e) {
      throw new UncheckedIOException(new IOException(e));
    }
  }

  private static boolean isVisible(Class<?> type) {
    Class<?> outer = type.getEnclosingClass();
    return isVisible(type.getModifiers()) && (outer == null || isVisible(outer));
  }

  private static boolean isVisible(int modifiers) {
    return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
  }

  private static void describe(Class<?> type, TreeSet<String> api) {
    String name = type.getName();
    for (Class<?> above = type.getSuperclass(); above != null; above = above.getSuperclass()) {
      if (isVisible(above)) {
        api.add(name + " is a " + above.getName());
      }
    }
    for (Class<?> above : type.getInterfaces()) {
      api.add(name + " is a " + above.getName());
    }
    api.add(name + (Modifier.isFinal(type.getModifiers()) ? " is final" : " is open"));
    // inherited members count too: where they are declared is no matter of those who call them
    for (Class<?> from = type; isOurs(from); from = from.getSuperclass()) {
      for (Method method : from.getDeclaredMethods()) {
        if (isVisible(method.getModifiers()) && !method.isSynthetic()) {
          api.add(
              name
                  + ": "
                  + (Modifier.isStatic(method.getModifiers()) ? "static " : "")
                  + method.getReturnType().getTypeName()
                  + " "
                  + method.getName()
                  + parameters(method));
        }
      }
      for (Field field : from.getDeclaredFields()) {
        if (isVisible(field.getModifiers()) && !field.isSynthetic()) {
          api.add(name + ": " + field.getType().getTypeName() + " " + field.getName());
        }
      }
    }
    for (Constructor<?> constructor : type.getDeclaredConstructors()) {
      if (isVisible(constructor.getModifiers())) {
        api.add(name + ": new" + parameters(constructor));
      }
    }
  }

  private static boolean isOurs(Class<?> type) {
    return type != null && type.getPackageName().startsWith("no.hials.");
  }

  private static String parameters(Executable executable) {
    return Arrays.stream(executable.getParameterTypes())
            .map(Class::getTypeName)
            .collect(Collectors.joining(", ", "(", ")"))
        + Arrays.stream(executable.getExceptionTypes())
            .map(Class::getTypeName)
            .sorted()
            .collect(Collectors.joining(", ", " throws ", ""))
            .replaceFirst(" throws $", "");
  }
}
