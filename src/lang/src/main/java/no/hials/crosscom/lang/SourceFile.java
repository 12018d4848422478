package no.hials.crosscom.lang;

import java.util.List;
import java.util.Map;

/**
 * The contents of a {@code .src} or {@code .sub} file.
 *
 * @param position where it begins
 * @param headers the lines that start with {@code &}
 * @param routines at least one; the program that is selected is the first
 */
public record SourceFile(Position position, Map<String, String> headers, List<Routine> routines)
    implements KrlFile {
  @Override
  public String name() {
    return routines.get(0).name();
  }
}
