package no.hials.crosscom.web;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;

/** The socket of a page, as a test opens it. */
public final class TestSocket implements WebSocket.Listener, AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final HttpClient HTTP = HttpClient.newHttpClient();
  private static final long SECONDS = 10;

  private final BlockingQueue<JsonNode> received = new LinkedBlockingQueue<>();
  private final StringBuilder part = new StringBuilder();
  private final CompletableFuture<Integer> closed = new CompletableFuture<>();
  private WebSocket socket;
  private volatile long clock = -1;
  private volatile String closeReason = "";
  private int number;

  private TestSocket() {}

  /**
   * Opens a socket.
   *
   * @throws IOException if the server refuses it
   */
  public static TestSocket open(int port, String cookie, String page, String origin)
      throws IOException {
    return open(HTTP, "http://127.0.0.1:" + port, cookie, page, origin);
  }

  /**
   * Opens a socket.
   *
   * @param server the address of the server, such as {@code http://127.0.0.1:8080}
   * @param origin the address of the page that opens it
   * @throws IOException if the server refuses it
   */
  static TestSocket open(HttpClient http, String server, String cookie, String page, String origin)
      throws IOException {
    TestSocket opened = new TestSocket();
    WebSocket.Builder builder = http.newWebSocketBuilder();
    if (!cookie.isEmpty()) {
      builder.header("Cookie", cookie);
    }
    if (!origin.isEmpty()) {
      builder.header("Origin", origin);
    }
    try {
      opened.socket =
          builder
              .buildAsync(
                  URI.create(server.replaceFirst("http", "ws") + "/socket?page=" + page), opened)
              .join();
      return opened;
    } catch (CompletionException e) {
      throw new IOException(e.getCause());
    }
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    part.append(data);
    if (last) {
      try {
        JsonNode message = MAPPER.readTree(part.toString());
        clock = message.path("clock").asLong(clock);
        received.add(message);
      } catch (IOException e) {
        throw new AssertionError(part.toString(), e);
      }
      part.setLength(0);
    }
    from.request(1);
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
    closeReason = reason;
    closed.complete(code);
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    closed.complete(1006);
  }

  /** Begins to send a text; the server may close the socket before its end. */
  public void begin(String text) {
    CompletableFuture<WebSocket> unused = socket.sendText(text, true);
  }

  /** Sends any text. */
  public void send(String text) {
    socket.sendText(text, true).join();
  }

  /**
   * Sends a command with fields, each a name and its JSON with ' instead of ", and awaits its
   * answer.
   */
  public JsonNode call(String command, String... fields) throws InterruptedException {
    ObjectNode message =
        MAPPER.createObjectNode().put("id", ++number).put("do", command).put("clock", clock());
    for (int i = 0; i < fields.length; i += 2) {
      message.set(fields[i], json(fields[i + 1]));
    }
    int own = number;
    send(message.toString());
    return await(it -> it.path("id").asInt() == own);
  }

  /** Returns the clock time of the latest answer; of a ping if there was none. */
  public long clock() throws InterruptedException {
    if (clock < 0) {
      send("{\"id\":-1,\"do\":\"ping\"}");
      await(it -> it.path("id").asInt() == -1);
    }
    return clock;
  }

  /** Parses JSON with ' in place of ". */
  public static JsonNode json(String text) {
    try {
      return MAPPER.readTree(text.replace('\'', '"'));
    } catch (IOException e) {
      throw new AssertionError(text, e);
    }
  }

  /** Returns the next message that a condition holds for, and drops those before it. */
  public JsonNode await(Predicate<JsonNode> condition) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS);
    while (true) {
      JsonNode next = received.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      if (next == null) {
        throw new AssertionError("no such message within " + SECONDS + " s");
      }
      if (condition.test(next)) {
        return next;
      }
    }
  }

  /** Returns the next samples of a list. */
  public JsonNode awaitSamples(String list) throws InterruptedException {
    return await(it -> it.path("list").asText().equals(list));
  }

  /** Returns the next event of a kind. */
  public JsonNode awaitEvent(String kind) throws InterruptedException {
    return await(it -> it.path("event").asText().equals(kind));
  }

  /** Returns the number of messages that wait. */
  public int waiting() {
    return received.size();
  }

  /** Returns the code with which the server closes the socket. */
  public int closeCode() throws InterruptedException {
    try {
      return closed.get(SECONDS, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new AssertionError("the socket is still open", e);
    }
  }

  /** Returns the reason that the server gives when it closes the socket. */
  public String closeReason() throws InterruptedException {
    int unused = closeCode();
    return closeReason;
  }

  @Override
  public void close() {
    socket.abort();
  }
}
