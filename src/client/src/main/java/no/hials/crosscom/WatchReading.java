package no.hials.crosscom;

import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import no.hials.crosscom.Batch.Item;
import no.hials.crosscom.Connection.AnswerHandler;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.ServerDetector.Question;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.internal.VariableName;
import no.hials.crosscom.internal.exchange.ExchangeAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.SelectorLoop;
import no.hials.crosscom.internal.exchange.TextAnswer;
import no.hials.crosscom.internal.exchange.TextCharset;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import org.jspecify.annotations.Nullable;

/**
 * One reading of the variables of a watch, in the thread of the {@link SelectorLoop}: the exchanges
 * of {@link VariableExchange#readAll}, none of which blocks. Between two steps others can use the
 * connection. If the connection is another one than that of the values so far, the reading restarts
 * once.
 */
final class WatchReading {
  private final VariableExchange exchange;
  private final ReconnectingConnection connection;
  private final ServerDetector detector;
  private final Supplier<Batch.Copying> newBatch;
  private final Listener listener;

  // used by the loop after the start
  private Batch.Copying batch;
  private @Nullable Connection used;
  private boolean restarted;

  /** Receives the end of a reading, in the thread of the loop. */
  interface Listener {
    /** Called with the items, each of which has an answer or a failure. */
    void read(List<Item> items);

    /** Called after an unexpected exception. */
    void broken(Throwable failure);
  }

  /** Creates a reading. */
  WatchReading(
      VariableExchange exchange,
      ReconnectingConnection connection,
      C3Channel channel,
      List<? extends KRLVariable> variables,
      Listener listener) {
    this.exchange = exchange;
    this.connection = connection;
    this.detector = channel.detector();
    this.newBatch = () -> new Batch.Copying(exchange, channel, variables);
    this.batch = newBatch.get();
    this.listener = listener;
  }

  /** Starts the reading; any thread may call it. */
  void start() {
    if (batch.items().size() > 1) {
      new Division().begin();
    } else {
      batch.divide(false);
      next();
    }
  }

  private void next() {
    List<Item> group = batch.nextGroup();
    if (group == null) {
      listener.read(batch.items());
    } else if (Batch.isAlone(group)) {
      new Single(group.get(0)).begin();
    } else {
      new Several(group).begin();
    }
  }

  /** Something that may throw the failure of a step. */
  @FunctionalInterface
  private interface Action {
    void run() throws CrossComException;
  }

  /** Uses an answer, which is valid until the next exchange. */
  @FunctionalInterface
  private interface Use {
    void of(ExchangeAnswer answer) throws CrossComException;
  }

  /** A part of the reading that has the turn. It is repeated once if the connection breaks. */
  private abstract class Step {
    private boolean repeated;

    final boolean isRepeated() {
      return repeated;
    }

    final void begin() {
      connection.beginAsync(this::connect);
    }

    private void connect() {
      connection.connectedAsync(this::continued, this::fail);
    }

    private void continued() {
      Connection before = used;
      used = connection.connection();
      if (used != before && !restarted && batch.hasAnswer()) {
        restarted = true;
        batch = newBatch.get();
        connection.endAsync();
        start();
      } else {
        guard(this::run);
      }
    }

    private void guard(Action action) {
      try {
        action.run();
      } catch (CrossComException e) {
        fail(e);
      } catch (RuntimeException | Error e) {
        if (e.getCause() instanceof CrossComUnsupportedException unsupported) {
          fail(unsupported); // the server cannot take this name
        } else {
          connection.endAsync();
          listener.broken(e);
        }
      }
    }

    private void fail(CrossComException e) {
      if (e instanceof CrossComConnectionLostException
          && !repeated
          && connection.mayRepeat(Repeatability.READ)) {
        repeated = true;
        connection.connectAsync(this::continued, this::fail);
      } else {
        failed(e);
        end();
      }
    }

    final void end() {
      connection.endAsync();
      next();
    }

    /** Sends a request; the step continues with the answer. */
    final void send(byte[] frame, MessageType type, String name, Use use) {
      connection.sendAsync(
          frame,
          frame.length,
          type,
          Repeatability.READ,
          name,
          new AnswerHandler() {
            @Override
            public void answered(ExchangeAnswer answer) {
              guard(() -> use.of(answer));
            }

            @Override
            public void failed(CrossComException failure) {
              fail(failure);
            }
          });
    }

    /** Asks the server until all is known, then continues. */
    final void detect(boolean withVersion, Action then) throws CrossComException {
      Question question = detector.question(withVersion);
      if (question == null) {
        then.run();
        return;
      }
      send(
          question.frame(),
          question.message(),
          question.phrase(),
          answer -> {
            detector.answered(question, answer.frame());
            detect(withVersion, then);
          });
    }

    /** Begins, on a connection that is usable; at the end it calls {@link #end}. */
    abstract void run() throws CrossComException;

    abstract void failed(CrossComException failure);
  }

  /** Finds out which variables can share a message. */
  private final class Division extends Step {
    @Override
    void run() throws CrossComException {
      detect(
          true,
          () -> {
            batch.divide(detector.supportsCorrectly(MessageType.READ_MULTIPLE));
            end();
          });
    }

    @Override
    void failed(CrossComException failure) {
      batch.fail(batch.items().subList(0, 1), failure);
      batch.divide(false);
    }
  }

  /** Reads a group in one message. */
  private final class Several extends Step {
    private final List<Item> group;

    Several(List<Item> group) {
      this.group = group;
    }

    @Override
    void run() throws CrossComException {
      detect(true, this::read);
    }

    private void read() throws CrossComException {
      if (!detector.supportsCorrectly(MessageType.READ_MULTIPLE)) {
        batch.oneByOne(group); // reconnected meanwhile, to another server
        end();
        return;
      }
      send(
          Codec.encode(batch.request(group)),
          MessageType.READ_MULTIPLE,
          batch.what(group),
          answer -> {
            group.forEach(item -> item.accessed(answer.nanos()));
            batch.accept(group, connection.message(answer, MultipleResponse.class));
            end();
          });
    }

    @Override
    void failed(CrossComException failure) {
      batch.fail(group, failure);
    }
  }

  /** Reads a variable, as {@link VariableExchange#read(KRLVariable)} does. */
  private final class Single extends Step {
    private final Item item;
    private final String name;

    Single(Item item) {
      this.item = item;
      this.name = item.name();
    }

    @Override
    void run() throws CrossComException {
      if (isRepeated() && VariableName.isWhole(name)) {
        detect(true, this::readWhole);
      } else if (VariableExchange.isReadAsText(name) || VariableExchange.isText(item.variable)) {
        readText();
      } else {
        readAny();
      }
    }

    private void readAny() throws CrossComException {
      byte[] frame = Objects.requireNonNull(VariableAccess.get().readFrame(item.variable));
      read(
          frame,
          answer -> {
            TextAnswer bytes = answer.toText();
            if (TextCharset.isPlain(answer.frame())) {
              take(bytes);
            } else {
              detect(false, () -> readAgain(bytes));
            }
          });
    }

    /** Reads with function 0. */
    private void read(byte[] frame, Use use) throws CrossComException {
      exchange.checkLength(frame, name);
      send(
          frame,
          MessageType.READ,
          name,
          answer -> {
            item.accessed(answer.nanos());
            use.of(VariableExchange.checkRead(answer, name));
          });
    }

    private void readAgain(TextAnswer bytes) throws CrossComException {
      if (detector.type() == ServerType.KUKAVARPROXY) {
        take(exchange.decode(bytes, name, false));
      } else {
        VariableExchange.checkUtf16(bytes, name);
        readUtf16();
      }
    }

    /** C3 Bridge may have closed the connection because the value is too long otherwise. */
    private void readWhole() throws CrossComException {
      if (!detector.supportsCorrectly(MessageType.READ_MULTIPLE)) {
        readText();
        return;
      }
      send(
          Codec.encode(new ReadMultipleRequest(0, List.of(name))),
          MessageType.READ_MULTIPLE,
          "read of " + name,
          answer -> {
            item.accessed(answer.nanos());
            TextAnswer whole =
                VariableExchange.whole(connection.message(answer, MultipleResponse.class), name);
            if (whole == null) {
              readText();
            } else {
              take(whole);
            }
          });
    }

    private void readText() throws CrossComException {
      detect(
          false,
          () -> {
            if (detector.type() == ServerType.KUKAVARPROXY) {
              read(
                  Codec.encode(new ReadRequest(0, exchange.encodeName(name))),
                  answer -> take(exchange.decode(answer.toText(), name, false)));
            } else {
              readUtf16();
            }
          });
    }

    private void readUtf16() {
      send(
          Codec.encode(new ReadUtf16Request(0, name)),
          MessageType.READ_UTF16,
          "read of " + name,
          answer -> {
            item.accessed(answer.nanos());
            take(VariableExchange.utf16(connection.message(answer, TextResponse.class), name));
          });
    }

    private void take(TextAnswer answer) {
      item.answer = answer;
      end();
    }

    @Override
    void failed(CrossComException failure) {
      if (Batch.isOfOneItem(failure)) {
        item.failure = failure;
      } else {
        batch.fail(List.of(item), failure);
      }
    }
  }
}
