/**
 * Reads many variables of many robots for other systems: the configuration, the plan of accesses, a
 * feed for each robot, and the writes that are allowed. A feed is the only reader of its robot, and
 * passes on only new values.
 */
@NullMarked
package no.hials.crosscom.cell.feed;

import org.jspecify.annotations.NullMarked;
