/**
 * Writes charts to PNG and SVG files. Records describe a chart ({@link
 * no.hials.crosscom.lab.plot.Chart}, its panels and their series); package-private classes draw it.
 *
 * <p>XChart draws the axes of a panel and Batik writes the SVG. This package draws the rest, since
 * XChart restarts dashes at each point, drops a point between two gaps, does not wrap legends, and
 * supports neither several panels in one SVG nor axes with equal scales. Nothing needs a display.
 */
@NullMarked
package no.hials.crosscom.lab.plot;

import org.jspecify.annotations.NullMarked;
