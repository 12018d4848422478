package no.hials.crosscom.c3;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * One item of a listed directory.
 *
 * @param name the name as the server lists it; a whole path if the list flags made it so
 * @param type what it is, known or not; nothing if the server did not say
 * @param attributes what it is marked with; nothing if the server did not say
 * @param size in bytes; nothing if the server did not say
 * @param info what the server said of it, as it is; empty if nothing
 */
public record FileEntry(
    String name,
    Optional<Code<ItemType>> type,
    Optional<Flags<FileAttribute>> attributes,
    OptionalLong size,
    String info) {

  /**
   * Type, attributes and size, as in c3-vectors.tsv, type 21. The reference does not describe the
   * text; what looks different is left as it is.
   */
  private static final Pattern LONG_INFO = Pattern.compile("(\\d{1,9}),(-?\\d{1,9}),(\\d{1,18})");

  static FileEntry of(String name, String info) {
    Matcher matcher = LONG_INFO.matcher(info);
    if (!matcher.matches()) {
      return new FileEntry(name, Optional.empty(), Optional.empty(), OptionalLong.empty(), info);
    }
    return new FileEntry(
        name,
        Optional.of(new Code<>(ItemType.class, Integer.parseInt(matcher.group(1)))),
        Optional.of(new Flags<>(FileAttribute.class, Integer.parseInt(matcher.group(2)))),
        OptionalLong.of(Long.parseLong(matcher.group(3))),
        info);
  }

  /**
   * Says whether it is known to be a directory, real or virtual.
   *
   * @return true if so; false if the server did not say
   */
  public boolean isDirectory() {
    return type.filter(FileInfo::isDirectory).isPresent();
  }
}
