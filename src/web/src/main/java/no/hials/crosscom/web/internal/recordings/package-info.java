/** Recordings on the computer of the server: they are made, listed, downloaded and replayed. */
@NullMarked
package no.hials.crosscom.web.internal.recordings;

import org.jspecify.annotations.NullMarked;
