package no.hials.crosscom.lang;

import java.util.Map;

/** The tree of a file: a data list or a module of routines. */
public sealed interface KrlFile permits SourceFile, DataList {

  /** Returns the position of the first {@code DEF}, {@code DEFFCT} or {@code DEFDAT}. */
  Position position();

  /** Returns the name of the {@code DEFDAT} or of the first routine, as written. */
  String name();

  /**
   * Returns the lines that start with {@code &}.
   *
   * @return the text of each key in the order of the file, such as {@code ACCESS} with {@code RVP};
   *     the texts of a repeated key ({@code PARAM}) are joined with line breaks
   */
  Map<String, String> headers();
}
