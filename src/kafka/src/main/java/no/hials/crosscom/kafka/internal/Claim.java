package no.hials.crosscom.kafka.internal;

import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A claim, as the metadata of a committed offset has it.
 *
 * @param owner the task, and the number of its claim
 * @param from the first record that is not settled
 * @param to the end of the records that may have been tried
 * @param settled the records after {@code from} that are written or reported: their beginnings and
 *     ends
 */
record Claim(String owner, long from, long to, NavigableMap<Long, Long> settled) {
  /** The brokers accept 4096 characters (offset.metadata.max.bytes). */
  private static final int LONGEST = 3000;

  private static final Pattern TEXT =
      Pattern.compile("jopenshowvar (\\S+) from (\\d+) to (\\d+)(?: settled([\\d ]+))?");

  private static final Pattern LENGTHS = Pattern.compile(" (\\d+) (\\d+)");

  /** Reads the metadata of an offset; empty if it is not that of a claim. */
  static Optional<Claim> parse(String metadata) {
    Matcher text = TEXT.matcher(metadata);
    if (!text.matches()) {
      return Optional.empty();
    }
    long from = Long.parseLong(text.group(2));
    NavigableMap<Long, Long> settled = new TreeMap<>();
    Matcher lengths = LENGTHS.matcher(text.group(4) == null ? "" : text.group(4));
    long at = from;
    while (lengths.find()) {
      long start = at + Long.parseLong(lengths.group(1));
      at = start + Long.parseLong(lengths.group(2));
      settled.put(start, at);
    }
    return Optional.of(new Claim(text.group(1), from, Long.parseLong(text.group(3)), settled));
  }

  /** Returns this claim, or a longer one without settled records if it is too long for a broker. */
  Claim fitting() {
    return print().length() <= LONGEST
        ? this
        : new Claim(owner, from, Math.max(to, settled.lastEntry().getValue()), new TreeMap<>());
  }

  /** Returns the metadata: settled records as lengths, each after the distance from the last. */
  String print() {
    StringBuilder text = new StringBuilder("jopenshowvar " + owner + " from " + from + " to " + to);
    long at = from;
    for (Map.Entry<Long, Long> one : settled.entrySet()) {
      text.append(at == from ? " settled " : " ");
      text.append(one.getKey() - at).append(' ').append(one.getValue() - one.getKey());
      at = one.getValue();
    }
    return text.toString();
  }
}
