package no.hials.crosscom;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import no.hials.crosscom.CrossComAccessException.Operation;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.internal.exchange.MessageAnswer;
import no.hials.crosscom.internal.exchange.PrintedLength;
import no.hials.crosscom.internal.exchange.TextAnswer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import org.jspecify.annotations.Nullable;

/**
 * Reads or writes several variables: in as few messages as possible if the server supports it
 * (docs/reference/c3-messages.md#several-variables-6-and-7), else one by one.
 */
abstract class Batch {
  /** The maximum number of variables in a message. */
  private static final int MAX_COUNT = 255;

  /** The maximum number of bytes of the items in an answer, which has less room than a request. */
  private static final int ROOM = Codec.MAX_FRAME_LENGTH - Codec.HEADER_LENGTH - 2 - Tail.LENGTH;

  final VariableExchange exchange;
  private final C3Channel channel;
  private final MessageType type;
  private final String noun;
  private final String done;
  private final List<Item> items = new ArrayList<>();
  private final Deque<List<Item>> groups = new ArrayDeque<>();
  private @Nullable CrossComException broken;

  private Batch(
      VariableExchange exchange,
      C3Channel channel,
      List<? extends KRLVariable> variables,
      MessageType type,
      String noun,
      String done) {
    this.exchange = exchange;
    this.channel = channel;
    this.type = type;
    this.noun = noun;
    this.done = done;
    variables.forEach(variable -> items.add(new Item(variable)));
  }

  /** A variable and its failure, if any. */
  static final class Item {
    final KRLVariable variable;

    /** The text to write. */
    String text = "";

    @Nullable CrossComException failure;

    /** Whether an answer that included it was too long, so that it is not requested again. */
    boolean suspect;

    /** Whether the answer with nothing else was too long. */
    boolean tooLong;

    /** The value that was read, if it was copied. */
    @Nullable TextAnswer answer;

    /** Whether there was a request for it, and the following times were recorded. */
    boolean accessed;

    /** When the request for it was sent, by {@link System#nanoTime}. */
    long sentNanos;

    /** How long its exchange took, in ns. */
    long nanos;

    Item(KRLVariable variable) {
      this.variable = variable;
    }

    String name() {
      return variable.getName();
    }

    /** Records that an exchange with it has ended now. */
    void accessed(long exchangeNanos) {
      accessed = true;
      nanos = exchangeNanos;
      sentNanos = System.nanoTime() - exchangeNanos;
    }
  }

  /** Runs the batch, and returns one result per variable. */
  final List<VariableResult> run() {
    divide(canSendSeveral());
    for (List<Item> group = nextGroup(); group != null; group = nextGroup()) {
      if (isAlone(group)) {
        alone(group.get(0));
      } else {
        send(group);
      }
    }
    return results();
  }

  /** Returns whether a group is a single item, to be read or written by a message for one. */
  static boolean isAlone(List<Item> group) {
    return group.size() == 1 && !group.get(0).suspect;
  }

  final List<Item> items() {
    return items;
  }

  private List<VariableResult> results() {
    return items.stream().map(item -> new VariableResult(item.variable, item.failure)).toList();
  }

  /**
   * Returns whether the server has messages for several variables. If asking fails, the batch ends.
   */
  private boolean canSendSeveral() {
    if (items.size() < 2) {
      return false;
    }
    try {
      return channel.find(what(items), server -> server.supportsCorrectly(type));
    } catch (CrossComException e) {
      fail(items.subList(0, 1), e);
      return false;
    }
  }

  /** Divides the items into groups that share a message. */
  final void divide(boolean together) {
    List<Item> group = new ArrayList<>();
    long length = 0;
    for (Item item : items) {
      long itemLength = together ? length(item) : -1;
      boolean alone = itemLength < 0 || itemLength > ROOM;
      if (alone || group.size() == MAX_COUNT || length + itemLength > ROOM) {
        add(group); // an item that goes alone keeps its place in the order
        group.clear();
        length = 0;
      }
      if (alone) {
        groups.add(List.of(item));
      } else if (item.failure == null) {
        group.add(item);
        length += itemLength;
      }
    }
    add(group);
  }

  private void add(List<Item> group) {
    if (!group.isEmpty()) {
      groups.add(List.copyOf(group));
    }
  }

  /** Removes the next group of items that can still be tried; returns null at the end. */
  final @Nullable List<Item> nextGroup() {
    List<Item> group = groups.poll();
    while (group != null && broken != null) {
      CrossComException why = broken;
      group.stream()
          .filter(item -> item.failure == null)
          .forEach(item -> item.failure = notTried(item, why));
      group = groups.poll();
    }
    return group;
  }

  /** Puts a group at the head of the queue. */
  final void sendNext(List<Item> group) {
    groups.addFirst(group);
  }

  /** Puts items at the head of the queue, each in a message of its own. */
  final void oneByOne(List<Item> some) {
    for (int i = some.size() - 1; i >= 0; i--) {
      some.get(i).suspect = false;
      sendNext(List.of(some.get(i)));
    }
  }

  private void alone(Item item) {
    if (item.failure != null) {
      return;
    }
    try {
      exchangeAlone(item);
    } catch (CrossComException e) {
      if (isOfOneItem(e)) {
        item.failure = e;
      } else {
        fail(List.of(item), e);
      }
    } catch (IllegalArgumentException e) {
      // the server cannot take this name: the results of the other variables are kept
      if (!(e.getCause() instanceof CrossComUnsupportedException unsupported)) {
        throw e;
      }
      item.failure = unsupported;
    }
  }

  /** Returns whether a failure is that of one item, after which others can be tried. */
  static boolean isOfOneItem(CrossComException failure) {
    return failure instanceof CrossComAccessException
        || failure instanceof CrossComValueException
        || failure instanceof CrossComUnsupportedException;
  }

  /** Records that an exchange failed, which ends the batch. */
  final void fail(List<Item> some, CrossComException e) {
    some.forEach(item -> item.failure = e);
    broken = e;
  }

  private CrossComException notTried(Item item, CrossComException why) {
    String message =
        item.name()
            + " was not "
            + done
            + ", since an exchange before it failed: "
            + why.getMessage();
    return why instanceof CrossComClosedException
        ? new CrossComClosedException(message, why, false)
        : new CrossComConnectionLostException(message, why, false);
  }

  private void send(List<Item> group) {
    try {
      accept(group, channel.exchange(request(group), MultipleResponse.class, what(group)));
    } catch (CrossComUnsupportedException e) {
      oneByOne(group); // reconnected meanwhile, to another server
    } catch (CrossComException e) {
      fail(group, e);
    }
  }

  /** Takes the answer to the request of a group. */
  final void accept(List<Item> group, MessageAnswer answered) {
    List<AccessResult> results =
        answered.response() instanceof MultipleResponse several ? several.results() : List.of();
    Tail tail = answered.response().tail();
    boolean contradicts = !tail.success() && results.stream().allMatch(AccessResult::success);
    if (results.size() != group.size() || contradicts) {
      notEach(group, results.size(), tail);
      return;
    }
    for (int i = 0; i < group.size(); i++) {
      Item item = group.get(i);
      try {
        take(item, results.get(i), answered.nanos());
      } catch (CrossComException e) {
        item.failure = e;
      }
    }
  }

  final String what(List<Item> some) {
    String first = noun + " of " + some.get(0).name();
    return some.size() == 1 ? first : first + " and " + (some.size() - 1) + " more";
  }

  /**
   * Returns the bytes of an item in a request or, if more are known, in its answer; -1 if it cannot
   * share a message with others.
   */
  abstract long length(Item item);

  abstract Request request(List<Item> some);

  abstract void exchangeAlone(Item item) throws CrossComException;

  abstract void take(Item item, AccessResult result, long nanos) throws CrossComException;

  /** Handles an answer without a result for each item, or a failure with only good results. */
  abstract void notEach(List<Item> some, int count, Tail tail);

  /** Returns the length of a WSTRING in bytes. */
  private static long wide(String text) {
    return wide(text.length());
  }

  private static long wide(int characters) {
    return 2 + 2L * characters;
  }

  /** Reads variables. */
  static class Reading extends Batch {
    Reading(VariableExchange exchange, C3Channel channel, List<? extends KRLVariable> variables) {
      super(exchange, channel, variables, MessageType.READ_MULTIPLE, "read", "read");
    }

    @Override
    long length(Item item) {
      return wide(item.name());
    }

    @Override
    Request request(List<Item> some) {
      return new ReadMultipleRequest(0, some.stream().map(Item::name).toList());
    }

    @Override
    void exchangeAlone(Item item) throws CrossComException {
      if (item.tooLong && item.variable instanceof KRLArray array) {
        exchange.readElements(array, VariableExchange.NO_PROGRESS);
      } else {
        exchange.read(item.variable);
      }
    }

    @Override
    void take(Item item, AccessResult result, long nanos) throws CrossComException {
      if (result.success() && !result.value().isEmpty()) {
        take(item, new TextAnswer(result.value(), nanos));
      } else if (item.variable instanceof KRLArray array && array.getDeclaredLength() > 0) {
        oneByOne(List.of(item));
      } else {
        throw new CrossComAccessException(
            item.name(), Operation.READ, result.success(), result.code().number());
      }
    }

    /** Takes the value of an item. */
    void take(Item item, TextAnswer answer) throws CrossComException {
      VariableExchange.take(item.variable, answer, false);
    }

    /**
     * The answer may not fit into a message, while parts of it would
     * (docs/reference/c3-messages.md#error-codes).
     */
    @Override
    void notEach(List<Item> some, int count, Tail tail) {
      if (tail.code() != ErrorCode.LONG_ANSWER.code()) {
        oneByOne(some);
      } else if (some.size() == 1) {
        tooLong(some.get(0));
      } else {
        some.forEach(item -> item.suspect = true);
        int half = some.size() / 2;
        sendNext(some.subList(half, some.size()));
        sendNext(some.subList(0, half));
      }
    }

    /** Messages 0 and 4 would end the connection (docs/reference/c3-messages.md). */
    private void tooLong(Item item) {
      item.tooLong = true;
      if (item.variable instanceof KRLArray array && array.getDeclaredLength() > 0) {
        oneByOne(List.of(item));
      } else {
        item.failure = CrossComValueException.tooLong(item.name());
      }
    }
  }

  /** Reads variables and copies their values without parsing them. */
  static final class Copying extends Reading {
    Copying(VariableExchange exchange, C3Channel channel, List<? extends KRLVariable> variables) {
      super(exchange, channel, variables);
    }

    /** Returns whether a value was read. */
    boolean hasAnswer() {
      return items().stream().anyMatch(item -> item.answer != null);
    }

    @Override
    void take(Item item, TextAnswer answer) {
      item.answer = answer;
    }
  }

  /** Writes variables, all of which have a value. */
  static final class Writing extends Batch {
    Writing(VariableExchange exchange, C3Channel channel, List<? extends KRLVariable> variables) {
      super(exchange, channel, variables, MessageType.WRITE_MULTIPLE, "write", "written");
    }

    @Override
    long length(Item item) {
      if (item.variable instanceof KRLArray) {
        return -1; // goes element by element (docs/reference/krl-values.md#arrays)
      }
      item.text = item.variable.getStringValue();
      try {
        exchange.checkValue(item.name(), item.text);
      } catch (CrossComValueException e) {
        item.failure = e;
      }
      return Math.max(
          wide(item.name()) + wide(item.text), 1 + wide(PrintedLength.longest(item.text)));
    }

    @Override
    Request request(List<Item> some) {
      return new WriteMultipleRequest(
          0, some.stream().map(item -> new Assignment(item.name(), item.text)).toList());
    }

    @Override
    void exchangeAlone(Item item) throws CrossComException {
      exchange.write(item.variable);
    }

    @Override
    void take(Item item, AccessResult result, long nanos) throws CrossComException {
      if (!result.success()) {
        throw new CrossComAccessException(
            item.name(), Operation.WRITE, false, result.code().number());
      }
      VariableExchange.takeEcho(item.variable, new TextAnswer(result.value(), nanos));
    }

    /**
     * Some of the writes may be done, and it is not known which. The server also executes the
     * writes whose answer does not fit into a message; then the batch continues
     * (docs/reference/c3-messages.md#several-variables-6-and-7).
     */
    @Override
    void notEach(List<Item> some, int count, Tail tail) {
      boolean tooLong = tail.code() == ErrorCode.LONG_ANSWER.code();
      CrossComException unknown =
          new CrossComProtocolException(
              "the answer to the "
                  + what(some)
                  + " must have "
                  + some.size()
                  + " results, a bad one if it says failure; it says "
                  + (tail.success() ? "success" : "failure")
                  + ", code "
                  + tail.code()
                  + (tooLong ? " (it does not fit into one message)" : "")
                  + ", and has "
                  + count,
              null,
              true);
      if (tooLong) {
        some.forEach(item -> item.failure = unknown);
      } else {
        fail(some, unknown);
      }
    }
  }
}
