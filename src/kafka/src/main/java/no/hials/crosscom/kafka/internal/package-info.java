/**
 * Settings, leases, records and claims of the connectors. A lease decides whether a task may use
 * robots, and a claim whether it may write a record.
 */
@NullMarked
package no.hials.crosscom.kafka.internal;

import org.jspecify.annotations.NullMarked;
