package no.hials.crosscom.gateway.internal.mqtt;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The topics under which a broker retains values of this gateway. They are kept in a file, so that
 * a later run can delete those that it does not use. Not thread-safe.
 *
 * <p>The first line of the file is the address of the broker, each other line is a topic. The
 * topics at another broker are forgotten.
 */
final class RetainedTopics {
  private static final Logger LOG = LoggerFactory.getLogger(RetainedTopics.class);

  private final Path file;
  private final String broker;
  private final Set<String> topics = new LinkedHashSet<>();
  private boolean isRead;
  private boolean isChanged;
  private boolean failing;

  /** Reads the topics of an earlier run. */
  RetainedTopics(Path file, String broker) {
    this.file = file;
    this.broker = broker;
    save();
  }

  /** Adds a topic. */
  void add(String topic) {
    isChanged |= topics.add(topic);
  }

  /** Removes a topic. */
  void remove(String topic) {
    isChanged |= topics.remove(topic);
  }

  /** Returns the topics that are not in a set. */
  List<String> without(Set<String> used) {
    return topics.stream().filter(topic -> !used.contains(topic)).toList();
  }

  /** Writes the file if the topics have changed. After a failure, the next call tries it again. */
  void save() {
    try {
      if (!isRead) {
        read();
        isRead = true; // only now, since an unread file must not be replaced
      }
      if (isChanged) {
        write();
        isChanged = false;
      }
      failing = false;
    } catch (IOException e) {
      if (!failing) {
        LOG.warn(
            "cannot keep {}, so values of removed robots may stay in the broker: {}",
            file,
            e.toString());
      }
      failing = true;
    }
  }

  private void read() throws IOException {
    try {
      List<String> lines = Files.readAllLines(file);
      if (!lines.isEmpty() && lines.get(0).equals(broker)) {
        topics.addAll(lines.subList(1, lines.size()));
      }
    } catch (NoSuchFileException e) {
      // the first run
    } catch (CharacterCodingException e) {
      LOG.warn("{} is damaged: values of removed robots may stay in the broker", file);
    }
  }

  private void write() throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add(broker);
    lines.addAll(topics);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Path part = file.resolveSibling(file.getFileName() + ".part");
    Files.write(part, lines);
    Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
  }
}
