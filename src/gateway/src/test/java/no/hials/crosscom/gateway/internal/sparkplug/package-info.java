@NullMarked
package no.hials.crosscom.gateway.internal.sparkplug;

import org.jspecify.annotations.NullMarked;
