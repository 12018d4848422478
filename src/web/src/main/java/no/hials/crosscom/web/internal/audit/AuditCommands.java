package no.hials.crosscom.web.internal.audit;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;

/** Shows the audit log to pages: its last lines as an answer, further ones as events. */
public final class AuditCommands {
  /** The lines that can wait for a slow page. */
  private static final int MAX_WAITING = 64;

  private final AuditLog audit;
  private final AtomicInteger count = new AtomicInteger();

  public AuditCommands(AuditLog audit, Sockets sockets) {
    this.audit = audit;
    audit.addListener(
        line ->
            sockets.broadcast(
                "audit/" + count.getAndIncrement() % MAX_WAITING,
                Json.event("audit").put("line", line)));
  }

  /** Adds the command. */
  public void addTo(Commands commands) {
    commands.add(
        "audit",
        Role.VIEW,
        (call, answer) -> {
          ArrayNode lines = answer.putArray("lines");
          audit.recent().forEach(lines::add);
        });
  }
}
