package no.hials.crosscom.lang;

import java.util.List;
import java.util.Optional;

/**
 * What came of parsing a file.
 *
 * @param file the tree of all that was understood; nothing if not even a module was found
 * @param errors what is wrong, in the order of the file; empty if the tree is whole
 */
public record ParseResult(Optional<KrlFile> file, List<KrlError> errors) {}
