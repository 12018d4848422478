/**
 * Who may load the page, and its files. Every request passes the check of its host first, and all
 * but the link of a new browser need the cookie of a session.
 */
@NullMarked
package no.hials.crosscom.web.internal.http;

import org.jspecify.annotations.NullMarked;
