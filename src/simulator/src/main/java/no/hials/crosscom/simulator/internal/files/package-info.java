/**
 * The file tree of a simulated controller, as the messages 20 to 30 of C3 Bridge see it: names,
 * rules and error codes in one place, over a store in memory or a folder of this machine. Nothing
 * that a client sends is trusted: names stay within the tree, and contents within a capacity.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.files;

import org.jspecify.annotations.NullMarked;
