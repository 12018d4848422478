@NullMarked
package no.hials.crosscom.gateway.internal.broker;

import org.jspecify.annotations.NullMarked;
