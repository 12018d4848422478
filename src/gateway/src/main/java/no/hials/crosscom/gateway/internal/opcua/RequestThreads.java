package no.hials.crosscom.gateway.internal.opcua;

import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.UaRequestMessageType;
import org.eclipse.milo.opcua.stack.core.types.UaResponseMessageType;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The threads that handle requests. If all are in use, the next requests are not read.
 *
 * <p>A request whose task fails is answered as well: Milo answers only the failures that it
 * expects, and the clients of all others would wait.
 */
final class RequestThreads extends ThreadPoolExecutor {
  private static final Logger LOG = LoggerFactory.getLogger(RequestThreads.class);

  /** The maximum number of requests at a time; a write waits for its robot. */
  private static final int MOST = 500;

  /** Fails with the request that this thread hands over; null at other times. */
  private static final ThreadLocal<@Nullable CompletableFuture<Void>> HANDED_OVER =
      new ThreadLocal<>();

  /** The names of the types of requests of which a failure was logged. */
  private final Set<String> logged = ConcurrentHashMap.newKeySet();

  RequestThreads(ThreadFactory threads) {
    super(0, MOST, 60, TimeUnit.SECONDS, new SynchronousQueue<>(), threads, new CallerRunsPolicy());
  }

  /**
   * Handles a request.
   *
   * @param handler hands it over to a task of this executor, and returns its answer
   * @return the answer, which also completes if the task fails
   */
  CompletableFuture<UaResponseMessageType> handle(
      UaRequestMessageType request, Supplier<CompletableFuture<UaResponseMessageType>> handler) {
    CompletableFuture<Void> failed = new CompletableFuture<>();
    HANDED_OVER.set(failed);
    try {
      CompletableFuture<UaResponseMessageType> answer = handler.get();
      CompletableFuture<Void> unused =
          failed.whenComplete(
              (nothing, failure) -> {
                answer.completeExceptionally(
                    new UaException(StatusCodes.Bad_InternalError, failure));
                log(request, failure);
              });
      return answer;
    } finally {
      HANDED_OVER.remove();
    }
  }

  private void log(UaRequestMessageType request, Throwable failure) {
    String name = request.getClass().getSimpleName();
    if (logged.add(name)) { // once, since clients can repeat it
      LOG.warn("OPC UA: a {} has failed", name, failure);
    } else {
      LOG.debug("OPC UA: a {} has failed", name, failure);
    }
  }

  @Override
  public void execute(Runnable task) {
    CompletableFuture<Void> failed = HANDED_OVER.get();
    super.execute(failed == null ? task : () -> run(task, failed));
  }

  private void run(Runnable task, CompletableFuture<Void> failed) {
    HANDED_OVER.remove(); // the thread that hands over can be the one that runs
    try {
      task.run();
    } catch (RuntimeException | Error e) {
      failed.completeExceptionally(e);
    }
  }
}
