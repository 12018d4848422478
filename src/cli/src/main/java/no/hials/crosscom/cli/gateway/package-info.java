/** The command that starts the gateway. */
@NullMarked
package no.hials.crosscom.cli.gateway;

import org.jspecify.annotations.NullMarked;
