/** Changes of simulated robots for teaching, and the lessons of the tutorial. */
@NullMarked
package no.hials.crosscom.web.internal.teach;

import org.jspecify.annotations.NullMarked;
