/** The data of a robot for the 3-D view: its geometry, its limits and the shapes of its links. */
@NullMarked
package no.hials.crosscom.web.internal.model;

import org.jspecify.annotations.NullMarked;
