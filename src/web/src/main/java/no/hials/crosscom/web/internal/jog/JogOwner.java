package no.hials.crosscom.web.internal.jog;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.function.LongSupplier;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.jspecify.annotations.Nullable;

/**
 * Decides which page may jog a robot: one at a time. Another page asks its owner, who answers
 * within 10 s; no answer is a no. The page of the owner shows that it is there; after 5 s without a
 * sign of it, the robot is free.
 *
 * <p>Not thread-safe. It has no threads: it finds expired owners and questions when it is called.
 */
final class JogOwner {
  static final Duration ANSWER = Duration.ofSeconds(10);
  static final Duration PRESENCE = Duration.ofSeconds(5);

  private final LongSupplier nanoTime;
  private @Nullable Person owner;
  private long seen;
  private @Nullable Person asker;
  private long asked;

  /**
   * An open page.
   *
   * @param id its number
   * @param name its name for people
   */
  record Person(long id, String name) {}

  JogOwner(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  /** Returns whether a page is the owner. */
  boolean isOwner(Person person) {
    expire();
    return person.equals(owner);
  }

  /** Called when a page shows that it is there; returns whether it is the owner. */
  boolean see(Person person) {
    boolean is = isOwner(person);
    if (is) {
      seen = nanoTime.getAsLong();
    }
    return is;
  }

  /** Makes a page the owner of a robot that nobody has. */
  void take(Person person) throws CommandException {
    expire();
    if (owner != null && !owner.equals(person)) {
      throw new CommandException(owner.name() + " jogs this robot: ask to take over");
    }
    give(person);
  }

  private void give(Person person) {
    owner = person;
    seen = nanoTime.getAsLong();
    asker = null;
  }

  /** Asks the owner to hand over the robot; takes it if nobody has it. */
  void ask(Person person) throws CommandException {
    expire();
    if (owner == null || person.equals(owner)) {
      take(person);
      return;
    }
    if (asker != null) {
      throw new CommandException(asker.name() + " has already asked " + owner.name());
    }
    asker = person;
    asked = nanoTime.getAsLong();
  }

  /**
   * Answers the question.
   *
   * @param to the page that asked, as the owner saw it
   */
  void answer(Person person, long to, boolean yes) throws CommandException {
    if (!isOwner(person)) {
      throw new CommandException("only the page that jogs the robot can hand it over");
    }
    if (asker == null || asker.id() != to) {
      throw new CommandException("the question is over");
    }
    if (yes) {
      give(asker);
    }
    asker = null;
  }

  /**
   * Ends what a page has here: frees the robot if the page owns it, so that a page that has asked
   * gets it, or withdraws the question of the page.
   *
   * @return whether there was anything to give up
   */
  boolean leave(Person person) {
    expire();
    boolean changed = person.equals(owner) || person.equals(asker);
    if (person.equals(owner)) {
      if (asker != null) {
        give(asker);
      } else {
        owner = null;
      }
    } else if (person.equals(asker)) {
      asker = null;
    }
    return changed;
  }

  private void expire() {
    long now = nanoTime.getAsLong();
    if (asker != null && now - asked > ANSWER.toNanos()) {
      asker = null;
    }
    if (owner != null && now - seen > PRESENCE.toNanos()) {
      if (asker != null) {
        give(asker); // nobody is there who could answer
      } else {
        owner = null;
      }
    }
  }

  /** Adds the owner and the question to an event. */
  void show(ObjectNode event) {
    expire();
    put(event, "owner", owner);
    put(event, "asker", asker);
    event.put(
        "answer_ms",
        asker == null ? 0 : ANSWER.minusNanos(nanoTime.getAsLong() - asked).toMillis());
  }

  private static void put(ObjectNode event, String field, @Nullable Person person) {
    if (person != null) {
      event.putObject(field).put("id", person.id()).put("name", person.name());
    } else {
      event.putNull(field);
    }
  }
}
