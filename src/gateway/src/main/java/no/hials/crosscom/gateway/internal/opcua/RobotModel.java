package no.hials.crosscom.gateway.internal.opcua;

import java.util.function.Function;
import java.util.function.UnaryOperator;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.milo.opcua.sdk.server.nodes.UaNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaObjectNode;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.jspecify.annotations.Nullable;

/**
 * The companion model of one robot (docs/reference/opcua.md#a-robot). A value whose variable the
 * plan does not read has the status Bad_NotSupported.
 */
final class RobotModel {
  private static final int AXES = 6;

  private final RobotNodes nodes;
  private final CompanionTypes types;
  private final UaObjectNode system;

  RobotModel(RobotNodes nodes, CompanionTypes types, UaObjectNode system) {
    this.nodes = nodes;
    this.types = types;
    this.system = system;
  }

  void build() {
    UaObjectNode motionDevice = motionDevice();
    UaObjectNode safetyState = safetyState();
    UaObjectNode controller = controller();
    refer(controller, 4002, motionDevice);
    refer(controller, 18182, safetyState);
  }

  private UaObjectNode motionDevice() {
    UaObjectNode device = part(folder(system, "MotionDevices"), "Robot", 1004);
    // docs/reference/system-variables.md#machine-data
    nameplate(device, "$MODEL_NAME[]", "$KR_SERIALNO");
    property(device, types.roboticsName("MotionDeviceCategory"), NodeIds.Enumeration, null);
    UaObjectNode parameters = parameters(device);
    // docs/reference/system-variables.md#override-and-speed
    nodes.describe(
        value(parameters, "SpeedOverride", NodeIds.Double, "$OV_PRO", RobotModel::number),
        "%",
        null);
    // docs/reference/system-variables.md#all
    value(parameters, "OnPath", NodeIds.Boolean, "$ON_PATH", value -> truth(value, false));
    UaObjectNode axes = folder(device, "Axes");
    UaObjectNode powerTrains = folder(device, "PowerTrains");
    for (int i = 1; i <= AXES; i++) {
      UaObjectNode axis = axis(axes, i);
      UaObjectNode train = powerTrain(powerTrains, i);
      refer(train, 18178, axis);
      refer(axis, 18179, train);
    }
    return device;
  }

  private UaObjectNode axis(UaObjectNode axes, int number) {
    UaObjectNode axis = part(axes, "A" + number, 16601);
    property(axis, types.roboticsName("MotionProfile"), NodeIds.Enumeration, null);
    // docs/reference/system-variables.md#position-and-motion: measured, else commanded
    String variable =
        nodes.reading("$AXIS_ACT_MEAS") != null
                || nodes.reading("$AXIS_ACT_MEAS.A" + number) != null
            ? "$AXIS_ACT_MEAS"
            : "$AXIS_ACT";
    // a linear axis is in mm
    nodes.describe(
        value(
            parameters(axis),
            "ActualPosition",
            NodeIds.Double,
            variable + ".A" + number,
            RobotModel::number),
        "°",
        null);
    return axis;
  }

  private UaObjectNode powerTrain(UaObjectNode powerTrains, int number) {
    UaObjectNode train = part(powerTrains, "PowerTrain" + number, 16794);
    UaObjectNode motor = part(train, "Motor", 1019);
    nameplate(motor, null, null);
    // docs/reference/system-variables.md#all
    nodes.describe(
        value(
            parameters(motor),
            "MotorTemperature",
            NodeIds.Double,
            "$MOT_TEMP[" + number + "]",
            RobotModel::number),
        "K",
        null);
    return train;
  }

  private UaObjectNode controller() {
    UaObjectNode controller = part(folder(system, "Controllers"), "Controller", 1003);
    nameplate(controller, null, null);
    UaObjectNode user =
        nodes.object(
            id(controller, "CurrentUser"),
            controller.getNodeId(),
            types.roboticsName("CurrentUser"),
            types.roboticsId(18175));
    // docs/reference/system-variables.md#all: a number from 5 to 30
    property(user, types.roboticsName("Level"), NodeIds.String, "$USER_LEVEL");
    UaObjectNode software = part(folder(controller, "Software"), "System", NodeIds.BaseObjectType);
    property(software, types.diName("SoftwareRevision"), NodeIds.String, "$RCV_INFO[]");
    UaObjectNode task = part(folder(controller, "TaskControls"), "RobotInterpreter", 1011);
    UaObjectNode parameters = parameters(task);
    // docs/reference/system-variables.md#modes-and-programs
    value(parameters, "TaskProgramName", NodeIds.String, "$PRO_NAME1[]", RobotModel::text);
    value(
        parameters,
        "TaskProgramLoaded",
        NodeIds.Boolean,
        "$PRO_STATE1",
        value -> value instanceof KrlEnum state ? !state.name().equals("P_FREE") : null);
    value(parameters, "ProgramState", NodeIds.String, "$PRO_STATE1", RobotModel::text);
    return controller;
  }

  private UaObjectNode safetyState() {
    UaObjectNode state = part(folder(system, "SafetyStates"), "SafetyState", 1013);
    UaObjectNode parameters = parameters(state);
    // docs/reference/system-variables.md#modes-and-programs
    value(
        parameters,
        "OperationalMode",
        NodeIds.Enumeration,
        "$MODE_OP",
        RobotModel::operationalMode);
    // FALSE while a stop is present
    value(parameters, "EmergencyStop", NodeIds.Boolean, "$ALARM_STOP", value -> truth(value, true));
    // docs/reference/system-variables.md#all: FALSE while operator safety, such as the gate, is
    // open
    value(parameters, "ProtectiveStop", NodeIds.Boolean, "$USER_SAF", value -> truth(value, true));
    return state;
  }

  /** Returns the number of a mode in the model: docs/reference/opcua.md#assumed. */
  private static @Nullable Object operationalMode(KrlValue value) {
    if (!(value instanceof KrlEnum mode)) {
      return null;
    }
    return switch (mode.name()) {
      case "T1" -> 1;
      case "T2" -> 2;
      case "AUT" -> 3;
      case "EX" -> 4;
      default -> 0;
    };
  }

  private static @Nullable Object truth(KrlValue value, boolean negated) {
    return value instanceof KrlBool bool ? bool.value() != negated : null;
  }

  private static @Nullable Object number(KrlValue value) {
    return value instanceof KrlInt || value instanceof KrlReal ? value.asDouble() : null;
  }

  private static Object text(KrlValue value) {
    return value instanceof KrlString string ? string.text() : value.print();
  }

  /** Adds the properties that DI defines for each device. */
  private void nameplate(UaObjectNode device, @Nullable String model, @Nullable String serial) {
    property(device, types.diName("Manufacturer"), NodeIds.LocalizedText, null);
    property(device, types.diName("Model"), NodeIds.LocalizedText, model);
    property(device, types.diName("ProductCode"), NodeIds.String, null);
    property(device, types.diName("SerialNumber"), NodeIds.String, serial);
  }

  private void property(UaNode owner, QualifiedName name, NodeId type, @Nullable String variable) {
    Function<KrlValue, @Nullable Object> conversion =
        type.equals(NodeIds.LocalizedText)
            ? value -> LocalizedText.english((String) text(value))
            : RobotModel::text;
    add(owner, name, type, true, variable, conversion);
  }

  private ValueNode value(
      UaNode owner,
      String name,
      NodeId type,
      String variable,
      Function<KrlValue, @Nullable Object> conversion) {
    return add(owner, types.roboticsName(name), type, false, variable, conversion);
  }

  private ValueNode add(
      UaNode owner,
      QualifiedName name,
      NodeId type,
      boolean property,
      @Nullable String variable,
      Function<KrlValue, @Nullable Object> conversion) {
    Reading reading = null;
    UnaryOperator<@Nullable KrlValue> part = value -> value;
    if (variable != null) {
      reading = nodes.reading(variable);
      int dot = variable.indexOf('.');
      int bracket = variable.indexOf('[');
      if (reading == null && dot > 0) {
        reading = nodes.reading(variable.substring(0, dot));
        part = ValueBranch.field(part, variable.substring(dot + 1));
      } else if (reading == null && bracket > 0 && !variable.endsWith("[]")) {
        reading = nodes.reading(variable.substring(0, bracket) + "[]");
        int index = Integer.parseInt(variable, bracket + 1, variable.length() - 1, 10);
        part = ValueBranch.element(part, index - 1);
      }
    }
    return nodes.value(owner, name, type, property, reading, part, conversion);
  }

  private UaObjectNode folder(UaObjectNode owner, String name) {
    return nodes.object(
        id(owner, name), owner.getNodeId(), types.roboticsName(name), NodeIds.FolderType);
  }

  /** Adds the object of DI that holds the variables of another object. */
  private UaObjectNode parameters(UaObjectNode owner) {
    return nodes.object(
        id(owner, "ParameterSet"),
        owner.getNodeId(),
        types.diName("ParameterSet"),
        NodeIds.BaseObjectType);
  }

  private UaObjectNode part(UaObjectNode owner, String name, int type) {
    return part(owner, name, types.roboticsId(type));
  }

  private UaObjectNode part(UaObjectNode owner, String name, NodeId type) {
    return nodes.object(id(owner, name), owner.getNodeId(), types.roboticsName(name), type);
  }

  private static String id(UaObjectNode owner, String name) {
    return owner.getNodeId().getIdentifier() + "/" + name;
  }

  private void refer(UaObjectNode from, int type, UaObjectNode to) {
    CompanionTypes.refer(from, types.roboticsId(type), to.getNodeId(), true);
  }
}
