package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.c3.DiscoveryConfig;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.compat.OriginalApi;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Guards what programs for JOpenShowVar 0.2.2 and 0.1 were compiled against: each signature of
 * {@code api-0.2.2.txt} is there, with the same descriptor, and can be used in the same ways. The
 * rest of the API may change before 1.0 (docs/reference/api.md#what-may-change).
 */
class PublicApiTest {
  @TempDir private static Path folder;
  private static OriginalApi original;

  @BeforeAll
  static void compile() throws Exception {
    original = new OriginalApi();
    original.compileTo(folder);
  }

  static Stream<String> types() throws Exception {
    return new OriginalApi().types().stream();
  }

  @Test
  void theListHasTheClassesOfBothVersions() {
    assertThat(original.types()).hasSize(26);
  }

  @ParameterizedTest
  @ValueSource(
      classes = {
        ClientConfig.class,
        WatchConfig.class,
        TransferConfig.class,
        DiscoveryConfig.class
      })
  void aConfigurationIsCreatedByItsBuilderOnlySoThatItCanHaveNewOptions(Class<?> type) {
    assertThat(type).isFinal();
    assertThat(type.isRecord()).isFalse();
    assertThat(type.getConstructors()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("types")
  void everySignatureOfTheOriginalIsThere(String name) throws Exception {
    List<String> wrong = new ArrayList<>();
    int signatures = 0;
    try (URLClassLoader loader =
        new URLClassLoader(
            new URL[] {folder.toUri().toURL()}, ClassLoader.getPlatformClassLoader())) {
      Class<?> old = loader.loadClass(name);
      Class<?> now = Class.forName(name);
      compareTypes(old, now, wrong);
      for (Method method : old.getDeclaredMethods()) {
        signatures++;
        if (!method.getName().equals("POS_ACT")) {
          // was a KRLReal, which could not be read (docs/reference/compatibility.md)
          compare(method, find(method, now), wrong);
        }
      }
      for (Field field : old.getDeclaredFields()) {
        signatures++;
        compare(field, find(field, now), wrong);
      }
      for (Constructor<?> constructor : old.getDeclaredConstructors()) {
        signatures++;
        compare(constructor, find(constructor, now), wrong);
      }
    }

    assertThat(wrong).isEmpty();
    assertThat(signatures).as("no line of the list was left out").isEqualTo(original.size(name));
  }

  private static void compareTypes(Class<?> old, Class<?> now, List<String> wrong) {
    String name = old.getName();
    if (!Modifier.isPublic(now.getModifiers()) || now.isInterface() != old.isInterface()) {
      wrong.add(name + " is now " + now);
    }
    for (int restriction : new int[] {Modifier.FINAL, Modifier.ABSTRACT}) {
      if ((now.getModifiers() & ~old.getModifiers() & restriction) != 0) {
        wrong.add(name + " is now " + Modifier.toString(restriction));
      }
    }
    for (Class<?> above = old; above != null; above = above.getSuperclass()) {
      String superName = above.getName();
      // a Socket's streams would break the framing (docs/reference/compatibility.md)
      if (!superName.equals("java.net.Socket") && supertypes(now).noneMatch(superName::equals)) {
        wrong.add(name + " is no longer a " + superName);
      }
    }
    for (Class<?> type : old.getInterfaces()) {
      if (Arrays.stream(now.getInterfaces()).noneMatch(i -> i.getName().equals(type.getName()))) {
        wrong.add(name + " is no longer a " + type.getName());
      }
    }
    // a class of a program does not implement what it does not know
    for (Class<?> c = now; isOpen(now) && c != null; c = c.getSuperclass()) {
      for (Method method : c.getDeclaredMethods()) {
        if (Modifier.isAbstract(method.getModifiers()) && find(method, old) == null) {
          wrong.add(method + " is abstract and new");
        }
      }
    }
  }

  private static boolean isOpen(Class<?> type) {
    return !type.isInterface() && Modifier.isAbstract(type.getModifiers());
  }

  private static Stream<String> supertypes(Class<?> type) {
    Stream.Builder<String> names = Stream.builder();
    for (Class<?> c = type; c != null; c = c.getSuperclass()) {
      names.add(c.getName());
    }
    return names.build();
  }

  /** Finds a member as the virtual machine does: by descriptor, in the class and those above. */
  private static <M extends Member> M find(M old, Class<?> now) {
    for (Class<?> c = now; c != null; c = c.getSuperclass()) {
      Member[] members =
          old instanceof Method
              ? c.getDeclaredMethods()
              : old instanceof Field ? c.getDeclaredFields() : c.getDeclaredConstructors();
      for (Member member : members) {
        if (descriptor(member).equals(descriptor(old))) {
          @SuppressWarnings("unchecked") // the same kind of member
          M found = (M) member;
          return found;
        }
      }
      if (old instanceof Constructor) {
        break;
      }
    }
    return null;
  }

  private static String descriptor(Member member) {
    if (member instanceof Field field) {
      return field.getType().getName() + " " + field.getName();
    }
    List<String> parameters =
        Arrays.stream(((Executable) member).getParameterTypes()).map(Class::getName).toList();
    return member instanceof Method method
        ? method.getReturnType().getName() + " " + method.getName() + parameters
        : member.getName() + parameters;
  }

  private static void compare(Member old, Member now, List<String> wrong) {
    if (now == null) {
      wrong.add(old + " is gone");
      return;
    }
    int before = old.getModifiers();
    int after = now.getModifiers();
    if (Modifier.isStatic(before) != Modifier.isStatic(after)
        || (Modifier.isPublic(before) && !Modifier.isPublic(after))
        || Modifier.isPrivate(after)
        || (!Modifier.isPublic(after) && !Modifier.isProtected(after))
        || (after & ~before & (Modifier.FINAL | Modifier.ABSTRACT)) != 0) {
      wrong.add(old + " is now " + now);
    }
    if (now instanceof Executable executable) {
      List<String> declared =
          Arrays.stream(((Executable) old).getExceptionTypes()).map(Class::getName).toList();
      for (Class<?> exception : executable.getExceptionTypes()) {
        if (!declared.contains(exception.getName())) {
          wrong.add(old + " now throws " + exception.getName());
        }
      }
    }
  }
}
