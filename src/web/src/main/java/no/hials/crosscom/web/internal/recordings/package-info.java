/** Makes, lists, downloads and replays recordings on the computer of the server. */
@NullMarked
package no.hials.crosscom.web.internal.recordings;

import org.jspecify.annotations.NullMarked;
