package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.protocol.value.PrintableText;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.sink.ErrantRecordReporter;
import org.apache.kafka.connect.sink.SinkRecord;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Puts records on the dead-letter topic, and is certain that they are there. Connect drops the
 * failure of a record that its producer refuses at once, and returns a future that is done, as if
 * the record had been sent. So only a future that was not done at first is a proof.
 */
public final class DeadLetters implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(DeadLetters.class);

  /** A future that is done at once can also be that of a very quick answer: a few in a row not. */
  private static final int TRIES = 3;

  /**
   * The records that wait for their acknowledgements together. The time in which the producer has
   * to deliver them begins for all at the same moment, and it can send large ones only singly.
   */
  private static final int AT_ONCE = 10;

  private final ErrantRecordReporter reporter;
  private final String topic;
  private final Duration patience;

  /** The producer of Connect waits without an end for a topic that does not exist. */
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(DaemonThreadFactory.named("jopenshowvar-dead-letters"));

  /**
   * Creates an object that reports to Connect.
   *
   * @param topic the name of the dead-letter topic, for messages
   * @param patience the longest wait for the acknowledgements of some records
   */
  public DeadLetters(ErrantRecordReporter reporter, String topic, Duration patience) {
    this.reporter = reporter;
    this.topic = topic;
    this.patience = patience;
  }

  /**
   * Puts records on the topic with their reasons, and waits until they are there.
   *
   * @param longest the time after which no more records are put, except the first 10
   * @return the records that are there, which are the first ones; none while no thread can be
   *     started
   * @throws ConnectException if that is not certain
   */
  public List<SinkRecord> put(Map<SinkRecord, Exception> letters, Duration longest) {
    long end = System.nanoTime() + longest.toNanos();
    List<SinkRecord> records = List.copyOf(letters.keySet());
    int number = 0;
    while (number < records.size() && (number == 0 || System.nanoTime() - end < 0)) {
      Map<SinkRecord, Exception> next = new LinkedHashMap<>();
      for (SinkRecord record :
          records.subList(number, Math.min(records.size(), number + AT_ONCE))) {
        next.put(record, brief(Objects.requireNonNull(letters.get(record))));
      }
      Future<Boolean> sent;
      try {
        sent = thread.submit(() -> areSent(next));
      } catch (OutOfMemoryError e) {
        break; // nothing was sent, so that the next call can
      }
      next.forEach(
          (record, why) ->
              LOG.warn(
                  "{}-{}@{}: {}",
                  record.originalTopic(),
                  record.originalKafkaPartition(),
                  record.originalKafkaOffset(),
                  String.valueOf(why.getMessage())));
      await(sent);
      number += next.size();
    }
    return records.subList(0, number);
  }

  private void await(Future<Boolean> sent) {
    try {
      if (!sent.get(patience.toMillis(), TimeUnit.MILLISECONDS)) {
        throw new ConnectException(
            "the dead-letter topic "
                + topic
                + " has refused a record; the log of the worker says why: Could not produce message"
                + " to dead letter queue");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ConnectException("interrupted", e);
    } catch (ExecutionException e) {
      Throwable cause =
          e.getCause() instanceof ExecutionException in ? in.getCause() : e.getCause();
      throw new ConnectException(
          "the dead-letter topic " + topic + " did not take a record: " + cause, e);
    } catch (TimeoutException e) {
      throw new ConnectException(
          "the dead-letter topic "
              + topic
              + " did not take a record within "
              + patience.toMillis()
              + " ms: it does not exist, or its brokers do not answer or are too slow",
          e);
    }
  }

  private boolean areSent(Map<SinkRecord, Exception> letters)
      throws ExecutionException, InterruptedException {
    Map<SinkRecord, Exception> left = letters;
    for (int i = 0; i < TRIES && !left.isEmpty(); i++) {
      left = report(left);
    }
    return left.isEmpty();
  }

  /** Reports records, and returns those of which it is not certain that they are there. */
  private Map<SinkRecord, Exception> report(Map<SinkRecord, Exception> letters)
      throws ExecutionException, InterruptedException {
    Map<SinkRecord, Exception> uncertain = new LinkedHashMap<>();
    List<Future<Void>> acknowledged = new ArrayList<>();
    letters.forEach(
        (record, why) -> {
          Future<Void> future = reporter.report(record, why);
          if (future.isDone()) {
            uncertain.put(record, why);
          }
          acknowledged.add(future);
        });
    for (Future<Void> future : acknowledged) {
      future.get();
    }
    return uncertain;
  }

  /** Returns an exception whose message and causes fit into the headers of a dead letter. */
  private static Exception brief(Exception why) {
    String message = String.valueOf(why.getMessage());
    String shortened = PrintableText.shortened(message);
    if (shortened.equals(message)) {
      return why;
    }
    Exception brief = new ConnectException(shortened);
    brief.setStackTrace(why.getStackTrace());
    return brief;
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }
}
