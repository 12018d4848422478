package no.hials.crosscom.c3;

import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.simulator.FileTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** Starts for each test a simulated controller with C3 Bridge and the files of a client of it. */
abstract class FilesRobotTest {
  static final String FILE = "KRC:\\R1\\Program\\test.src";

  /** As many bytes as a message moves (docs/reference/c3-messages.md#file-content-29-and-30). */
  static final int PART = 64_512;

  /** Never runs out. */
  static final Duration LONG = Duration.ofSeconds(60);

  /** Runs out when a test waits for it. */
  static final int SHORT_MILLIS = 150;

  @KukaController(server = ServerType.C3_BRIDGE)
  MockServer robot;

  FileTree tree;
  CrossComClient client;
  ControllerFiles files;

  @BeforeEach
  final void connect() throws Exception {
    tree = robot.files();
    client =
        new CrossComClient(
            ClientConfig.create(
                robot.host(),
                cfg -> cfg.port(robot.port()).requestTimeout(LONG).keepAlive(Duration.ZERO)));
    files = client.files();
  }

  @AfterEach
  final void disconnect() throws Exception {
    client.close();
  }

  /** Makes the same bytes each time. */
  static byte[] bytes(int count) {
    byte[] bytes = new byte[count];
    new Random(count).nextBytes(bytes);
    return bytes;
  }

  /** The steps of a transfer, as requests. */
  @SuppressWarnings("ImmutableEnumChecker") // the predicates have no state
  enum Step {
    EXISTS(FilePropertiesRequest.class::isInstance),
    BEGIN(r -> r instanceof BeginWriteRequest begin && begin.size() > 0),
    DATA(WriteDataRequest.class::isInstance),
    SIZE(r -> isContent(r, MessageType.WRITE_CONTENT, ContentOperation.SIZE)),
    END(EndWriteRequest.class::isInstance),
    BEGIN_READ(BeginReadRequest.class::isInstance),
    READ_DATA(ReadDataRequest.class::isInstance),
    READ_SIZE(r -> isContent(r, MessageType.READ_CONTENT, ContentOperation.SIZE));

    private final Predicate<Request> matches;

    Step(Predicate<Request> matches) {
      this.matches = matches;
    }

    boolean is(RecordedRequest recorded) {
      return recorded.request() != null && matches(recorded.request());
    }

    boolean matches(Request request) {
      return matches.test(request);
    }

    private static boolean isContent(
        Request request, MessageType type, ContentOperation operation) {
      return request instanceof ContentRequest content
          && content.type() == type
          && content.operation().is(operation);
    }

    static Stream<Step> ofUpload() {
      return Stream.of(EXISTS, BEGIN, DATA, SIZE, END);
    }

    static Stream<Step> ofDownload() {
      return Stream.of(BEGIN_READ, READ_DATA, READ_SIZE);
    }
  }

  /** Makes the next request of a step fail, and none after it. */
  final void once(Step step, Fault fault) {
    AtomicBoolean done = new AtomicBoolean();
    robot.fault(r -> step.is(r) && done.compareAndSet(false, true), fault);
  }

  /** Makes the server answer the next request of a step with something else. */
  final void lie(Step step, Function<Integer, Response> answer) {
    AtomicBoolean done = new AtomicBoolean();
    robot.faults(
        r -> {
          if (!step.is(r) || !done.compareAndSet(false, true)) {
            return Optional.empty();
          }
          byte[] frame = Codec.encode(answer.apply(r.request().id()));
          return Optional.of(Fault.raw(HexFormat.of().formatHex(frame)));
        });
  }

  /** Returns the requests of a step that came so far. */
  final List<Request> received(Step step) {
    return robot.requests().stream().filter(step::is).map(RecordedRequest::request).toList();
  }

  /** Makes the time-out short from a step of a transfer on: what comes before has its time. */
  static TransferConfig hastyFrom(Step step, CrossComClient client) throws Exception {
    client.getServer();
    switch (step) {
      case EXISTS, BEGIN, BEGIN_READ -> client.setSoTimeout(SHORT_MILLIS);
      default -> {}
    }
    boolean inTheMiddle = step == Step.DATA || step == Step.READ_DATA;
    return TransferConfig.create(
        cfg ->
            cfg.progress(
                (bytes, total) -> {
                  if (bytes == total || inTheMiddle) {
                    run(() -> client.setSoTimeout(SHORT_MILLIS));
                  }
                }));
  }

  /** Does something that may fail. */
  @FunctionalInterface
  interface Action {
    void run() throws Exception;
  }

  /** Does something once, when the first part of a transfer is done. */
  static TransferConfig onProgress(Action action) {
    AtomicBoolean done = new AtomicBoolean();
    return TransferConfig.create(
        cfg ->
            cfg.progress(
                (bytes, total) -> {
                  if (bytes > 0 && done.compareAndSet(false, true)) {
                    run(action);
                  }
                }));
  }

  private static void run(Action action) {
    try {
      action.run();
    } catch (RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
