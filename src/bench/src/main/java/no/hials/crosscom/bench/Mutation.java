package no.hials.crosscom.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;

/** A change of one exchange on its way between client and server. */
enum Mutation {
  /** A bit of the id of the answer is flipped. */
  FLIPPED_ID(Effect.FAILS),
  /** A bit of its length is flipped. */
  FLIPPED_LENGTH(Effect.FAILS),
  /** A bit of its function is flipped. */
  FLIPPED_FUNCTION(Effect.FAILS),
  /** A bit of the length of a value, or of the count of values, is flipped. */
  FLIPPED_INNER_LENGTH(Effect.FAILS),
  /** A bit of the tail is flipped, or of the code of one of several values. */
  FLIPPED_CODE(Effect.MAY_REFUSE),
  /** A byte is inserted into the header, where it differs from the next byte. */
  INSERTED_IN_HEADER(Effect.FAILS),
  /** A byte is inserted after the answer. */
  INSERTED_AFTER(Effect.RIGHT_OR_FAILS),
  /** The answer ends early, and the connection with it. */
  CUT_ANSWER(Effect.LOST),
  /** The request ends early, and the connection with it. */
  CUT_REQUEST(Effect.LOST),
  /** The answer ends early, and the connection stays open. */
  TRUNCATED(Effect.FAILS),
  /** The answer comes twice. */
  DUPLICATED(Effect.RIGHT_OR_FAILS),
  /** The answer comes late, but within the time-out. */
  DELAYED(Effect.RIGHT_OR_FAILS),
  /** The answer comes after the time-out, which a busy machine can notice late. */
  LATE(Effect.RIGHT_OR_FAILS),
  /** A bit of a value is flipped. No protocol has a checksum, so it cannot be noticed. */
  FLIPPED_VALUE(Effect.ANY_VALUE),
  /** A byte is inserted into the value, which pushes the last byte of the answer out. */
  INSERTED_IN_VALUE(Effect.ANY_VALUE);

  private static final int FIELDS = Codec.HEADER_LENGTH + 1;

  private final Effect effect;

  Mutation(Effect effect) {
    this.effect = effect;
  }

  Effect effect() {
    return effect;
  }

  /** The places of the fields of an answer. */
  private static final class Places {
    final List<Integer> lengths = new ArrayList<>();
    final List<Integer> codes = new ArrayList<>();
    final List<Integer> values = new ArrayList<>();

    Places(byte[] answer) {
      int end = answer.length - Tail.LENGTH;
      MessageType type = MessageType.from(answer[FIELDS - 1] & 0xFF).orElseThrow();
      boolean several = type == MessageType.READ_MULTIPLE || type == MessageType.WRITE_MULTIPLE;
      boolean wide = several || type == MessageType.READ_UTF16 || type == MessageType.WRITE_UTF16;
      int at = FIELDS;
      if (several) {
        lengths.add(at++);
      }
      while (at < end) {
        if (several) {
          codes.add(at++);
        }
        add(lengths, at, 2);
        int count = (answer[at] & 0xFF) << 8 | (answer[at + 1] & 0xFF);
        int bytes = wide ? 2 * count : count;
        add(values, at + 2, bytes);
        at += 2 + bytes;
      }
      add(codes, end, Tail.LENGTH);
    }

    private static void add(List<Integer> places, int from, int count) {
      for (int i = 0; i < count; i++) {
        places.add(from + i);
      }
    }
  }

  /** Returns whether this can be done to an answer. */
  boolean fits(byte[] answer) {
    boolean inValue = this == FLIPPED_VALUE || this == INSERTED_IN_VALUE;
    return answer.length >= FIELDS + Tail.LENGTH
        && !(inValue && new Places(answer).values.isEmpty());
  }

  /** Returns the bytes to send instead of an answer. */
  byte[] change(byte[] answer, SplittableRandom random) {
    Places places = new Places(answer);
    return switch (this) {
      case FLIPPED_ID -> flip(answer, List.of(0, 1), random);
      case FLIPPED_LENGTH -> flip(answer, List.of(2, 3), random);
      case FLIPPED_FUNCTION -> flip(answer, List.of(FIELDS - 1), random);
      case FLIPPED_INNER_LENGTH -> flip(answer, places.lengths, random);
      case FLIPPED_CODE -> flip(answer, places.codes, random);
      case FLIPPED_VALUE -> flip(answer, places.values, random);
      case INSERTED_IN_HEADER -> insert(answer, random.nextInt(FIELDS), random);
      case INSERTED_IN_VALUE ->
          insert(answer, places.values.get(random.nextInt(places.values.size())), random);
      case INSERTED_AFTER -> insert(answer, answer.length, random);
      case CUT_ANSWER, TRUNCATED -> Arrays.copyOf(answer, random.nextInt(answer.length));
      case DUPLICATED -> {
        byte[] twice = Arrays.copyOf(answer, 2 * answer.length);
        System.arraycopy(answer, 0, twice, answer.length, answer.length);
        yield twice;
      }
      case DELAYED, LATE, CUT_REQUEST -> answer;
    };
  }

  private static byte[] flip(byte[] answer, List<Integer> places, SplittableRandom random) {
    byte[] changed = answer.clone();
    changed[places.get(random.nextInt(places.size()))] ^= (byte) (1 << random.nextInt(8));
    return changed;
  }

  private static byte[] insert(byte[] answer, int at, SplittableRandom random) {
    byte next = at < answer.length ? answer[at] : 0;
    byte[] changed = new byte[answer.length + 1];
    System.arraycopy(answer, 0, changed, 0, at);
    changed[at] = (byte) (next + 1 + random.nextInt(255));
    System.arraycopy(answer, at, changed, at + 1, answer.length - at);
    return changed;
  }
}
