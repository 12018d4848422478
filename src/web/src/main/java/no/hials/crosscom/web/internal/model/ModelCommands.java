package no.hials.crosscom.web.internal.model;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.kinematics.ArmGeometry;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import org.jspecify.annotations.Nullable;

/** Sends pages the geometry of a robot: its arm, its place, and the linear unit that carries it. */
public final class ModelCommands {
  private final RobotSessions robots;
  private final ShapeFiles shapes;

  private final Map<RobotSession, Reader> readings = new ConcurrentHashMap<>();

  public ModelCommands(RobotSessions robots, ShapeFiles shapes) {
    this.robots = robots;
    this.shapes = shapes;
  }

  /** Adds the command. */
  public void addTo(Commands commands) {
    commands.add("model", Role.VIEW, this::model);
  }

  private void model(Call call, ObjectNode answer) throws IOException {
    RobotGeometry geometry = geometry(robots.of(call));
    RobotModel model = geometry.model();
    answer.put("name", model.name()).put("note", geometry.note()).put("target", geometry.target());
    ArmGeometry arm = model.geometry();
    answer
        .putObject("lengths")
        .put("a1", arm.a1())
        .put("a2", arm.a2())
        .put("b", arm.b())
        .put("c1", arm.c1())
        .put("c2", arm.c2())
        .put("c3", arm.c3())
        .put("c4", arm.c4());
    ArrayNode axes = answer.putArray("axes");
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      axes.addObject()
          .put("direction", arm.direction().get(axis))
          .put("offset", arm.offset().get(axis))
          .put("minimum", model.minimum(axis))
          .put("maximum", model.maximum(axis));
    }
    answer.set("root", json(geometry.root()));
    RobotGeometry.Rail rail = geometry.rail();
    if (rail != null) {
      ObjectNode json = answer.putObject("rail");
      json.put("minimum", rail.minimum()).put("maximum", rail.maximum());
      json.set("from", json(rail.from()));
      json.set("to", json(rail.to()));
    }
    shapes.links().forEach(answer.putArray("shapes")::add);
  }

  private RobotGeometry geometry(RobotSession robot) throws IOException {
    return readings.computeIfAbsent(robot, Reader::new).read();
  }

  /**
   * Reads the geometry of one robot. It may change at any time, but those who ask while it is being
   * read share the next reading: all pages ask at once after a reconnection.
   */
  private static final class Reader {
    private final RobotSession robot;
    private final AtomicLong begun = new AtomicLong();

    // guarded by this
    private @Nullable RobotGeometry last;
    private @Nullable IOException failure;

    Reader(RobotSession robot) {
      this.robot = robot;
    }

    RobotGeometry read() throws IOException {
      long before = begun.get();
      synchronized (this) {
        if (begun.get() == before) { // no reading has begun since the call
          begun.incrementAndGet();
          last = null;
          failure = null;
          try {
            last =
                RobotGeometry.find(
                    robot.client(), robot.simulation().map(it -> it.controller().model()));
          } catch (IOException e) {
            failure = e;
          }
        }
        if (failure != null) {
          throw failure;
        }
        return Objects.requireNonNull(last);
      }
    }
  }

  private static ObjectNode json(Frame frame) {
    return Json.object()
        .put("X", frame.x())
        .put("Y", frame.y())
        .put("Z", frame.z())
        .put("A", frame.a())
        .put("B", frame.b())
        .put("C", frame.c());
  }
}
