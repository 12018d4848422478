/**
 * The files of the simulated controller, as messages 20 to 30 of C3 Bridge serve them: names, rules
 * and error codes, above a store in memory or in a folder of this machine. Nothing from a client is
 * trusted: names stay within the tree, and contents within a capacity.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.files;

import org.jspecify.annotations.NullMarked;
