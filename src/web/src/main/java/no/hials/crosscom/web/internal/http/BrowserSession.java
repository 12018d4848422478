package no.hials.crosscom.web.internal.http;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.web.Role;

/** A browser that came with a link. Thread-safe. */
public final class BrowserSession {
  private static final int MOST_PAGES = 32;

  private final int number;
  private final Role role;

  /** The tokens of the pages it has loaded; the oldest ones are forgotten. */
  private final Set<String> pages =
      Collections.newSetFromMap(
          Collections.synchronizedMap(
              new LinkedHashMap<>() {
                private static final long serialVersionUID = 1L;

                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Boolean> eldest) {
                  return size() > MOST_PAGES;
                }
              }));

  BrowserSession(int number, Role role) {
    this.number = number;
    this.role = role;
  }

  /** Returns the rights of the browser. */
  public Role role() {
    return role;
  }

  /** Returns a name for people, such as {@code browser 2}. */
  public String name() {
    return "browser " + number;
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
