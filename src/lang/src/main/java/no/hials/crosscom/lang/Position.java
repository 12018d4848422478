package no.hials.crosscom.lang;

/**
 * A place in a file.
 *
 * @param file the file's name, as it was given to the parser
 * @param line the line, from 1
 * @param column the column, from 1
 */
public record Position(String file, int line, int column) {
  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
