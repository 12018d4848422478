/**
 * Recordings of variables on disk: CSV and JSON Lines, written and read. Each row is written at
 * once, and a text cannot be a formula of a spreadsheet unless it is written raw.
 */
@NullMarked
package no.hials.crosscom.cell.recording;

import org.jspecify.annotations.NullMarked;
