/** Tests of recordings. */
@NullMarked
package no.hials.crosscom.cell.recording;

import org.jspecify.annotations.NullMarked;
