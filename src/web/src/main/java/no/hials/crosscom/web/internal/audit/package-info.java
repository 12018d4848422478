/** The record of every change that a viewer makes on a robot. */
@NullMarked
package no.hials.crosscom.web.internal.audit;

import org.jspecify.annotations.NullMarked;
