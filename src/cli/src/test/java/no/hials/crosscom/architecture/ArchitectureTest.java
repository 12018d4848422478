package no.hials.crosscom.architecture;

import static com.tngtech.archunit.lang.SimpleConditionEvent.violated;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The rules of docs/CONTRIBUTING.md for modules, packages and names. */
class ArchitectureTest {
  private static final String ROOT = "no.hials.crosscom";
  private static final int MAX_FILES = 35;

  /** A type of the list of signatures of JOpenShowVar 0.2.2 and 0.1. */
  private static final Pattern ORIGINAL_TYPE =
      Pattern.compile("^public .*?(?:class|interface) ([\\w.]+)");

  private static final int MAX_LINES = 500;

  /** A row of docs/decisions/09-modules.md. */
  private static final Pattern MODULE_ROW = Pattern.compile("(?m)^ *\\| `(\\w+)` \\| ([^|]*) \\|");

  private static final Pattern MODULE_NAME = Pattern.compile("`(\\w+)`");

  /** A package that a module exports to all others. */
  private static final Pattern EXPORT = Pattern.compile("exports ([\\w.]+);");

  /**
   * The client's root: 11 exceptions, the names of 0.2.2, which cannot move, and the exchanges,
   * which are package-private. The programs of the simulator: the compiler and the code that it
   * creates. The examples: one class for each task.
   */
  private static final Map<String, Integer> LARGE_PACKAGES =
      Map.of(ROOT, 45, ROOT + ".simulator.internal.program", 38, ROOT + ".examples", 40);

  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages(ROOT);

  /** Request and Response are sealed, so they name the families in the packages below them. */
  private static final Set<String> MESSAGES =
      Set.of(
          ROOT + ".protocol.file",
          ROOT + ".protocol.program",
          ROOT + ".protocol.server",
          ROOT + ".protocol.variable");

  /** The client's packages are those next to the other modules' packages. */
  private static final Set<String> CLIENT =
      Set.of("", "KRL", "c3", "internal", "networking", "variables");

  /** The packages of the simulator that are exported to the mock server. */
  private static final Set<String> INTERNALS_FOR_MOCK =
      Set.of(ROOT + ".simulator.internal", ROOT + ".simulator.internal.files");

  private static String module(JavaClass type) {
    String name = type.getPackageName();
    String first = name.equals(ROOT) ? "" : name.substring(ROOT.length() + 1).split("\\.", 2)[0];
    return CLIENT.contains(first) ? "client" : first;
  }

  @Test
  void aModuleUsesOnlyTheModulesOfTheTable() throws IOException {
    Map<String, Set<String>> used = usedModules();

    assertThat(uses())
        .filteredOn(
            use ->
                !used.getOrDefault(module(use.getOriginClass()), Set.of())
                    .contains(module(target(use))))
        .isEmpty();
  }

  @Test
  void theParserAndTheKinematicsUseOnlyTheValuesOfTheProtocol() {
    assertThat(uses())
        .filteredOn(use -> Set.of("lang", "kinematics").contains(module(use.getOriginClass())))
        .extracting(use -> target(use).getPackageName())
        .containsOnly(ROOT + ".protocol.value");
  }

  /** Returns the table of the decision about modules: which modules each of them uses. */
  private static Map<String, Set<String>> usedModules() throws IOException {
    String page = Files.readString(Path.of("../../docs/decisions/09-modules.md"));
    return MODULE_ROW
        .matcher(page)
        .results()
        .collect(
            Collectors.toMap(
                row -> row.group(1),
                row ->
                    MODULE_NAME
                        .matcher(row.group(2))
                        .results()
                        .map(name -> name.group(1))
                        .collect(Collectors.toSet())));
  }

  @Test
  void aModuleExportsItsPublicPackages() throws IOException {
    List<Path> descriptors =
        sources().stream().filter(file -> file.endsWith("module-info.java")).toList();
    assertThat(descriptors).hasSize(7);

    for (Path descriptor : descriptors) {
      assertThat(EXPORT.matcher(Files.readString(descriptor)).results())
          .extracting(export -> export.group(1))
          .as("%s", descriptor)
          .containsExactlyInAnyOrderElementsOf(packagesToExport(descriptor.getParent()));
    }
  }

  private static List<String> packagesToExport(Path root) throws IOException {
    return sources().stream()
        .filter(file -> file.startsWith(root) && file.endsWith("package-info.java"))
        .map(ArchitectureTest::packageName)
        .filter(name -> !isInternal(name))
        .toList();
  }

  @Test
  void theTableHasAllModules() throws IOException {
    assertThat(CLASSES)
        .extracting(ArchitectureTest::module)
        .containsOnly(usedModules().keySet().toArray(String[]::new));
  }

  @Test
  void aModuleUsesNoInternalPackageOfAnother() {
    assertThat(uses())
        .filteredOn(use -> isInternal(target(use)))
        .filteredOn(
            use ->
                !module(use.getOriginClass()).equals("mock")
                    || !INTERNALS_FOR_MOCK.contains(target(use).getPackageName()))
        .isEmpty();
  }

  /** Returns the dependencies of each module on the others. */
  private static List<Dependency> uses() {
    return CLASSES.stream()
        .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
        .filter(use -> target(use).getPackageName().startsWith(ROOT))
        .filter(use -> !module(use.getOriginClass()).equals(module(target(use))))
        .toList();
  }

  private static JavaClass target(Dependency use) {
    return use.getTargetClass().getBaseComponentType();
  }

  @Test
  void internalPackagesHaveNoCycles() {
    slices().assignedFrom(internalPackages()).should().beFreeOfCycles().check(CLASSES);
  }

  @Test
  void publicPackagesHaveNoCyclesExceptTheClientAndTheMessagesOfTheProtocol() {
    slices().assignedFrom(publicPackages()).should().beFreeOfCycles().check(CLASSES);
  }

  /** The public packages; the packages of the protocol's messages count as one. */
  private static SliceAssignment publicPackages() {
    return new SliceAssignment() {
      @Override
      public SliceIdentifier getIdentifierOf(JavaClass type) {
        String name = type.getPackageName();
        if (!name.startsWith(ROOT) || isInternal(type) || module(type).equals("client")) {
          return SliceIdentifier.ignore();
        }
        return SliceIdentifier.of(MESSAGES.contains(name) ? ROOT + ".protocol" : name);
      }

      @Override
      public String getDescription() {
        return "public packages";
      }
    };
  }

  @Test
  void packagesOfTheCommandLineHaveNoCycles() {
    slices().matching(ROOT + ".cli.(*)").should().beFreeOfCycles().check(CLASSES);
    noClasses()
        .that()
        .resideInAPackage(ROOT + ".cli.*")
        .should()
        .dependOnClassesThat()
        .resideInAPackage(ROOT + ".cli")
        .check(CLASSES);
  }

  private static SliceAssignment internalPackages() {
    return new SliceAssignment() {
      @Override
      public SliceIdentifier getIdentifierOf(JavaClass type) {
        return isInternal(type)
            ? SliceIdentifier.of(type.getPackageName())
            : SliceIdentifier.ignore();
      }

      @Override
      public String getDescription() {
        return "internal packages";
      }
    };
  }

  private static boolean isInternal(JavaClass type) {
    return isInternal(type.getPackageName());
  }

  private static boolean isInternal(String packageName) {
    return (packageName + ".").contains(".internal.");
  }

  @Test
  void aPackageHasFewFiles() throws IOException {
    Map<String, Long> files =
        sources().stream()
            .filter(file -> !file.endsWith("package-info.java"))
            .collect(groupingBy(ArchitectureTest::packageName, counting()));

    assertThat(files)
        .containsKeys(LARGE_PACKAGES.keySet().toArray(String[]::new))
        .allSatisfy(
            (name, count) ->
                assertThat(count)
                    .isLessThanOrEqualTo(LARGE_PACKAGES.getOrDefault(name, MAX_FILES)));
  }

  private static boolean isTopLevel(JavaClass type) {
    return type.isTopLevelClass() && !type.getSimpleName().equals("package-info");
  }

  private static String packageName(Path source) {
    String folder = source.getParent().toString().replace('\\', '/');
    return folder.replaceFirst(".*/src/main/java/?", "").replace('/', '.');
  }

  @Test
  void noTwoPublicTypesHaveOneName() throws IOException {
    Map<String, List<String>> names =
        Stream.concat(ourNames(), jdkNames())
            .collect(groupingBy(name -> name.substring(name.lastIndexOf('.') + 1)));

    assertThat(names.values())
        .filteredOn(same -> same.stream().anyMatch(name -> name.startsWith(ROOT)))
        .filteredOn(same -> same.size() > 1)
        .isEmpty();
  }

  private static Stream<String> ourNames() throws IOException {
    // names of JOpenShowVar 0.2.2 stay
    Set<String> original =
        Files.readAllLines(Path.of("../client/src/test/resources/api-0.2.2.txt")).stream()
            .flatMap(line -> ORIGINAL_TYPE.matcher(line).results())
            .map(type -> type.group(1))
            .collect(Collectors.toSet());
    return CLASSES.stream()
        .filter(type -> isTopLevel(type) || (type.isMemberClass() && !isBuilder(type)))
        .filter(ArchitectureTest::isPublic)
        .map(type -> type.getName().replace('$', '.'))
        .filter(name -> !original.contains(name));
  }

  /** Java's convention is one nested {@code Builder} for each class that needs one. */
  private static boolean isBuilder(JavaClass type) {
    return type.getSimpleName().equals("Builder");
  }

  /** Returns whether a type and the types around it are public. */
  private static boolean isPublic(JavaClass type) {
    return type.getModifiers().contains(JavaModifier.PUBLIC)
        && type.getEnclosingClass().map(ArchitectureTest::isPublic).orElse(true);
  }

  private static Stream<String> jdkNames() throws IOException {
    FileSystem jdk = FileSystems.getFileSystem(URI.create("jrt:/"));
    List<String> names = new ArrayList<>();
    for (String folder : List.of("java/nio/file", "java/time", "java/util")) {
      try (Stream<Path> files = Files.list(jdk.getPath("modules/java.base/" + folder))) {
        files
            .map(file -> file.getFileName().toString())
            .filter(file -> file.endsWith(".class") && file.indexOf('$') < 0)
            .map(file -> folder.replace('/', '.') + "." + file.replace(".class", ""))
            .filter(name -> isPublicInJdk(name))
            .forEach(names::add);
      }
    }
    return names.stream();
  }

  private static boolean isPublicInJdk(String name) {
    try {
      return java.lang.reflect.Modifier.isPublic(Class.forName(name).getModifiers());
    } catch (ClassNotFoundException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void thePublicApiNamesNoInternalType() {
    classes().should(nameNoInternalType()).check(CLASSES);
  }

  private static ArchCondition<JavaClass> nameNoInternalType() {
    return new ArchCondition<>("name no internal type in public or protected members") {
      @Override
      public void check(JavaClass type, ConditionEvents events) {
        if (!isApi(type)) {
          return;
        }
        Stream<JavaType> parents =
            Stream.concat(type.getSuperclass().stream(), type.getInterfaces().stream());
        Stream<JavaType> members =
            type.getMembers().stream().filter(member -> isVisible(member)).flatMap(m -> types(m));
        Stream.concat(parents, members)
            .flatMap(used -> used.getAllInvolvedRawTypes().stream())
            .map(JavaClass::getBaseComponentType)
            .filter(ArchitectureTest::isInternal)
            .forEach(used -> events.add(violated(type, type.getName() + " names " + used)));
      }
    };
  }

  private static boolean isApi(JavaClass type) {
    boolean outerIsApi = type.getEnclosingClass().map(ArchitectureTest::isApi).orElse(true);
    return outerIsApi && !isInternal(type) && isVisible(type.getModifiers());
  }

  private static boolean isVisible(JavaMember member) {
    return isVisible(member.getModifiers())
        && !member.getModifiers().contains(JavaModifier.SYNTHETIC);
  }

  private static boolean isVisible(Set<JavaModifier> modifiers) {
    return modifiers.contains(JavaModifier.PUBLIC) || modifiers.contains(JavaModifier.PROTECTED);
  }

  private static Stream<JavaType> types(JavaMember member) {
    if (member instanceof JavaField field) {
      return Stream.of(field.getType());
    }
    JavaCodeUnit code = (JavaCodeUnit) member;
    List<JavaType> types = new ArrayList<>(code.getParameterTypes());
    types.add(code.getReturnType());
    types.addAll(code.getThrowsClause().getTypes().stream().collect(Collectors.toList()));
    return types.stream();
  }

  @Test
  void everyTypeOfTheApiPageIsPublic() throws IOException {
    Set<String> names =
        CLASSES.stream()
            .filter(type -> type.getModifiers().contains(JavaModifier.PUBLIC))
            .filter(type -> !isInternal(type))
            .map(JavaClass::getSimpleName)
            .collect(Collectors.toSet());

    String page = Files.readString(Path.of("../../docs/reference/api.md"));

    assertThat(Pattern.compile("`@?([A-Z][A-Za-z0-9]+)`").matcher(page).results())
        .extracting(name -> name.group(1))
        .hasSizeGreaterThan(50)
        .allSatisfy(name -> assertThat(names).contains(name));
  }

  @Test
  void everyPackageIsCheckedForNulls() {
    assertThat(CLASSES)
        .extracting(JavaClass::getPackage)
        .filteredOn(it -> !it.isAnnotatedWith("org.jspecify.annotations.NullMarked"))
        .extracting(JavaPackage::getName)
        .as("packages without @NullMarked")
        .containsOnly(ROOT + ".lang.internal.grammar"); // generated
  }

  @Test
  void aLongFileSaysWhy() throws IOException {
    List<Path> longFiles = new ArrayList<>();
    for (Path file : sources()) {
      if (Files.readAllLines(file).size() > MAX_LINES) {
        longFiles.add(file);
      }
    }

    assertThat(longFiles)
        .isNotEmpty()
        .allSatisfy(file -> assertThat(file).content().containsPattern("The class is long[ ,:.]"));
  }

  private static List<Path> sources() throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> modules = Files.list(Path.of(".."))) {
      Stream<Path> others = Stream.of(Path.of("../../mock-server"), Path.of("../../examples"));
      for (Path module : Stream.concat(modules, others).toList()) {
        Path sources = module.resolve("src/main/java");
        if (Files.isDirectory(sources)) {
          try (Stream<Path> all = Files.walk(sources)) {
            all.filter(file -> file.toString().endsWith(".java")).forEach(files::add);
          }
        }
      }
    }
    return files;
  }
}
