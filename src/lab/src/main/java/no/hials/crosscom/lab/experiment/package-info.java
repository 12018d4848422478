/**
 * The experiments of the papers on a simulated robot: each {@link
 * no.hials.crosscom.lab.experiment.Experiment} runs control loops in real time and returns its
 * measurements as figures, a chart and CSV.
 *
 * <p>The simulated controller is in the same process and loads the programs of {@code krl}, which
 * the build puts into the jar; the control laws and limits are those of {@link
 * no.hials.crosscom.control}. Nothing here reaches a real robot.
 */
@NullMarked
package no.hials.crosscom.lab.experiment;

import org.jspecify.annotations.NullMarked;
