/**
 * Decides who may load the page, and serves its files. Every request first passes the check of its
 * host. All requests but the link of a new browser need the cookie of a session.
 */
@NullMarked
package no.hials.crosscom.web.internal.http;

import org.jspecify.annotations.NullMarked;
