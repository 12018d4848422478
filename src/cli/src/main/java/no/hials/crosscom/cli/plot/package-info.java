/**
 * Charts as files, PNG or SVG: what is to be seen in records ({@link
 * no.hials.crosscom.cli.plot.Chart}, its panels and their series), and how it is drawn behind them.
 *
 * <p>XChart draws a panel; where panels stand, their legends and the SVG are made here. Nothing
 * needs a display, and text becomes shapes, so that a picture looks the same where its fonts are
 * missing.
 */
@NullMarked
package no.hials.crosscom.cli.plot;

import org.jspecify.annotations.NullMarked;
