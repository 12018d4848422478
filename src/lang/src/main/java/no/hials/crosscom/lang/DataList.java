package no.hials.crosscom.lang;

import java.util.List;
import java.util.Map;

/**
 * A {@code DEFDAT ... ENDDAT}.
 *
 * @param position where it begins
 * @param name its name as written, such as {@code $CONFIG}
 * @param isPublic whether it is {@code PUBLIC}
 * @param headers the lines that start with {@code &}
 * @param declarations types, variables, signals and initial values, in the order of the file
 */
public record DataList(
    Position position,
    String name,
    boolean isPublic,
    Map<String, String> headers,
    List<Declaration> declarations)
    implements KrlFile {}
