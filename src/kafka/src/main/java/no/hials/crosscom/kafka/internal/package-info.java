/** Settings, leases, records and claims of the connectors. */
@NullMarked
package no.hials.crosscom.kafka.internal;

import org.jspecify.annotations.NullMarked;
