/** Commands that measure and draw. */
@NullMarked
package no.hials.crosscom.cli.lab;

import org.jspecify.annotations.NullMarked;
