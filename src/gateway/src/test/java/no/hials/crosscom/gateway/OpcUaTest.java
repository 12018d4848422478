package no.hials.crosscom.gateway;

import static no.hials.crosscom.gateway.OpcUaPlant.await;
import static no.hials.crosscom.gateway.OpcUaPlant.awaitGood;
import static no.hials.crosscom.gateway.OpcUaPlant.children;
import static no.hials.crosscom.gateway.OpcUaPlant.id;
import static no.hials.crosscom.gateway.OpcUaPlant.read;
import static no.hials.crosscom.gateway.OpcUaPlant.robots;
import static no.hials.crosscom.gateway.OpcUaPlant.subscribe;
import static no.hials.crosscom.gateway.OpcUaPlant.write;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.mock.Fault;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.AttributeId;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.ByteString;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.ExtensionObject;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UByte;
import org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn;
import org.eclipse.milo.opcua.stack.core.types.structured.EUInformation;
import org.eclipse.milo.opcua.stack.core.types.structured.HistoryReadRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.HistoryReadValueId;
import org.eclipse.milo.opcua.stack.core.types.structured.Range;
import org.eclipse.milo.opcua.stack.core.types.structured.ReferenceDescription;
import org.junit.jupiter.api.Test;

class OpcUaTest extends OpcUaServerTest {
  private static final UByte READ = UByte.valueOf(1);
  private static final UByte READ_WRITE = UByte.valueOf(3);

  /** The status of nodes that need encryption. */
  private static final long HIDDEN = StatusCodes.Bad_SecurityModeInsufficient;

  @Override
  String config() {
    return cell1()
        + """
    timeout = "1s"

    [limits]
    access-time = "1ms"

    [groups.all]
    variables = ["$OV_PRO", "$POS_ACT", "$AXIS_ACT", "$MODE_OP", "$ALARM_STOP", "$PRO_NAME1[]", "NOSUCH"]
    period = "20ms"

    [variables."$OV_PRO"]
    range = [0, 100]
    write = true

    [variables."$POS_ACT.X"]
    range = [-5000, 5000]
    write = true

    [opcua]
    address = "127.0.0.1:PORT"

    [opcua.users.anna]
    role = "operator"
    password-file = "anna.txt"

    [opcua.users.vera]
    role = "viewer"
    password-file = "vera.txt"
    """;
  }

  private List<String> browse(NodeId from, String namespace, int type) throws UaException {
    return children(client, from, id(client, namespace, type)).stream()
        .map(it -> it.getBrowseName().name())
        .toList();
  }

  private NodeId only(NodeId from, NodeId type, String name) throws UaException {
    return children(client, from, type).stream()
        .filter(it -> it.getBrowseName().name().equals(name))
        .map(it -> it.getNodeId().toNodeId(client.getNamespaceTable()).orElseThrow())
        .findFirst()
        .orElseThrow();
  }

  @Test
  void clientsFindARobotByTheTypesOfTheCompanionModel() throws Exception {
    NodeId devices = id(client, OpcUaPlant.DI, 5001);
    NodeId system = only(devices, id(client, OpcUaPlant.ROBOTICS, 1002), "cell1");
    NodeId motionDevices = only(system, NodeIds.FolderType, "MotionDevices");
    NodeId device = only(motionDevices, id(client, OpcUaPlant.ROBOTICS, 1004), "Robot");
    NodeId axes = only(device, NodeIds.FolderType, "Axes");

    assertThat(children(client, NodeIds.ObjectsFolder, NodeIds.BaseObjectType))
        .extracting(ReferenceDescription::getBrowseName)
        .anyMatch(name -> name.name().equals("DeviceSet"));
    assertThat(browse(axes, OpcUaPlant.ROBOTICS, 16601))
        .containsExactly("A1", "A2", "A3", "A4", "A5", "A6");
    assertThat(browse(only(device, NodeIds.FolderType, "PowerTrains"), OpcUaPlant.ROBOTICS, 16794))
        .hasSize(6);
    assertThat(browse(only(system, NodeIds.FolderType, "Controllers"), OpcUaPlant.ROBOTICS, 1003))
        .containsExactly("Controller");
    assertThat(browse(only(system, NodeIds.FolderType, "SafetyStates"), OpcUaPlant.ROBOTICS, 1013))
        .containsExactly("SafetyState");
  }

  @Test
  void showsTheCompanionModelsValuesThatThePlanReads() throws Exception {
    robot.variables().set("$AXIS_ACT", "{A1 10.5,A2 -90,A3 90,A4 0,A5 0,A6 0}");
    String safety = "cell1/SafetyStates/SafetyState/ParameterSet/";
    NodeId axis = robots(client, "cell1/MotionDevices/Robot/Axes/A1/ParameterSet/ActualPosition");

    await(client, axis, value -> Double.valueOf(10.5).equals(value.value().value()));

    assertThat(
            await(
                    client,
                    robots(client, safety + "OperationalMode"),
                    it -> it.statusCode().isGood())
                .value()
                .value())
        .isEqualTo(1);
    assertThat(read(client, robots(client, safety + "EmergencyStop")).value().value())
        .isEqualTo(false);
    assertThat(read(client, robots(client, safety + "ProtectiveStop")).statusCode().value())
        .as("$USER_SAF is not read")
        .isEqualTo(StatusCodes.Bad_NotSupported);
    assertThat(unit(axis).getUnitId()).isEqualTo(17476); // DD, degree
  }

  private EUInformation unit(NodeId variable) throws UaException {
    return (EUInformation) property(variable, "EngineeringUnits");
  }

  private Object property(NodeId variable, String name) throws UaException {
    NodeId id = only(variable, NodeIds.PropertyType, name);
    ExtensionObject encoded = (ExtensionObject) read(client, id).value().value();
    return encoded.decode(client.getStaticEncodingContext());
  }

  @Test
  void showsVariablesWithTypeUnitRangeAndTimeOfReading() throws Exception {
    // a reading that is under way has begun before the change, and may still have the new value
    Instant before = awaitGood(client, "cell1:$OV_PRO").sourceTime().getJavaInstant();
    robot.variables().set("$OV_PRO", "73");
    NodeId override = robots(client, "cell1:$OV_PRO");

    DataValue value = await(client, override, it -> Integer.valueOf(73).equals(it.value().value()));

    assertThat(value.statusCode().isGood()).isTrue();
    assertThat(value.sourceTime().getJavaInstant()).isBetween(before, Instant.now());
    assertThat(read(client, override, AttributeId.DataType).value().value())
        .isEqualTo(NodeIds.Int32);
    assertThat(property(override, "EURange")).isEqualTo(new Range(0.0, 100.0));
    assertThat(unit(override).getUnitId()).isEqualTo(20529); // P1, percent
    assertThat(awaitGood(client, "cell1:$MODE_OP").value().value()).isEqualTo("#T1");
    assertThat(awaitGood(client, "cell1:$ALARM_STOP").value().value()).isEqualTo(true);
    assertThat(awaitGood(client, "cell1:$POS_ACT.X").value().value()).isInstanceOf(Double.class);
    assertThat(unit(robots(client, "cell1:$POS_ACT.X")).getUnitId()).isEqualTo(5066068); // MMT
    assertThat(awaitGood(client, "cell1:$POS_ACT").value().value().toString())
        .startsWith("{E6POS: X ");
  }

  @Test
  void refusedNamesAreBad() throws Exception {
    DataValue value =
        await(
            client,
            robots(client, "cell1:NOSUCH"),
            it -> it.statusCode().value() == StatusCodes.Bad_ConfigurationError);

    assertThat(value.value().isNull()).isTrue();
  }

  @Test
  void subscriptionsGetEachChangeAndTheLossOfTheRobot() throws Exception {
    awaitGood(client, "cell1:$OV_PRO");
    BlockingQueue<DataValue> values = subscribe(client, robots(client, "cell1:$OV_PRO"));
    assertThat(values.take().value().value()).isEqualTo(100);

    robot.variables().set("$OV_PRO", "42");
    DataValue changed = await(values, it -> Integer.valueOf(42).equals(it.value().value()));
    robot.refuseConnections();
    robot.disconnectClients();
    DataValue stale = await(values, it -> !it.statusCode().isGood());

    assertThat(stale.statusCode().value()).isEqualTo(StatusCodes.Uncertain_LastUsableValue);
    assertThat(stale.value().value()).isEqualTo(42);
    assertThat(stale.sourceTime().getJavaInstant())
        .as("the time of the last reading")
        .isBetween(changed.sourceTime().getJavaInstant(), Instant.now());

    robot.variables().set("$OV_PRO", "43");
    robot.acceptConnections();

    assertThat(await(values, it -> it.statusCode().isGood()).value().value()).isEqualTo(43);
  }

  @Test
  void aRobotThatWasNeverReachedHasNoValues() throws Exception {
    robot.refuseConnections();
    robot.disconnectClients();
    plant.apply(config().replace("cell1", "cell2"));

    DataValue value =
        await(
            client,
            robots(client, "cell2:$OV_PRO"),
            it -> it.statusCode().value() != StatusCodes.Bad_WaitingForInitialData);

    assertThat(value.statusCode().value()).isEqualTo(StatusCodes.Bad_NoCommunication);
    assertThat(value.value().isNull()).isTrue();
  }

  @Test
  void onlyOperatorsWriteAndOnlyWhatIsAllowed() throws Exception {
    awaitGood(client, "cell1:$OV_PRO");
    NodeId override = robots(client, "cell1:$OV_PRO");
    OpcUaClient operator = plant.connect("anna", "of anna");
    OpcUaClient viewer = plant.connect("vera", "of vera");
    try {
      assertThat(write(operator, override, 55)).isEqualTo(StatusCodes.Good);
      await(client, override, it -> Integer.valueOf(55).equals(it.value().value()));

      assertThat(write(operator, override, 101)).isEqualTo(StatusCodes.Bad_OutOfRange);
      assertThat(write(operator, override, "55")).isEqualTo(StatusCodes.Bad_TypeMismatch);
      assertThat(write(operator, override, 55.5)).isEqualTo(StatusCodes.Bad_TypeMismatch);
      assertThat(write(viewer, override, 56)).isEqualTo(StatusCodes.Bad_UserAccessDenied);
      assertThat(write(client, override, 56)).isEqualTo(StatusCodes.Bad_UserAccessDenied);
      assertThat(write(operator, robots(client, "cell1:$MODE_OP"), "#T2"))
          .isIn(StatusCodes.Bad_UserAccessDenied, StatusCodes.Bad_NotWritable);
      assertThat(level(client, override, AttributeId.AccessLevel)).isEqualTo(READ_WRITE);
      assertThat(level(client, override, AttributeId.UserAccessLevel)).isEqualTo(READ);
      assertThat(level(operator, override, AttributeId.UserAccessLevel)).isEqualTo(READ_WRITE);
    } finally {
      operator.disconnect();
      viewer.disconnect();
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("55");
    assertThat(audit()).contains("\"who\":\"opcua:anna\"", "\"after\":\"55\",\"result\":\"done\"");
  }

  @Test
  void nobodyWritesTheNodesOfTheStandard() throws Exception {
    List<NodeId> variables = OpcUaPlant.standardVariables(client);
    NodeId diagnostics = NodeIds.Server_ServerDiagnostics_EnabledFlag;
    assertThat(variables).contains(diagnostics, NodeIds.Server_ServerStatus_CurrentTime);
    OpcUaClient operator = plant.connect("anna", "of anna");
    try {
      for (OpcUaClient one : List.of(client, operator)) {
        assertThat(OpcUaPlant.read(one, variables, AttributeId.UserAccessLevel))
            .filteredOn(it -> it.statusCode().value() != HIDDEN)
            .extracting(it -> it.value().value())
            .containsOnly(READ);
        assertThat(write(one, diagnostics, true)).isEqualTo(StatusCodes.Bad_UserAccessDenied);
      }
    } finally {
      operator.disconnect();
    }
    assertThat(level(client, diagnostics, AttributeId.AccessLevel)).isEqualTo(READ);
    assertThat(read(client, diagnostics).value().value()).isEqualTo(false);
  }

  @Test
  void aNumberThatAVariableCannotHaveIsRefusedWithALineInTheAuditLog() throws Exception {
    awaitGood(client, "cell1:$POS_ACT.X");
    NodeId x = robots(client, "cell1:$POS_ACT.X");
    OpcUaClient operator = plant.connect("anna", "of anna");
    try {
      for (double value : new double[] {1e300, 1e39, Double.POSITIVE_INFINITY, Double.NaN}) {
        assertThat(write(operator, x, value)).isEqualTo(StatusCodes.Bad_OutOfRange);

        assertThat(audit())
            .contains(
                "\"after\":\"" + value + "\",\"result\":\"cell1: $POS_ACT.X was not written: ");
      }
    } finally {
      operator.disconnect();
    }
    assertThat(audit().lines()).hasSize(4).allMatch(it -> it.contains("\"who\":\"opcua:anna\""));
    assertThat(robot.requests()).noneMatch(it -> it.isWrite());
  }

  private static UByte level(OpcUaClient client, NodeId id, AttributeId attribute)
      throws UaException {
    return (UByte) read(client, id, attribute).value().value();
  }

  private String audit() throws IOException {
    return Files.readString(folder.resolve("audit.jsonl"));
  }

  @Test
  void aWriteWithoutAnAnswerTimesOutAndIsNotRepeated() throws Exception {
    awaitGood(client, "cell1:$OV_PRO");
    robot.fault(it -> it.request().toString().contains("value=77"), Fault.dropAnswer());
    OpcUaClient operator = plant.connect("anna", "of anna");
    try {
      assertThat(write(operator, robots(client, "cell1:$OV_PRO"), 77))
          .isEqualTo(StatusCodes.Bad_Timeout);
    } finally {
      operator.disconnect();
    }

    assertThat(robot.requests())
        .filteredOn(it -> it.request().toString().contains("value=77"))
        .hasSize(1);
    assertThat(audit()).contains("the outcome is unknown");
  }

  @Test
  void refusesAWrongPassword() {
    assertThatThrownBy(() -> plant.connect("anna", "of vera"))
        .isInstanceOf(UaException.class)
        .extracting(it -> ((UaException) it).getStatusCode().value())
        .isEqualTo(StatusCodes.Bad_UserAccessDenied);
  }

  @Test
  void aRobotThatComesBackIsWatchedAgain() throws Exception {
    awaitGood(client, "cell1:$OV_PRO");
    BlockingQueue<DataValue> values = subscribe(client, robots(client, "cell1:$OV_PRO"));
    await(values, it -> it.statusCode().isGood());

    plant.apply(config().replace("cell1", "cell2"));

    assertThat(await(values, it -> it.statusCode().isBad()).statusCode().value())
        .isEqualTo(StatusCodes.Bad_NodeIdUnknown);
    assertThat(read(client, robots(client, "cell1:$OV_PRO")).statusCode().value())
        .isEqualTo(StatusCodes.Bad_NodeIdUnknown);
    assertThat(browse(id(client, OpcUaPlant.DI, 5001), OpcUaPlant.ROBOTICS, 1002))
        .containsExactly("cell2");

    plant.apply(config());

    await(values, it -> it.statusCode().isGood());
  }

  @Test
  void aRequestThatMiloDoesNotExpectIsAnswered() throws Exception {
    HistoryReadRequest request =
        new HistoryReadRequest(
            client.newRequestHeader(client.getSession().getAuthenticationToken()),
            ExtensionObject.of(ByteString.NULL_VALUE, NodeId.NULL_VALUE),
            TimestampsToReturn.Both,
            false,
            new HistoryReadValueId[] {
              new HistoryReadValueId(
                  robots(client, "cell1:$OV_PRO"),
                  null,
                  QualifiedName.NULL_VALUE,
                  ByteString.NULL_VALUE)
            });

    for (int i = 0; i < 2; i++) {
      assertThatThrownBy(
              () -> client.getTransport().sendRequestMessage(request).get(10, TimeUnit.SECONDS))
          .cause()
          .isInstanceOfSatisfying(
              UaException.class,
              it ->
                  assertThat(it.getStatusCode().value()).isEqualTo(StatusCodes.Bad_InternalError));
    }
    assertThat(read(client, robots(client, "cell1:$OV_PRO")).statusCode().isGood()).isTrue();
  }
}
