/**
 * A simulated KR C4 without a network. {@link no.hials.crosscom.simulator.VariableTable} holds the
 * variables of a KR 6 R900 sixx, with types, access rights and the controller's way of printing;
 * {@link no.hials.crosscom.simulator.Controller} runs KRL programs on them and moves the robot.
 *
 * <p>Where the sources leave a question open, a comment in the code states the assumption.
 */
@NullMarked
package no.hials.crosscom.simulator;

import org.jspecify.annotations.NullMarked;
