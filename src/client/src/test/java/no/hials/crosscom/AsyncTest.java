package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLIntArray;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Interpreter;
import org.junit.jupiter.api.Test;

/** Does what the other methods do, in another thread. */
class AsyncTest extends RobotTest {
  private final CountDownLatch release = new CountDownLatch(1);
  private final CountDownLatch asked = new CountDownLatch(1);

  /** Makes the controller take a request and not answer it before {@link #release}. */
  private void holdFirstRequest() {
    robot.faults(
        request -> {
          boolean first = request.number() == 1;
          asked.countDown();
          return first ? Optional.of(Fault.hold(release)) : Optional.empty();
        });
  }

  private CompletableFuture<String> readSynchronouslyInAnotherThread() {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return client.readText("$OV_PRO");
          } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
          }
        });
  }

  @Test
  void everyOperationCanBeDoneInAnotherThread() throws Exception {
    KRLInt i = new KRLInt("MYINT");
    i.setValue(5);
    client.asyncRun(c -> c.writeVariable(i)).get();
    i.setValue(0);
    client.asyncRun(c -> c.readVariable(i)).get();
    assertThat(i.getValue()).isEqualTo(5);
    client.asyncRun(c -> c.writeText("MYINT", "6")).get();
    assertThat(client.async(c -> c.readText("MYINT")).get()).isEqualTo("6");
    assertThat(client.async(c -> c.readValue("MYINT")).get()).hasToString("6");
    client.asyncRun(c -> c.writeFields(new KRLFrame("MYFRAME").setX(1), "X")).get();
    assertThat(client.async(c -> c.readVariables(List.of(i))).get()).allMatch(VariableResult::isOk);
    assertThat(client.async(c -> c.writeVariables(List.of(i))).get())
        .allMatch(VariableResult::isOk);
    KRLIntArray ints = new KRLIntArray("MYINTS");
    client.asyncRun(c -> c.readVariable(ints, (done, total) -> {})).get();
    client.asyncRun(c -> c.writeVariable(ints, (done, total) -> {})).get();
    assertThat(client.async(c -> c.simpleRead("MYINT")).get()).endsWith("#value=6");
    assertThat(client.async(c -> c.simpleWrite("MYINT", "7")).get()).endsWith("#value=7");
    assertThat(client.async(c -> c.readJointAngles()).get()).containsExactly(0, -90, 90, 0, 0, 0);
    assertThat(client.async(c -> c.readJointTorques()).get()).hasSize(6);
  }

  @Test
  void operationsAreDoneInTheOrderInWhichTheyWereAskedFor() throws Exception {
    CompletableFuture<?>[] all = new CompletableFuture<?>[50];
    for (int i = 0; i < all.length; i++) {
      String value = String.valueOf(i);
      all[i] = client.asyncRun(c -> c.writeText("MYINT", value));
    }
    CompletableFuture.allOf(all).get();

    for (int i = 0; i < all.length; i++) {
      assertThat(robot.requests().get(i).value()).isEqualTo(String.valueOf(i));
    }
  }

  @Test
  void aFailureIsThatOfTheOperation() {
    assertThatExceptionOfType(ExecutionException.class)
        .isThrownBy(() -> client.async(c -> c.readText("NOSUCHVAR")).get())
        .withCauseInstanceOf(CrossComAccessException.class);
    assertThatExceptionOfType(ExecutionException.class)
        .isThrownBy(() -> client.async(c -> c.readText(" ")).get())
        .withCauseInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void whatIsCancelledBeforeItIsSentIsNotSent() throws Exception {
    holdFirstRequest();
    CompletableFuture<String> first = client.async(c -> c.readText("$OV_PRO"));
    CompletableFuture<Void> write = client.asyncRun(c -> c.writeText("MYINT", "9"));
    asked.await();

    assertThat(write.cancel(false)).isTrue();
    assertThat(first.cancel(true)).as("it was sent").isFalse();
    release.countDown();

    assertThat(first.get()).isEqualTo("100");
    assertThatExceptionOfType(CancellationException.class).isThrownBy(write::get);
    assertThat(client.async(c -> c.readText("MYINT")).get()).isEqualTo("0");
    assertThat(robot.requests())
        .extracting(RecordedRequest::name)
        .containsExactly("$OV_PRO", "MYINT");
  }

  @Test
  void whatWaitsBehindASynchronousCallCanStillBeCancelled() throws Exception {
    holdFirstRequest();
    CompletableFuture<String> sync = readSynchronouslyInAnotherThread();
    asked.await();
    CompletableFuture<Void> write = client.asyncRun(c -> c.writeText("MYINT", "9"));

    assertThat(write.cancel(false)).isTrue();
    release.countDown();

    assertThat(sync.get()).isEqualTo("100");
    assertThat(client.readText("MYINT")).isEqualTo("0");
    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void aCallIsNotSentIfItsConditionIsFalseWhenItsTurnComes() throws Exception {
    holdFirstRequest();
    CompletableFuture<String> sync = readSynchronouslyInAnotherThread();
    asked.await();
    AtomicBoolean allowed = new AtomicBoolean(true);
    CompletableFuture<String> write = client.async(c -> c.writeText("MYINT", "9"), allowed::get);
    CompletableFuture<Void> more = client.asyncRun(c -> c.writeText("MYINT", "8"), allowed::get);

    allowed.set(false);
    release.countDown();

    assertThat(sync.get()).isEqualTo("100");
    assertThatExceptionOfType(CancellationException.class).isThrownBy(write::get);
    assertThatExceptionOfType(CancellationException.class).isThrownBy(more::get);
    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
    allowed.set(true);
    assertThat(client.async(c -> c.writeText("MYINT", "7"), allowed::get).get()).isEqualTo("7");
  }

  @Test
  void aWriteByTheOuterClientIsNotCancelledOnceItIsSent() throws Exception {
    holdFirstRequest();
    CompletableFuture<Void> write = client.asyncRun(c -> client.writeText("MYINT", "9"));
    asked.await();

    assertThat(write.cancel(false)).as("it was sent").isFalse();
    release.countDown();

    write.get();
    assertThat(robot.variables().get("MYINT")).isEqualTo("9");
  }

  @Test
  void aWriteByTheOuterClientIsNotSentIfItIsCancelledBefore() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CompletableFuture<Void> write =
        client.asyncRun(
            c -> {
              begun.countDown();
              release.await();
              client.writeText("MYINT", "9");
            });
    begun.await();

    assertThat(write.cancel(false)).isTrue();
    release.countDown();

    assertThat(client.async(c -> c.readText("MYINT")).get()).as("after it").isEqualTo("0");
    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void aCallCanBeCancelledWhileItConnects() throws Exception {
    try (CrossComClient its = client(cfg -> {})) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      int port = robot.port();
      robot.close();
      AtomicReference<Thread> caller = new AtomicReference<>();
      try (ServerSocket full = withFullBacklog(port)) {
        assertThat(full.getLocalPort()).isEqualTo(port);
        CompletableFuture<Void> write =
            its.asyncRun(
                c -> {
                  caller.set(Thread.currentThread());
                  c.writeText("MYINT", "9");
                });
        awaitWaiting(caller);

        assertThat(write.cancel(false)).as("nothing was sent").isTrue();
      }
    }
  }

  @Test
  void aCallCanBeCancelledWhileTheClientAsksWhichServerItIs() throws Exception {
    try (MockServer bridge = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE));
        CrossComClient its =
            new CrossComClient(
                ClientConfig.create(bridge.host(), cfg -> cfg.port(bridge.port())))) {
      bridge.faults(
          request -> {
            asked.countDown();
            return Optional.of(Fault.hold(release));
          });
      CompletableFuture<Void> start = its.asyncRun(c -> c.programs().start(Interpreter.ROBOT));
      asked.await();

      assertThat(start.cancel(false)).isTrue();
      release.countDown();

      assertThat(its.async(c -> c.readText("$OV_PRO")).get()).as("after it").isEqualTo("100");
      assertThat(bridge.requests())
          .extracting(it -> it.request().type())
          .doesNotContain(MessageType.PROGRAM_CONTROL);
    }
  }

  private static void awaitWaiting(AtomicReference<Thread> thread) {
    while (thread.get() == null || thread.get().getState() != Thread.State.WAITING) {
      Thread.onSpinWait();
    }
  }

  @Test
  void theClientOfAFunctionCanBeUsedAfterwards() throws Exception {
    CrossComClient view = client.async(c -> c).get();

    assertThat(view.readText("MYINT")).isEqualTo("0");
  }

  @Test
  void whatIsQueuedWhenTheClientIsClosedFails() throws Exception {
    holdFirstRequest();
    CompletableFuture<String> first = client.async(c -> c.readText("$OV_PRO"));
    CompletableFuture<String> second = client.async(c -> c.readText("$OV_JOG"));
    asked.await();
    client.close();
    release.countDown(); // the answer may come at the moment of closing

    Object outcome = first.<Object>handle((v, failure) -> failure == null ? v : failure).get();
    assertThat(outcome)
        .satisfiesAnyOf(
            o -> assertThat(o).isEqualTo("100"),
            o -> assertThat(o).isInstanceOf(CrossComClosedException.class));
    for (CompletableFuture<String> future : List.of(second, client.async(c -> c.readText("X")))) {
      assertThatExceptionOfType(ExecutionException.class)
          .isThrownBy(future::get)
          .withCauseInstanceOf(CrossComClosedException.class);
    }
  }

  @Test
  void aCallByAFunctionRunsAtOnceAsAPartOfItsCall() throws Exception {
    holdFirstRequest();
    CompletableFuture<String> call =
        client.async(c -> c.async(d -> d.readText("MYINT")).get(60, TimeUnit.SECONDS));
    asked.await();

    assertThat(call.cancel(true)).as("the inner function has sent").isFalse();
    release.countDown();

    assertThat(call.get()).isEqualTo("0");
  }

  @Test
  void aFunctionThatWaitsForACallBehindItEndsWithTheClient() throws Exception {
    CompletableFuture<CompletableFuture<String>> behind = new CompletableFuture<>();
    CompletableFuture<String> first = client.async(c -> behind.get().get());
    behind.complete(client.async(c -> c.readText("MYINT")));
    client.close();

    for (CompletableFuture<String> future : List.of(behind.get(), first)) {
      assertThatExceptionOfType(ExecutionException.class)
          .isThrownBy(() -> future.get(60, TimeUnit.SECONDS))
          .withRootCauseInstanceOf(CrossComClosedException.class);
    }
  }

  @Test
  void allThatFollowsOnAResultRunsInTheThreadsForCallbacks() throws Exception {
    String thread =
        client
            .async(c -> c.readText("MYINT"))
            .thenApply(value -> value)
            .thenApplyAsync(value -> Thread.currentThread().getName())
            .get();

    assertThat(thread).startsWith("crosscom-callback-");
  }

  @Test
  void whatFollowsOnAResultDoesNotHoldUpOtherOperations() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    // answered when thenAccept has been called: on a result that is there it would run here
    holdFirstRequest();
    CompletableFuture<Void> blocked =
        client
            .async(c -> c.readText("$OV_PRO"))
            .thenAccept(
                value -> {
                  try {
                    never.await();
                  } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                  }
                });
    release.countDown();

    assertThat(client.async(c -> c.readText("$OV_JOG")).get()).isEqualTo("10");
    assertThat(blocked).isNotDone();
    never.countDown();
    blocked.get();
  }

  @Test
  void noLockIsHeldWhileTheProgramsCodeRuns() throws Exception {
    KRLIntArray ints = new KRLIntArray("MYINTS");
    ints.setValue(1, 2, 3);
    client
        .asyncRun(
            c ->
                c.writeVariable(
                    ints,
                    (done, total) ->
                        // another thread uses the client, and this one waits for it
                        assertThat(readSynchronouslyInAnotherThread().join()).isEqualTo("100")))
        .get();

    assertThat(robot.variables().get("MYINTS[3]")).isEqualTo("3");
  }

  @Test
  void aCallAboveTheLimitIsRejectedAndSaysWhichLimit() throws Exception {
    try (CrossComClient limited = client(cfg -> cfg.maxPendingCalls(2))) {
      holdFirstRequest();
      CompletableFuture<String> first = limited.async(c -> c.readText("$OV_PRO"));
      CompletableFuture<String> second = limited.async(c -> c.readText("MYINT"));
      assertThatExceptionOfType(ExecutionException.class)
          .isThrownBy(() -> limited.asyncRun(c -> c.writeText("MYINT", "9")).get())
          .withCauseInstanceOf(RejectedExecutionException.class)
          .withMessageContaining("the client's maxPendingCalls is 2");
      release.countDown();

      assertThat(first.get()).isEqualTo("100");
      assertThat(second.get()).isEqualTo("0");
    }
  }

  @Test
  void aCancelledCallIsNotPendingAnyMore() throws Exception {
    try (CrossComClient limited = client(cfg -> cfg.maxPendingCalls(2))) {
      holdFirstRequest();
      CompletableFuture<String> first = limited.async(c -> c.readText("$OV_PRO"));
      asked.await();
      for (int i = 0; i < 3; i++) {
        assertThat(limited.asyncRun(c -> c.writeText("MYINT", "9")).cancel(false)).isTrue();
      }
      CompletableFuture<String> second = limited.async(c -> c.readText("MYINT"));
      CompletableFuture<String> above = limited.async(c -> c.readText("MYINT"));
      assertThat(above).as("the limit still holds").isCompletedExceptionally();
      release.countDown();

      assertThat(first.get()).isEqualTo("100");
      assertThat(second.get()).isEqualTo("0");
    }
  }

  @Test
  void blockedCallbacksUseNoMoreThreadsThanAllowedAndStillEnd() throws Exception {
    CountDownLatch open = new CountDownLatch(1);
    try (ClientRuntime runtime = ClientRuntime.create(cfg -> cfg.callbackThreads(2));
        CrossComClient its = client(cfg -> cfg.runtime(runtime))) {
      holdFirstRequest();
      Set<String> threads = ConcurrentHashMap.newKeySet();
      List<CompletableFuture<Void>> all = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        all.add(
            its.async(c -> c.readText("MYINT"))
                .thenAccept(
                    value -> {
                      threads.add(String.valueOf(Thread.currentThread().getId()));
                      try {
                        open.await();
                      } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                      }
                    }));
      }
      release.countDown();
      while (threads.size() < 3) { // the third is the thread that runs the calls
        Thread.onSpinWait();
      }
      open.countDown();
      CompletableFuture.allOf(all.toArray(CompletableFuture[]::new)).get();
      assertThat(threads).hasSize(3);
    }
  }
}
