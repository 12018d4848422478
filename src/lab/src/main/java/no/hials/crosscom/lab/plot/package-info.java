/**
 * Charts as files, PNG or SVG: what is to be seen in records ({@link
 * no.hials.crosscom.lab.plot.Chart}, its panels and their series), and the code that draws them.
 *
 * <p>XChart draws the axes of a panel and Batik writes the SVG. The rest is drawn here, since
 * XChart breaks dashes at each point, drops a point that stands between two gaps, wraps no legend,
 * and has neither several panels in one SVG nor axes of one scale. Nothing needs a display.
 */
@NullMarked
package no.hials.crosscom.lab.plot;

import org.jspecify.annotations.NullMarked;
