/**
 * The page in a real browser: Debian's Chromium, which the profile {@code browser} asks for. Each
 * view of {@code app.js} is checked without being named here.
 */
@NullMarked
package no.hials.crosscom.web.browser;

import org.jspecify.annotations.NullMarked;
