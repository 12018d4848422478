/** Recordings of variables on disk: CSV and JSON Lines, written and read. */
@NullMarked
package no.hials.crosscom.cell.recording;

import org.jspecify.annotations.NullMarked;
