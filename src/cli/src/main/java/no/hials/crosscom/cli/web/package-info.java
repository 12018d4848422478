/** The command that starts the web page. Nothing of the page is loaded by other commands. */
@NullMarked
package no.hials.crosscom.cli.web;

import org.jspecify.annotations.NullMarked;
