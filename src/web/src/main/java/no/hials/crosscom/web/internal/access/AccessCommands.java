package no.hials.crosscom.web.internal.access;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import io.nayuki.qrcodegen.QrCode;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.BrowserSession;
import no.hials.crosscom.web.internal.http.Tokens;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.RateLimit;
import no.hials.crosscom.web.internal.socket.Sockets;

/** Lets browsers in by one-time links, lists their sessions, and sends them away. */
public final class AccessCommands {
  private static final Pattern LABEL = Pattern.compile("[\\p{L}\\p{N} ._'-]{0,40}");
  private static final double LINKS_PER_SECOND = 0.2;
  private static final int LINKS_IN_A_BURST = 10;

  private final Tokens tokens;
  private final Sockets sockets;
  private final AuditLog audit;
  private final List<String> origins;
  private final boolean loopback;
  private final String fingerprint;
  private final RateLimit rate = new RateLimit(LINKS_PER_SECOND, LINKS_IN_A_BURST);

  /**
   * Creates the commands.
   *
   * @param origins the addresses of the page, the usual one first
   * @param loopback whether only this computer reaches them
   * @param fingerprint the fingerprint of the certificate; empty without TLS
   */
  public AccessCommands(
      Tokens tokens,
      Sockets sockets,
      AuditLog audit,
      List<String> origins,
      boolean loopback,
      String fingerprint) {
    this.tokens = tokens;
    this.sockets = sockets;
    this.audit = audit;
    this.origins = List.copyOf(origins);
    this.loopback = loopback;
    this.fingerprint = fingerprint;
    tokens.atOpen(
        browser -> {
          log(browser.name(), "come in", browser.role() + ", let in by " + browser.letInBy());
          changed();
        });
    sockets.atOpen(
        viewer -> {
          viewer.atClose(this::changed);
          changed();
        });
  }

  private void changed() {
    sockets.broadcast("browsers", Json.event("browsers"));
  }

  private void log(String who, String what, String name) {
    audit.add(new AuditLog.Entry(who, "", what, name, "", "", "done"));
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.addQuick("browsers", Role.VIEW, this::list);
    commands.add("let_in", Role.VIEW, this::letIn);
    commands.add("send_away", Role.OPERATE, (call, answer) -> sendAway(call));
  }

  private void list(Call call, ObjectNode answer) {
    ArrayNode browsers = answer.putArray("browsers");
    for (BrowserSession browser : tokens.browsers()) {
      browsers
          .addObject()
          .put("number", browser.number())
          .put("name", browser.name())
          .put("role", browser.role().name())
          .put("by", browser.letInBy())
          .put("since", browser.since().toEpochMilli())
          .put("pages", sockets.count(browser))
          .put("own", browser == call.viewer().browser())
          .put("may_send_away", maySendAway(call, browser));
    }
    origins.forEach(answer.putArray("addresses")::add);
    answer.put("loopback", loopback).put("fingerprint", fingerprint);
  }

  private void letIn(Call call, ObjectNode answer) throws CommandException {
    Role role = role(call.text("role"));
    String label = call.text("name").strip();
    String origin = call.text("address");
    if (!LABEL.matcher(label).matches()) {
      throw new CommandException("a name has at most 40 letters, digits, blanks and . _ ' -");
    }
    if (!origins.contains(origin)) {
      throw new CommandException("the page has no such address");
    }
    synchronized (rate) {
      if (!rate.take()) {
        throw new CommandException("too many links were made: try again in some seconds");
      }
    }
    String token =
        tokens
            .newLink(role, label, call.viewer().browser())
            .orElseThrow(
                () ->
                    new CommandException(
                        "a browser that may only "
                            + call.viewer().role()
                            + " cannot create a link for "
                            + role));
    log(call.viewer().name(), "let in", role + (label.isEmpty() ? "" : ", for " + label));
    String link = origin + "/?token=" + token;
    answer.put("link", link).put("minutes", Tokens.LINK_TIME.toMinutes());
    addCode(link, answer.putArray("code"));
  }

  private static Role role(String name) throws CommandException {
    return Arrays.stream(Role.values())
        .filter(it -> it.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new CommandException("there is no such role"));
  }

  /** Adds the rows of a QR code, with a 1 for each dark module. */
  private static void addCode(String text, ArrayNode rows) {
    QrCode code = QrCode.encodeText(text, QrCode.Ecc.MEDIUM);
    for (int y = 0; y < code.size; y++) {
      StringBuilder row = new StringBuilder();
      for (int x = 0; x < code.size; x++) {
        row.append(code.getModule(x, y) ? '1' : '0');
      }
      rows.add(row.toString());
    }
  }

  private static boolean maySendAway(Call call, BrowserSession browser) {
    Role own = call.viewer().role();
    return own.includes(Role.OPERATE) && own.includes(browser.role());
  }

  private void sendAway(Call call) throws CommandException {
    int number = (int) call.number("browser", 1, Integer.MAX_VALUE);
    BrowserSession browser =
        tokens.browsers().stream()
            .filter(it -> it.number() == number)
            .findFirst()
            .orElseThrow(() -> new CommandException("there is no such browser any more"));
    if (!maySendAway(call, browser)) {
      throw new CommandException("this browser may do less than " + browser.name());
    }
    tokens.end(browser);
    sockets.end(browser);
    log(call.viewer().name(), "send away", browser.name());
    changed();
  }
}
