package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/**
 * The jar on a terminal made by {@code script} of util-linux: what is typed and shown. {@code env}
 * of coreutils lets Ctrl-C through also where the build ignores it, as a background job of a script
 * does.
 */
public final class PseudoTerminal implements AutoCloseable {
  public static final String CTRL_C = "\u0003";
  public static final String CTRL_D = "\u0004";

  private static final int LIMIT_SECONDS = 60;

  private final Process process;
  private final Reader reader;
  private final StringBuilder shown = new StringBuilder();
  private final CompletableFuture<Process> limit;
  private int seen;

  /**
   * The output of the terminal.
   *
   * @param code the exit code
   * @param text all that came, with the echo of what was typed
   */
  public record Shown(int code, String text) {}

  private PseudoTerminal(Process process) {
    this.process = process;
    this.reader = new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8);
    // a test that waits for what does not come fails, as the stream ends
    this.limit =
        CompletableFuture.supplyAsync(
            process::destroyForcibly,
            CompletableFuture.delayedExecutor(LIMIT_SECONDS, TimeUnit.SECONDS));
  }

  /**
   * Starts a command.
   *
   * @param environment added to that of this process; the kind of the terminal is xterm
   * @param form what {@code sh} is to do, with {@code %s} for the command
   */
  public static PseudoTerminal start(Map<String, String> environment, String form, String... args)
      throws IOException {
    String command =
        Jar.command(args).stream().map(arg -> "'" + arg + "'").collect(Collectors.joining(" "));
    ProcessBuilder builder =
        new ProcessBuilder(
            "env", "--default-signal=INT", "script", "-qec", form.formatted(command), "/dev/null");
    builder
        .environment()
        .keySet()
        .removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "NO_COLOR"));
    builder.environment().put("TERM", "xterm");
    builder.environment().put("SHELL", "/bin/sh");
    builder.environment().putAll(environment);
    return new PseudoTerminal(builder.redirectErrorStream(true).start());
  }

  /**
   * Runs a command until it ends.
   *
   * @param term the kind of the terminal
   * @param until a text, after which the keys are pressed, if it comes
   */
  public static Shown run(String term, String until, String keys, String... args)
      throws IOException, InterruptedException {
    try (PseudoTerminal terminal = start(Map.of("TERM", term), "exec %s", args)) {
      if (terminal.shows(until)) {
        terminal.type(keys);
      }
      return terminal.end();
    }
  }

  /** Waits until a text is shown that was not there when the last keys were pressed. */
  public PseudoTerminal until(String text) throws IOException {
    if (!shows(text)) {
      throw new AssertionError("waiting for '" + text + "' it ended, and showed: " + shown);
    }
    return this;
  }

  private boolean shows(String text) throws IOException {
    int at = shown.indexOf(text, seen);
    while (at < 0) {
      if (!read()) {
        return false;
      }
      at = shown.indexOf(text, seen);
    }
    seen = at + text.length();
    return true;
  }

  private boolean read() throws IOException {
    char[] chars = new char[1000];
    int length = reader.read(chars);
    if (length > 0) {
      shown.append(chars, 0, length);
    }
    return length > 0;
  }

  public PseudoTerminal type(String keys) throws IOException {
    try {
      process.getOutputStream().write(keys.getBytes(StandardCharsets.UTF_8));
      process.getOutputStream().flush();
    } catch (IOException e) {
      throw new AssertionError("it takes no more keys, and showed: " + rest(), e);
    }
    return this;
  }

  private String rest() throws IOException {
    while (read()) {
      // to the end
    }
    return shown.toString();
  }

  /** Waits for the end. */
  public Shown end() throws IOException, InterruptedException {
    String text = rest();
    return new Shown(process.waitFor(), text);
  }

  /** Waits for the end, which has to be without an error, and returns the whole output. */
  public String finish() throws IOException, InterruptedException {
    Shown all = end();
    assertThat(all.code()).as(all.text()).isZero();
    return all.text();
  }

  /** Returns the process of the command itself. */
  public ProcessHandle command() {
    return process
        .descendants()
        .filter(each -> each.info().command().orElse("").endsWith("java"))
        .findAny()
        .orElseThrow();
  }

  /** Closes the terminal, as when its window is closed. */
  public void hangUp() {
    process.destroyForcibly();
  }

  @Override
  public void close() {
    limit.cancel(false);
    hangUp();
  }
}
