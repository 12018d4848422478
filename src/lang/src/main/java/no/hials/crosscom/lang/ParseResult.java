package no.hials.crosscom.lang;

import java.util.List;
import java.util.Optional;

/**
 * The result of parsing a file.
 *
 * @param file the tree, without the parts that contain errors; empty without any module
 * @param errors the errors in the order of the file; empty if the tree is complete
 */
public record ParseResult(Optional<KrlFile> file, List<KrlError> errors) {}
