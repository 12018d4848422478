/**
 * Operations that only C3 Bridge Interface supports: programs, motions, keys of the pendant, files,
 * and finding servers.
 *
 * <p>{@link no.hials.crosscom.CrossComClient} returns one object for each. On KUKAVARPROXY their
 * methods throw an exception before anything is sent. Each operation is one exchange unless its
 * documentation says otherwise.
 */
@NullMarked
package no.hials.crosscom.c3;

import org.jspecify.annotations.NullMarked;
