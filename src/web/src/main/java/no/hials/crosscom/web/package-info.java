/**
 * The web page that shows and drives robots, and its server. {@link
 * no.hials.crosscom.web.WebServer} starts it; everything else is internal.
 */
@NullMarked
package no.hials.crosscom.web;

import org.jspecify.annotations.NullMarked;
