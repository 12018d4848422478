/**
 * What only C3 Bridge Interface can do: programs, motions, keys of the pendant, files, and finding
 * servers.
 *
 * <p>There is one class for each field, reached from {@link no.hials.crosscom.CrossComClient}; on
 * KUKAVARPROXY their methods say that the server cannot, before anything is sent. Each operation is
 * one exchange unless it says otherwise, and has a twin that another thread does.
 */
@NullMarked
package no.hials.crosscom.c3;

import org.jspecify.annotations.NullMarked;
