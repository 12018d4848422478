/**
 * The messages about the files of the controller: directories, properties, copies and content.
 *
 * <p>Only C3 Bridge knows them. A file's content is written and read in parts, each part with a
 * message of its own.
 */
@NullMarked
package no.hials.crosscom.protocol.file;

import org.jspecify.annotations.NullMarked;
