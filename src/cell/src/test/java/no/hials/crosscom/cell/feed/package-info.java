@NullMarked
package no.hials.crosscom.cell.feed;

import org.jspecify.annotations.NullMarked;
