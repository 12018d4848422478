package no.hials.crosscom.cli.base;

import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Function;
import java.util.stream.Stream;
import no.hials.crosscom.cli.Main;

/** The command {@code mock} on a thread of the tests' JVM, on a free port. */
public final class RunningMock implements AutoCloseable {
  private static final String FIRST = "listening on 127.0.0.1:";

  private final Lines out = new Lines();
  private final Lines err = new Lines();
  private final CompletableFuture<Integer> code = new CompletableFuture<>();
  private final Thread thread;
  private final String port;

  /** Starts it and waits for its first line. */
  public RunningMock(String... options) throws InterruptedException {
    String[] args =
        Stream.concat(Stream.of("mock", "--port", "0"), Stream.of(options)).toArray(String[]::new);
    thread = new Thread(() -> serve(args));
    thread.start();
    String first = out.next();
    if (!first.startsWith(FIRST)) {
      throw new AssertionError("mock said: " + first + System.lineSeparator() + err.rest());
    }
    port = first.substring(FIRST.length());
  }

  private void serve(String... args) {
    code.complete(Main.run(args, out, err));
    // a caller that waits for a line gets this one, and fails
    out.write("ended");
    out.flush();
  }

  public String nextLine() throws InterruptedException {
    return out.next();
  }

  public String nextErrorLine() throws InterruptedException {
    return err.next();
  }

  public boolean isRunning() {
    return !code.isDone();
  }

  /** Runs another command on it, which may be {@code file ls}. */
  public Cli.Result run(String command, String... args) {
    Stream<String> options = Stream.of("--host", "127.0.0.1", "--port", port);
    return Cli.run(
        Stream.of(Stream.of(command.split(" ")), options, Stream.of(args))
            .flatMap(Function.identity())
            .toArray(String[]::new));
  }

  /** Reads one variable and returns the text after the equals sign. */
  public String read(String name) {
    Cli.Result result = run("read", name);
    if (result.code() != 0) {
      throw new AssertionError(result.err());
    }
    return result.out().substring(result.out().indexOf('=') + 1).strip();
  }

  /** Stops it and returns its exit code. */
  public int stop() {
    thread.interrupt();
    return code.join();
  }

  @Override
  public void close() {
    stop();
  }

  /** Hands over what is printed, line by line. */
  private static final class Lines extends Writer {
    private final BlockingQueue<String> complete = new LinkedBlockingQueue<>();
    private final StringBuilder begun = new StringBuilder();

    String next() throws InterruptedException {
      return complete.take();
    }

    List<String> rest() {
      List<String> rest = new ArrayList<>();
      complete.drainTo(rest);
      return rest;
    }

    @Override
    public void write(String text) {
      begun.append(text);
    }

    @Override
    public void write(char[] chars, int off, int len) {
      begun.append(chars, off, len);
    }

    @Override
    public void flush() {
      begun.toString().lines().forEach(complete::add);
      begun.setLength(0);
    }

    @Override
    public void close() {}
  }
}
