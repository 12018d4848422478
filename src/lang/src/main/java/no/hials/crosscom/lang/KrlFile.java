package no.hials.crosscom.lang;

import java.util.Map;

/** The tree of a file: a data list, or a module of routines. */
public sealed interface KrlFile permits SourceFile, DataList {

  /**
   * Gives the place of the beginning.
   *
   * @return where its first declaration stands
   */
  Position position();

  /**
   * Gives the name of the module: of the {@code DEFDAT}, or of the first routine.
   *
   * @return the name as written
   */
  String name();

  /**
   * Gives the lines that begin with {@code &}.
   *
   * @return such as {@code ACCESS} with {@code RVP}, in the order of the file; for a key that
   *     stands there several times ({@code PARAM}) the texts with a line break between them
   */
  Map<String, String> headers();
}
