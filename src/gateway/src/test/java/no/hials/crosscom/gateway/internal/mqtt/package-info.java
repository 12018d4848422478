@NullMarked
package no.hials.crosscom.gateway.internal.mqtt;

import org.jspecify.annotations.NullMarked;
