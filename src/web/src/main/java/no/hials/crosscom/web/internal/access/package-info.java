/** The commands by which a browser lets others in, with their QR codes, and sends them away. */
@NullMarked
package no.hials.crosscom.web.internal.access;

import org.jspecify.annotations.NullMarked;
