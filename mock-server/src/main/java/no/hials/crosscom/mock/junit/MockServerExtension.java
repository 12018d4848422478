package no.hials.crosscom.mock.junit;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.nio.file.Path;
import java.util.function.Predicate;
import no.hials.crosscom.mock.FaultRule;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.platform.commons.support.AnnotationSupport;
import org.junit.platform.commons.support.ModifierSupport;

/**
 * Implements {@link KukaController}. Stateless: the store of the class or test holds each server
 * and closes it.
 */
final class MockServerExtension
    implements BeforeAllCallback, BeforeEachCallback, ParameterResolver {
  private static final ExtensionContext.Namespace SERVERS =
      ExtensionContext.Namespace.create(MockServerExtension.class);

  private static final String CLASSPATH = "classpath:";

  @Override
  public ExtensionContextScope getTestInstantiationExtensionContextScope(
      ExtensionContext rootContext) {
    // so that the server of a constructor's parameter lives as long as the instance
    return ExtensionContextScope.TEST_METHOD;
  }

  // fields

  @Override
  public void beforeAll(ExtensionContext context) throws Exception {
    setFields(context, context.getRequiredTestClass(), null, ModifierSupport::isStatic);
  }

  @Override
  public void beforeEach(ExtensionContext context) throws Exception {
    // a nested test also has enclosing instances
    for (Object instance : context.getRequiredTestInstances().getAllInstances()) {
      setFields(context, instance.getClass(), instance, ModifierSupport::isNotStatic);
    }
  }

  private static void setFields(
      ExtensionContext context, Class<?> type, @Nullable Object instance, Predicate<Field> which)
      throws ReflectiveOperationException, IOException {
    for (Field field : AnnotationSupport.findAnnotatedFields(type, KukaController.class, which)) {
      String place = type.getSimpleName() + "." + field.getName();
      checkType(field.getType(), place);
      if (Modifier.isFinal(field.getModifiers())) {
        throw new ExtensionConfigurationException(place + " must not be final");
      }
      KukaController settings =
          AnnotationSupport.findAnnotation(field, KukaController.class).orElseThrow();
      field.setAccessible(true);
      field.set(instance, start(context, settings, place));
    }
  }

  private static void checkType(Class<?> type, String place) {
    if (type != MockServer.class) {
      throw new ExtensionConfigurationException(
          "@KukaController needs the type MockServer, but " + place + " is a " + type.getName());
    }
  }

  // parameters

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    return parameter.isAnnotated(KukaController.class);
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    Parameter declared = parameter.getParameter();
    String place = declared.getDeclaringExecutable().getName() + "(" + declared.getName() + ")";
    checkType(declared.getType(), place);
    KukaController settings = parameter.findAnnotation(KukaController.class).orElseThrow();
    try {
      return start(context, settings, place);
    } catch (IOException e) {
      throw new ExtensionConfigurationException(place + ": " + e.getMessage(), e);
    }
  }

  // servers

  private static MockServer start(ExtensionContext context, KukaController settings, String place)
      throws IOException {
    try {
      MockServer server = MockServer.start(cfg -> configure(cfg, settings));
      // first, so that it is closed if a line below fails
      context.getStore(SERVERS).put(new Object(), server);
      prepare(context, server, settings);
      return server;
    } catch (IllegalArgumentException e) {
      throw new ExtensionConfigurationException(place + ": " + e.getMessage(), e);
    }
  }

  private static void configure(MockServerConfig.Builder cfg, KukaController settings) {
    if (settings.asOnTheController()) {
      cfg.asOnTheController(settings.seed());
    }
    if (!settings.latency().isEmpty()) {
      cfg.latency(Latency.parse(settings.latency(), settings.seed()));
    }
    if (settings.maxClients() != Integer.MIN_VALUE) {
      cfg.maxClients(settings.maxClients());
    }
    if (!settings.archive().isEmpty()) {
      cfg.archive(Path.of(settings.archive()));
    }
    cfg.server(settings.server()).clock(SimulationClock.parse(settings.clock()));
  }

  /** Sets the faults, loads the files and starts the programs. */
  private static void prepare(ExtensionContext context, MockServer server, KukaController settings)
      throws IOException {
    for (String rule : settings.faults()) {
      server.faults(FaultRule.parse(rule, settings.seed()));
    }
    try {
      if (isController(settings)) {
        prepare(context, server.controller(), settings);
      } else {
        for (String file : settings.dataLists()) {
          load(context, file, server.variables()::load, server.variables()::load);
        }
      }
    } catch (KrlFileException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** Returns whether the attributes need the controller, not only variables. */
  private static boolean isController(KukaController settings) {
    return settings.programs().length > 0
        || !settings.archive().isEmpty()
        || !settings.start().isEmpty()
        || !settings.submit().isEmpty()
        || settings.mode() != OperatingMode.T1;
  }

  private static void prepare(
      ExtensionContext context, Controller controller, KukaController settings)
      throws IOException, KrlFileException {
    for (String file : settings.dataLists()) {
      load(context, file, controller::load, controller::load);
    }
    for (String file : settings.programs()) {
      load(context, file, controller::load, controller::load);
    }
    controller.setMode(settings.mode());
    if (!settings.submit().isEmpty()) {
      controller.submit().select(settings.submit());
      controller.submit().start();
    }
    if (!settings.start().isEmpty()) {
      controller.robot().select(settings.start());
      controller.runProgram();
    }
  }

  @FunctionalInterface
  private interface FileLoader {
    void load(Path file) throws IOException, KrlFileException;
  }

  @FunctionalInterface
  private interface TextLoader {
    void load(String name, String text) throws KrlFileException;
  }

  private static void load(
      ExtensionContext context, String file, FileLoader files, TextLoader texts)
      throws IOException, KrlFileException {
    if (!file.startsWith(CLASSPATH)) {
      files.load(Path.of(file));
      return;
    }
    String name = file.substring(CLASSPATH.length());
    try (InputStream in = context.getRequiredTestClass().getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalArgumentException("resource not found: " + name);
      }
      texts.load(name, KrlEncoding.decode(in.readAllBytes()));
    }
  }
}
