package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.simulator.VariableTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the geometry that the 3-D view gets: docs/reference/robots.md has the lengths. */
class RobotModelTest {
  @TempDir private Path folder;

  /** Starts a page whose robot is simulated by this process, or by another one as a real robot. */
  private TestPages start(ServerType type, RobotModel robot, boolean real) throws IOException {
    return TestPages.start(
        type,
        folder,
        cfg ->
            cfg.opener(
                (one, client) -> {
                  MockServer server = MockServer.start(it -> it.server(type).robot(robot));
                  RobotConnection connection =
                      RobotConnection.open(one.at(server.host(), server.port()), client);
                  return real ? connection : new RobotConnection(one, connection.client(), server);
                }));
  }

  private static JsonNode model(TestPages pages) throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      JsonNode answer = socket.call("model", "robot", "'mock'");
      assertThat(answer.has("ok")).as(answer.toString()).isTrue();
      return answer.path("ok");
    }
  }

  private static List<Double> lengths(JsonNode model) {
    List<Double> lengths = new ArrayList<>();
    for (String name : List.of("a1", "a2", "b", "c1", "c2", "c3", "c4")) {
      lengths.add(model.path("lengths").path(name).asDouble());
    }
    return lengths;
  }

  private static List<Double> all(JsonNode model, String field) {
    List<Double> values = new ArrayList<>();
    model.path("axes").forEach(axis -> values.add(axis.path(field).asDouble()));
    return values;
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void theModelIsThatOfTheSimulatedRobot(ServerType type) throws Exception {
    try (TestPages pages = TestPages.start(type, folder, cfg -> {})) {
      JsonNode model = model(pages);

      assertThat(model.path("name").asText()).isEqualTo("KR 6 R900 sixx");
      assertThat(model.path("note").asText()).isEmpty();
      assertThat(lengths(model)).containsExactly(25.0, -35.0, 0.0, 400.0, 455.0, 420.0, 80.0);
      assertThat(all(model, "direction")).containsExactly(-1.0, 1.0, 1.0, -1.0, 1.0, -1.0);
      assertThat(all(model, "offset")).containsExactly(0.0, -90.0, 0.0, 0.0, 0.0, 0.0);
      assertThat(all(model, "minimum"))
          .containsExactly(-170.0, -190.0, -120.0, -185.0, -120.0, -350.0);
      assertThat(all(model, "maximum")).containsExactly(170.0, 45.0, 156.0, 185.0, 120.0, 350.0);
      assertThat(model.path("target").asText()).isEqualTo("$AXIS_FOR");
      assertThat(model.has("rail")).isFalse();
      assertThat(model.path("shapes")).isEmpty();
    }
  }

  @ParameterizedTest
  @CsvSource({"C3_BRIDGE, false", "C3_BRIDGE, true", "KUKAVARPROXY, true"})
  void anotherArmIsFoundAlsoByTheNameThatARealControllerShows(ServerType type, boolean real)
      throws Exception {
    try (TestPages pages = start(type, RobotModel.named("KR 210 R2700-2"), real)) {
      JsonNode model = model(pages);

      assertThat(model.path("name").asText()).isEqualTo("KR 210 R2700-2");
      assertThat(model.path("note").asText()).isEmpty();
      assertThat(lengths(model)).containsExactly(330.0, -115.0, 0.0, 645.0, 1150.0, 1220.0, 215.0);
      assertThat(model.path("target").asText()).isEqualTo("$AXIS_FOR");
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aRobotAndLimitsThatHaveChangedAreReadAgain(ServerType type) throws Exception {
    try (TestPages pages = TestPages.startRemote(type, folder, cfg -> {})) {
      assertThat(all(model(pages), "maximum").get(0)).isEqualTo(170);

      pages.controller().variables().set("$SOFTP_END[1]", "31.0");
      assertThat(all(model(pages), "maximum").get(0)).isEqualTo(31);

      pages.controller().variables().set("$TRAFONAME[]", "\"#KR10R1100_2 C4 FLR\"");
      assertThat(model(pages).path("name").asText()).isEqualTo("KR 10 R1100-2");
    }
  }

  @Test
  void theHeaderCountsConnectionsSinceAPageMayMissAShortLoss() throws Exception {
    try (TestPages pages = TestPages.startRemote(ServerType.C3_BRIDGE, folder, cfg -> {});
        TestSocket socket = pages.open(Role.VIEW)) {
      JsonNode before = socket.await(it -> it.path("mode").asText().equals("#T1"));

      pages.controller().disconnectClients();

      long count = before.path("connections").asLong();
      socket.await(
          it ->
              it.path("connections").asLong() > count
                  && it.path("connection").asText().equals("connected"));
    }
  }

  /** Starts a page with a robot of another process whose variables are prepared. */
  private TestPages startReal(ServerType type, Consumer<VariableTable> variables)
      throws IOException {
    return TestPages.start(
        type,
        folder,
        cfg ->
            cfg.opener(
                (one, client) -> {
                  MockServer server = MockServer.start(it -> it.server(type));
                  variables.accept(server.variables());
                  return RobotConnection.open(one.at(server.host(), server.port()), client);
                }));
  }

  @Test
  void anUnknownRobotIsShownAsTheDefaultOneWhichIsSaid() throws Exception {
    try (TestPages pages =
        startReal(
            ServerType.C3_BRIDGE,
            variables -> {
              variables.set("$TRAFONAME[]", "\"#KR140R3200PA C4 FLR\"");
              variables.set("$SOFTP_END[1]", "90.0");
              variables.set("$ROBROOT", "{X 100.0,Y 0.0,Z 50.0,A 0.0,B 0.0,C 180.0}");
            })) {
      JsonNode model = model(pages);

      assertThat(model.path("name").asText()).isEqualTo("KR 6 R900 sixx");
      assertThat(model.path("note").asText())
          .isEqualTo(
              "#KR140R3200PA C4 FLR is not known, so the picture is that of a KR 6 R900 sixx");
      assertThat(all(model, "maximum").get(0)).isEqualTo(90);
      assertThat(model.path("root").path("X").asDouble()).isEqualTo(100);
      assertThat(model.path("root").path("C").asDouble()).isEqualTo(180);
    }
  }

  @Test
  void valuesOfWrongTypesAreAsMissingOnes() throws Exception {
    try (TestPages pages =
        startReal(
            ServerType.KUKAVARPROXY,
            variables -> {
              variables.remove("$EX_AX_NUM");
              variables.declare("$EX_AX_NUM", "BOOL", "TRUE");
              variables.declareStruc("STRUC ODD BOOL X,Y");
              variables.remove("$ROBROOT");
              variables.declare("$ROBROOT", "ODD", "{X TRUE,Y FALSE}");
            })) {
      JsonNode model = model(pages);

      assertThat(model.has("rail")).isFalse();
      assertThat(model.path("root").path("X").asDouble()).isZero();
    }
  }

  @Test
  void theModelNameCountsWhereThereIsNoTrafoName() throws Exception {
    try (TestPages pages =
        startReal(
            ServerType.KUKAVARPROXY,
            variables -> {
              variables.remove("$TRAFONAME");
              variables.remove("$AXIS_FOR");
              variables.set("$MODEL_NAME[]", "\"#KR10R1100_2 C4 CLG\"");
            })) {
      JsonNode model = model(pages);

      assertThat(model.path("name").asText()).isEqualTo("KR 10 R1100-2");
      assertThat(model.path("target").asText()).isNotEqualTo("$AXIS_FOR");
    }
  }

  @Test
  void aLinearUnitCarriesTheRobotFromItsLeastToItsLargestPosition() throws Exception {
    try (TestPages pages =
        startReal(
            ServerType.C3_BRIDGE,
            table -> {
              table.declare("$EX_KIN", "EX_KIN", "{ET1 #ERSYS,ET2 #NONE}");
              // Z of its frame is X of the world, and the robot stands upright
              table.declare("$ET1_TA1KR", "FRAME", "{X 0.0,Y 0.0,Z 500.0,A 0.0,B 90.0,C 0.0}");
              table.declare("$ET1_TFLA3", "FRAME", "{X 0.0,Y 0.0,Z 0.0,A 0.0,B -90.0,C 0.0}");
              table.set("$EX_AX_NUM", "1");
              table.set("$AXIS_TYPE[7]", "1");
              table.set("$SOFTN_END[7]", "-500.0");
              table.set("$SOFTP_END[7]", "3000.0");
            })) {
      JsonNode rail = model(pages).path("rail");

      assertThat(rail.path("minimum").asDouble()).isEqualTo(-500);
      assertThat(rail.path("from").path("X").asDouble()).isCloseTo(-500, within(1e-9));
      assertThat(rail.path("to").path("X").asDouble()).isCloseTo(3000, within(1e-9));
      assertThat(rail.path("to").path("Z").asDouble()).isCloseTo(500, within(1e-9));
      assertThat(rail.path("to").path("B").asDouble()).isCloseTo(0, within(1e-9));
    }
  }

  @Test
  void shapesOfLinksAreServedFromTheirFolder() throws Exception {
    Path shapes = Files.createDirectory(folder.resolve("shapes"));
    Files.writeString(shapes.resolve("a2.stl"), "solid a2\nendsolid a2\n");
    Files.writeString(shapes.resolve("other.stl"), "another file");
    try (TestPages pages =
        TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.shapes(shapes))) {
      assertThat(model(pages).path("shapes").toString()).isEqualTo("[\"a2\"]");

      HttpResponse<String> answer =
          pages.get(pages.at("/shapes/a2.stl"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(200);
      assertThat(answer.headers().firstValue("content-type")).hasValue("model/stl");
      assertThat(answer.body()).isEqualTo("solid a2\nendsolid a2\n");
      assertThat(pages.get(pages.at("/shapes/a2.stl")).statusCode()).isEqualTo(403);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/shapes/other.stl",
        "/shapes/a1.stl",
        "/shapes/a2",
        "/shapes/",
        "/shapes/..%2fsecret.stl",
        "/shapes/%2e%2e/secret.stl"
      })
  void nothingElseOfTheDiskIsServed(String path) throws Exception {
    Path shapes = Files.createDirectory(folder.resolve("shapes"));
    Files.writeString(folder.resolve("secret.stl"), "another file");
    Files.writeString(shapes.resolve("other.stl"), "another file");
    try (TestPages pages =
        TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.shapes(shapes))) {
      HttpResponse<String> answer = pages.get(pages.at(path), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isIn(400, 404);
      assertThat(answer.body()).doesNotContain("another file");
    }
  }

  @Test
  void anOversizedShapeIsRefusedWithItsSize() throws Exception {
    Path shapes = Files.createDirectory(folder.resolve("shapes"));
    Files.write(shapes.resolve("a1.stl"), new byte[8 * 1024 * 1024 + 1]);
    try (TestPages pages =
        TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.shapes(shapes))) {
      HttpResponse<String> answer =
          pages.get(pages.at("/shapes/a1.stl"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(413);
      assertThat(answer.body()).contains("8388608", "8388609");
    }
  }
}
