/** The commands about variables: search, watch, read and write. */
@NullMarked
package no.hials.crosscom.web.internal.variables;

import org.jspecify.annotations.NullMarked;
