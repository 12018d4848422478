package no.hials.crosscom.lang;

/**
 * A position in a file.
 *
 * @param file the name of the file, as passed to the parser
 * @param line the line, from 1
 * @param column the column, from 1
 */
public record Position(String file, int line, int column) {
  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
