package no.hials.crosscom.web.internal.http;

import java.time.Instant;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.web.Role;

/** The session of a browser that used a link. Thread-safe. */
public final class BrowserSession {
  private static final int MAX_PAGES = 32;

  private final int number;
  private final Role role;
  private final String label;
  private final String letInBy;
  private final Instant since;
  private volatile boolean ended;

  /** The tokens of the pages that it loaded; the oldest tokens are forgotten. */
  private final Set<String> pages =
      Collections.newSetFromMap(
          Collections.synchronizedMap(
              new LinkedHashMap<>() {
                private static final long serialVersionUID = 1L;

                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Boolean> eldest) {
                  return size() > MAX_PAGES;
                }
              }));

  /**
   * Creates a session.
   *
   * @param label the name that somebody chose for the browser; may be empty
   * @param letInBy who made the link
   */
  BrowserSession(int number, Role role, String label, String letInBy, Instant since) {
    this.number = number;
    this.role = role;
    this.label = label;
    this.letInBy = letInBy;
    this.since = since;
  }

  /** Returns its number; no other browser gets the same one. */
  public int number() {
    return number;
  }

  /** Returns the rights of the browser. */
  public Role role() {
    return role;
  }

  /** Returns a name for people, such as {@code browser 2} or {@code browser 2 (tablet)}. */
  public String name() {
    return "browser " + number + (label.isEmpty() ? "" : " (" + label + ")");
  }

  /** Returns who made the link that the browser used. */
  public String letInBy() {
    return letInBy;
  }

  /** Returns when the session began. */
  public Instant since() {
    return since;
  }

  /** Ends the session permanently. */
  void end() {
    ended = true;
  }

  /** Returns whether the session has not ended. */
  public boolean isIn() {
    return !ended;
  }

  /** Returns a token for a page that is being loaded: only that page can open a socket with it. */
  String newPage() {
    String token = Tokens.random();
    pages.add(token);
    return token;
  }

  /** Returns whether a page of this browser has this token. */
  public boolean hasPage(String token) {
    return pages.contains(token);
  }
}
