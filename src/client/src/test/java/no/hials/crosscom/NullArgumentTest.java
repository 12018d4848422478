package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLIntArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.Information;
import no.hials.crosscom.c3.KeyAction;
import no.hials.crosscom.c3.Motion;
import no.hials.crosscom.c3.Pendant;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class NullArgumentTest extends RobotTest {
  @SuppressWarnings("deprecation") // Request
  private static final Map<Class<?>, Object> VALUES =
      Map.ofEntries(
          Map.entry(String.class, "MYINT"),
          Map.entry(String[].class, new String[] {"X"}),
          Map.entry(KRLVariable.class, new KRLInt("MYINT")),
          Map.entry(KRLVariable[].class, new KRLVariable[] {new KRLInt("MYINT")}),
          Map.entry(KRLArray.class, new KRLIntArray("MYINTS")),
          Map.entry(KRLStruct.class, new KRLFrame("MYFRAME").setX(1)),
          Map.entry(KRLFrame.class, new KRLFrame("MYFRAME").setX(1)),
          Map.entry(KRLAxis.class, new KRLE6Axis("MYAXIS")),
          Map.entry(ArrayProgress.class, VariableExchange.NO_PROGRESS),
          Map.entry(WatchConfig.class, WatchConfig.create(List.of("MYINT"), cfg -> {})),
          Map.entry(Consumer.class, (Consumer<Object>) sample -> {}),
          Map.entry(Duration.class, Duration.ofDays(1)),
          Map.entry(List.class, List.of("MYINT")),
          Map.entry(Map.class, Map.of("MYINT", "1")),
          Map.entry(Set.class, Set.of()),
          Map.entry(CrossComFunction.class, (CrossComFunction<Integer>) c -> 1),
          Map.entry(CrossComAction.class, (CrossComAction) c -> {}),
          Map.entry(Interpreter.class, Interpreter.SUBMIT),
          Map.entry(KeyAction.class, KeyAction.start(Interpreter.SUBMIT)),
          Map.entry(ItemType.class, ItemType.TEXT),
          Map.entry(CopyFlag[].class, new CopyFlag[0]),
          Map.entry(Path.class, Path.of("nowhere")),
          Map.entry(Charset.class, StandardCharsets.ISO_8859_1),
          Map.entry(byte[].class, new byte[1]),
          Map.entry(InputStream.class, InputStream.nullInputStream()),
          Map.entry(TransferConfig.class, TransferConfig.DEFAULT),
          Map.entry(Request.class, new Request(1, "MYINT")),
          Map.entry(Class.class, Integer.class),
          Map.entry(Enum.class, Interpreter.SUBMIT),
          Map.entry(Record.class, new Frame(1, 2, 3, 4, 5, 6)),
          Map.entry(Handle[].class, new Handle<?>[0]),
          Map.entry(int[].class, new int[] {1}),
          Map.entry(double[].class, new double[] {1}),
          Map.entry(boolean[].class, new boolean[] {true}),
          Map.entry(double.class, 1.0),
          Map.entry(boolean.class, false),
          Map.entry(long.class, 1L),
          Map.entry(int.class, 1));

  @Test
  void eachMethodRefusesNullWithTheParametersNameBeforeItSendsAnything() throws Exception {
    Map<Class<?>, Object> objects =
        Map.of(
            CrossComClient.class, client,
            Programs.class, client.programs(),
            Motion.class, client.motion(),
            Pendant.class, client.pendant(),
            ControllerFiles.class, client.files(),
            Information.class, client.information(),
            Handle.class, client.handle("MYINT", Integer.class),
            ClientConfig.Builder.class, client.getConfig().toBuilder());
    List<String> wrong = new ArrayList<>();
    for (Map.Entry<Class<?>, Object> object : objects.entrySet()) {
      for (Method method : object.getKey().getDeclaredMethods()) {
        if (Modifier.isPublic(method.getModifiers()) && !Modifier.isStatic(method.getModifiers())) {
          wrong.addAll(refusals(object.getValue(), method));
        }
      }
    }

    assertThat(wrong).isEmpty();
    assertThat(requests()).isEmpty();
  }

  /** Calls a method with null for each parameter in turn; returns the refusals that are unclear. */
  private static List<String> refusals(Object target, Method method) throws IllegalAccessException {
    List<String> wrong = new ArrayList<>();
    Class<?>[] types = method.getParameterTypes();
    for (int i = 0; i < types.length; i++) {
      if (types[i].isPrimitive()
          || method.getAnnotatedParameterTypes()[i].isAnnotationPresent(Nullable.class)) {
        continue;
      }
      Object[] arguments = Arrays.stream(types).map(VALUES::get).toArray();
      arguments[i] = null;
      String what = method + ", parameter " + i + ": ";
      try {
        wrong.add(what + method.invoke(target, arguments));
      } catch (InvocationTargetException e) {
        String message = e.getCause().getMessage();
        // the message of the virtual machine: Cannot invoke ... because ... is null
        if (!(e.getCause() instanceof NullPointerException)
            || message == null
            || message.contains(" because ")) {
          wrong.add(what + e.getCause());
        }
      }
    }
    return wrong;
  }

  @Test
  void refusesNullAmongSeveralVariablesBeforeItSendsAnything() {
    KRLInt i = new KRLInt("MYINT");
    i.setValue(1);

    assertThatNullPointerException()
        .isThrownBy(() -> client.readVariables(Arrays.asList(i, null)))
        .withMessage("variables[1]");
    assertThatNullPointerException()
        .isThrownBy(() -> client.writeVariables(i, null))
        .withMessage("variables[1]");
    assertThat(requests()).isEmpty();
  }
}
