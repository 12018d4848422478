package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.internal.data.Storage;
import org.jspecify.annotations.Nullable;

/** Counts the timers up and ends the pulses of outputs, in simulated time. */
final class Timers {
  /**
   * The number of timers of a KR C4 (docs/reference/system-variables.md#inputs-outputs-and-timers).
   */
  private static final int COUNT = 64;

  private record Pulse(int output, boolean level, long end) {}

  private final SystemVariableAccess access;
  private final List<String> timers = new ArrayList<>();
  private final List<String> stops = new ArrayList<>();
  private final List<String> flags = new ArrayList<>();
  private final List<Pulse> pulses = new ArrayList<>();

  /** Whether any timer is counting. */
  private boolean running;

  /** The contents of the variables at the last check; nothing to do while they stay the same. */
  private List<@Nullable Storage> seen = List.of();

  Timers(SystemVariableAccess access) {
    this.access = access;
    for (int i = 1; i <= COUNT; i++) {
      timers.add("$TIMER[" + i + "]");
      stops.add("$TIMER_STOP[" + i + "]");
      flags.add("$TIMER_FLAG[" + i + "]");
    }
  }

  void advance(long now, int millis) {
    List<@Nullable Storage> contents = contents();
    if (running || !contents.equals(seen)) {
      count(millis);
      // read before counting: a client's write since then is found in the next cycle
      seen = contents;
    }
    for (Iterator<Pulse> it = pulses.iterator(); it.hasNext(); ) {
      Pulse pulse = it.next();
      if (pulse.end() <= now) {
        it.remove();
        access.write("$OUT[" + pulse.output() + "]", new KrlBool(!pulse.level()));
      }
    }
  }

  private List<@Nullable Storage> contents() {
    return Arrays.asList(
        access.contents("$TIMER"), access.contents("$TIMER_STOP"), access.contents("$TIMER_FLAG"));
  }

  private void count(int millis) {
    running = false;
    for (int i = 0; i < COUNT; i++) {
      int value = (int) access.number(timers.get(i), 0);
      // without a value a timer is stopped, as on a KR C4 after its start
      if (access.bool(stops.get(i), true)) {
        show(i, value);
        continue;
      }
      running = true;
      // a timer at the end of its range stays there (assumed)
      int next = (int) Math.min(Integer.MAX_VALUE, (long) value + millis);
      access.write(timers.get(i), new KrlInt(next));
      show(i, next);
    }
  }

  private void show(int index, int value) {
    boolean over = value > 0;
    if (access.bool(flags.get(index), over) != over) {
      access.write(flags.get(index), new KrlBool(over));
    }
  }

  /** Sets an output until a time, and returns whether the output exists. */
  boolean pulse(int output, boolean level, long end) {
    // a new pulse replaces an old one at the same output (assumed)
    pulses.removeIf(pulse -> pulse.output() == output);
    boolean there = access.write("$OUT[" + output + "]", new KrlBool(level));
    if (there) {
      pulses.add(new Pulse(output, level, end));
    }
    return there;
  }
}
