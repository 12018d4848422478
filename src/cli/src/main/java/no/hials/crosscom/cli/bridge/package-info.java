/** Commands that need C3 Bridge, and the search for controllers: programs, files, messages. */
@NullMarked
package no.hials.crosscom.cli.bridge;

import org.jspecify.annotations.NullMarked;
