package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.LogLines;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MessageStoreTest {
  private static final long LIMIT = 8000;

  @TempDir private Path folder;
  private final Health health = new Health();
  private SessionFigures figures;

  @BeforeEach
  void createFigures() {
    figures = new SessionFigures(health, "test");
  }

  private MessageStore open() {
    return new MessageStore(folder, LIMIT, figures);
  }

  private static StoredMessage message(int number) {
    return new StoredMessage("topic", ("message " + number).getBytes(UTF_8));
  }

  /** Stores messages from 1 on, and closes the store. */
  private void store(int number) {
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, number).forEach(i -> store.add(message(i)));
    }
  }

  private static List<String> takeAll(MessageStore store) {
    List<String> all = new ArrayList<>();
    for (StoredMessage next = store.next(); next != null; next = store.next()) {
      all.add(UTF_8.decode(next.payload().duplicate()).toString());
      store.confirm(next);
    }
    return all;
  }

  private static List<String> messages(int from, int to) {
    return IntStream.rangeClosed(from, to).mapToObj(i -> "message " + i).toList();
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  private double dropped(String reason) {
    return health.counter("mqtt_messages_dropped", "").labelValues("test", reason).get();
  }

  @Test
  void keepsTheOrderOverARestartAndDeletesWhatIsConfirmed() throws IOException {
    store(100);
    try (MessageStore store = open()) {
      store.add(message(101));

      assertThat(takeAll(store)).isEqualTo(messages(1, 101));
      assertThat(store.isEmpty()).isTrue();
      assertThat(files()).isEmpty();
    }
  }

  @Test
  void handsOutAgainWhatWasNotConfirmed() {
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, 3).forEach(i -> store.add(message(i)));
      store.confirm(store.next());
      assertThat(store.next()).isEqualTo(message(2));

      store.rewind();

      assertThat(takeAll(store)).isEqualTo(messages(2, 3));
    }
  }

  @Test
  void doesNotRepeatAfterARestartWhatWasConfirmed() {
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, 10).forEach(i -> store.add(message(i)));
      store.confirm(store.next());
      store.confirm(store.next());
    }
    try (MessageStore store = open()) {
      assertThat(takeAll(store)).isEqualTo(messages(3, 10));
    }
  }

  @Test
  void dropsTheOldestWhenItIsFull() {
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, 1000).forEach(i -> store.add(message(i)));

      long kept = store.size();
      assertThat(figures.storedBytes.get()).isLessThanOrEqualTo(LIMIT);
      assertThat(dropped("full")).isEqualTo((double) (1000 - kept));
      assertThat(takeAll(store)).isEqualTo(messages((int) (1001 - kept), 1000));
    }
  }

  @Test
  void aConfirmationOfADroppedMessageIsIgnored() {
    try (MessageStore store = open()) {
      store.add(message(1));
      StoredMessage first = store.next();
      IntStream.rangeClosed(2, 1000).forEach(i -> store.add(message(i)));
      long kept = store.size();

      store.confirm(first);

      assertThat(store.size()).isEqualTo(kept);
      assertThat(takeAll(store)).hasSize((int) kept).endsWith("message 1000");
    }
  }

  @Test
  void skipsTheRestOfAFileThatIsCutOff() throws IOException {
    store(60);
    List<Path> files = files();
    assertThat(files).hasSizeGreaterThan(1);
    Path first = files.get(0);
    byte[] content = Files.readAllBytes(first);
    Files.write(first, Arrays.copyOf(content, content.length - 1));

    try (MessageStore store = open()) {
      List<String> all = takeAll(store);

      assertThat(all).hasSize(59).startsWith("message 1").endsWith("message 60");
      assertThat(figures.damaged.get()).isEqualTo(1);
    }
  }

  @Test
  void skipsTheRestOfAFileThatIsDamaged() throws IOException {
    store(10);
    Path file = files().get(0);
    byte[] content = Files.readAllBytes(file);
    content[content.length / 2] ^= 1;
    Files.write(file, content);
    Files.write(
        folder.resolve("0000000000000000009.messages"),
        new byte[] {1, 2, 3},
        StandardOpenOption.CREATE);

    try (MessageStore store = open()) {
      assertThat(takeAll(store)).isEqualTo(messages(1, 5));
      assertThat(figures.damaged.get()).isEqualTo(2);
      store.add(message(11));
      assertThat(takeAll(store)).isEqualTo(messages(11, 11));
    }
  }

  @Test
  void aFileThatCannotBeReadHidesNoOther() throws IOException {
    store(100);
    List<Path> files = files();
    assertThat(files).hasSizeGreaterThan(2);
    Path first = files.get(0);
    Files.delete(first);
    Files.createDirectory(first);

    try (MessageStore store = open()) {
      assertThat(figures.damaged.get()).isEqualTo(1);
      int kept = (int) store.size();
      assertThat(kept).isPositive();
      assertThat(takeAll(store)).isEqualTo(messages(101 - kept, 100));
      assertThat(files()).containsExactly(first);
    }
  }

  @Test
  void aFileThatCannotBeReadNowIsForwardedAfterTheNextStart() throws IOException {
    Path aside = folder.resolve("aside");
    Path first;
    int later;
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, 100).forEach(i -> store.add(message(i)));
      assertThat(files()).hasSizeGreaterThan(2);
      first = files().get(0);
      Files.move(first, aside);
      Files.createDirectory(first);

      List<String> all = takeAll(store);

      later = 101 - all.size();
      assertThat(all).isNotEmpty().isEqualTo(messages(later, 100));
      assertThat(store.isEmpty()).isTrue();
      assertThat(figures.storedNow.get()).isZero();
      assertThat(figures.storedBytes.get()).isZero();
      assertThat(figures.damaged.get()).isEqualTo(1);
      assertThat(dropped("damaged")).isZero();
      assertThat(files()).containsExactly(first, aside);
    }
    Files.delete(first);
    Files.move(aside, first);

    try (MessageStore store = open()) {
      assertThat(takeAll(store)).isNotEmpty().isEqualTo(messages(1, later - 1));
    }
  }

  @Test
  void theMessagesOfAFileThatIsGoneAreCounted() throws IOException {
    try (MessageStore store = open()) {
      IntStream.rangeClosed(1, 100).forEach(i -> store.add(message(i)));
      Files.delete(files().get(0));

      List<String> all = takeAll(store);

      assertThat(all).isNotEmpty();
      assertThat(dropped("damaged")).isPositive().isEqualTo(100 - all.size());
    }
  }

  @Test
  void aNameThatIsTakenCostsOnlyOneMessage() throws IOException {
    try (MessageStore store = open()) {
      Files.createDirectory(folder.resolve("0000000000000000001.messages"));
      store.add(message(1));
      store.add(message(2));
      store.add(message(3));

      assertThat(takeAll(store)).isEqualTo(messages(2, 3));
      assertThat(dropped("disk")).isEqualTo(1);
    }
  }

  @Test
  void eachTimeWithoutTheBrokerHasALineIfMessagesCannotBeStored() throws IOException {
    folder = Files.writeString(folder.resolve("file"), "");
    try (LogLines lines = LogLines.of(MessageStore.class);
        MessageStore store = open()) {
      store.add(message(1));
      store.add(message(2));
      assertThat(lines.get()).hasSize(1);

      store.reachedBroker();
      store.add(message(3));

      assertThat(lines.get())
          .hasSize(2)
          .allMatch(line -> line.startsWith("cannot store messages in " + folder));
    }
  }
}
