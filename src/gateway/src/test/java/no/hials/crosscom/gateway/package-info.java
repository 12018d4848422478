@NullMarked
package no.hials.crosscom.gateway;

import org.jspecify.annotations.NullMarked;
