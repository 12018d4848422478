/** The robots of the page. Each has one connection, and reads what all viewers watch once. */
@NullMarked
package no.hials.crosscom.web.internal.robot;

import org.jspecify.annotations.NullMarked;
