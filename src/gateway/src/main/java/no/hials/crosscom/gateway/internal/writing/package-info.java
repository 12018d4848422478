/** The threads on which outputs write to robots for other systems. */
@NullMarked
package no.hials.crosscom.gateway.internal.writing;

import org.jspecify.annotations.NullMarked;
