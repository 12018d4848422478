/**
 * The messages about the files of the controller: directories, properties, copies and content.
 *
 * <p>Only C3 Bridge supports them (docs/reference/c3-messages.md#files-20-to-28). The content of a
 * file is written and read in parts, one message a part.
 */
@NullMarked
package no.hials.crosscom.protocol.file;

import org.jspecify.annotations.NullMarked;
