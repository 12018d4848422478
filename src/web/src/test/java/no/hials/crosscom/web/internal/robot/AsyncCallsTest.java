package no.hials.crosscom.web.internal.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.cell.AsyncCalls;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class AsyncCallsTest {
  @KukaController private MockServer server;
  private final CountDownLatch released = new CountDownLatch(1);
  private CrossComClient client;

  @BeforeEach
  void connect() throws IOException {
    server.variables().set("MYINT", "1");
    client =
        new CrossComClient(
            ClientConfig.create(
                server.host(),
                cfg ->
                    cfg.port(server.port())
                        .requestTimeout(Duration.ofSeconds(50))
                        .maxPendingCalls(1)));
  }

  @AfterEach
  void close() throws IOException {
    released.countDown();
    client.close();
  }

  /** Begins a read that the controller answers when it is released. */
  private CompletableFuture<String> read() throws InterruptedException {
    CountDownLatch asked = new CountDownLatch(1);
    server.fault(
        it -> {
          asked.countDown();
          return true;
        },
        Fault.hold(released));
    CompletableFuture<String> call = client.async(it -> it.readText("MYINT"));
    asked.await();
    return call;
  }

  @Test
  void aResultIsReturned() throws Exception {
    CompletableFuture<String> call = client.async(it -> it.readText("MYINT"));

    assertThat(AsyncCalls.await(call, Duration.ofSeconds(50))).isEqualTo("1");
  }

  @Test
  void aCallThatWasSentIsWaitedForAfterItsTime() throws Exception {
    CompletableFuture<String> call = read();
    CompletableFuture<String> result =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return AsyncCalls.await(call, Duration.ZERO);
              } catch (IOException | InterruptedException e) {
                throw new AssertionError(e);
              }
            });

    released.countDown();

    assertThat(result.join()).isEqualTo("1");
  }

  @Test
  void aCallThatIsNotSentInTimeIsCancelled() throws Exception {
    client.close();
    client = new CrossComClient(ClientConfig.create(server.host(), cfg -> cfg.port(server.port())));
    CompletableFuture<String> first = read();
    CompletableFuture<String> call = client.async(it -> it.writeText("MYINT", "2"));

    assertThatThrownBy(() -> AsyncCalls.await(call, Duration.ofMillis(1)))
        .isInstanceOf(NotSentException.class)
        .hasMessage("it waited too long for the connection to the robot");

    released.countDown();
    assertThat(first.join()).isEqualTo("1");
    assertThat(client.readText("MYINT")).isEqualTo("1");
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).isEmpty();
  }

  @Test
  void aCallBeyondTheLimitOfTheClientIsNotSent() throws Exception {
    CompletableFuture<String> first = read();

    assertThatThrownBy(
            () -> AsyncCalls.await(client.async(it -> it.readText("MYINT")), Duration.ofHours(1)))
        .isInstanceOf(NotSentException.class)
        .hasMessageContaining("maxPendingCalls");

    released.countDown();
    assertThat(first.join()).isEqualTo("1");
  }

  @Test
  void theFailureOfACallIsThrown() {
    assertThatThrownBy(
            () ->
                AsyncCalls.await(
                    client.async(it -> it.readText("UNKNOWN_VAR")), Duration.ofSeconds(50)))
        .isInstanceOf(CrossComAccessException.class);
  }
}
