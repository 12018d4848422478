/**
 * The parts that every front end needs: named robots ({@code config.toml}), the permission to
 * write, the catalogue of system variables, sampling, and recordings.
 */
@NullMarked
package no.hials.crosscom.cell;

import org.jspecify.annotations.NullMarked;
