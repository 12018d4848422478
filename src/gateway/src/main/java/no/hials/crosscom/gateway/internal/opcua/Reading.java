package no.hials.crosscom.gateway.internal.opcua;

import java.util.Set;
import java.util.concurrent.CopyOnWriteArraySet;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The last update of a variable, and those of its nodes that clients watch. */
final class Reading {
  private static final Logger LOG = LoggerFactory.getLogger(Reading.class);

  private final String robot;
  private final PlannedVariable variable;
  private final ValueBranch branch;
  private final Set<ValueNode> watched = new CopyOnWriteArraySet<>();
  private volatile @Nullable Update last;

  /**
   * Creates a reading.
   *
   * @param branches creates the nodes of the variable
   */
  Reading(String robot, PlannedVariable variable, ValueBranch.Nodes branches) {
    this.robot = robot;
    this.variable = variable;
    this.branch = ValueBranch.whole(variable.name(), this, branches);
  }

  PlannedVariable variable() {
    return variable;
  }

  /** Returns the last update; null before the first one. */
  @Nullable Update last() {
    return last;
  }

  /** Returns the last value, or null. */
  @Nullable KrlValue value() {
    Update update = last;
    return update == null ? null : update.value();
  }

  /** Keeps an update, and passes it on to the nodes that clients watch. */
  synchronized void put(Update update) {
    KrlValue value = update.value();
    if (value != null) {
      branch.fit(value);
    }
    last = update;
    if (update.quality() == Quality.BAD) {
      LOG.warn("{}: {} has no value: {}", robot, variable.name(), update.reason());
    }
    for (ValueNode node : watched) {
      node.push();
    }
  }

  /** Adds or removes a node that clients watch. */
  void watch(ValueNode node, boolean on) {
    if (on) {
      watched.add(node);
    } else {
      watched.remove(node);
    }
  }
}
