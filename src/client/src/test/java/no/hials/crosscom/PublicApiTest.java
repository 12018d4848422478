package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * Guards what programs for JOpenShowVar 0.2.2 were compiled against: the list in {@code
 * api-0.2.2.txt} never loses a line. The rest of the API may change before 1.0
 * (docs/reference/api.md#what-may-change).
 */
class PublicApiTest {
  @Test
  void nothingOfTheOriginalIsGone() throws Exception {
    List<String> original = original();
    Set<String> api = new HashSet<>();
    for (String line : original) {
      String name = line.substring(0, line.indexOf(line.contains(": ") ? ": " : " is "));
      describe(Class.forName(name), api);
    }

    assertThat(original).isNotEmpty();
    assertThat(api).containsAll(original);
  }

  private static List<String> original() throws IOException {
    try (InputStream in = PublicApiTest.class.getResourceAsStream("/api-0.2.2.txt")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    }
  }

  private static boolean isVisible(int modifiers) {
    return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
  }

  private static void describe(Class<?> type, Set<String> api) {
    String name = type.getName();
    for (Class<?> above = type.getSuperclass(); above != null; above = above.getSuperclass()) {
      if (isVisible(above.getModifiers())) {
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
