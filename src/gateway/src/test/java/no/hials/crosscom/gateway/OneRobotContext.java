package no.hials.crosscom.gateway;

import java.nio.file.Path;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Writes;
import org.jspecify.annotations.Nullable;

/** The parts of a gateway with one robot. */
public record OneRobotContext(Plant plant, RobotFeed robot, Path folder, Health health)
    implements GatewayContext {
  @Override
  public @Nullable RobotFeed robot(String name) {
    return name.equals(robot.name()) ? robot : null;
  }

  @Override
  public Writes writes() {
    return new Writes(new AuditLog(folder));
  }
}
