package no.hials.crosscom.gateway.internal.opcua;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Range;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.cell.feed.VariableSettings;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.milo.opcua.sdk.core.Reference;
import org.eclipse.milo.opcua.sdk.server.nodes.UaNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaObjectNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaVariableNode;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.types.UaStructuredType;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.ExtensionObject;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.Variant;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;
import org.eclipse.milo.opcua.stack.core.types.structured.EUInformation;
import org.jspecify.annotations.Nullable;

/** The nodes of one robot: the variables of its plan, and the companion model. */
final class RobotNodes {
  private static final Units UNITS = new Units();

  private final RobotsNamespace namespace;
  private final RobotFeed robot;
  private final GatewayContext context;
  private final List<UaNode> nodes = new CopyOnWriteArrayList<>();
  private final Map<String, Reading> readings = new HashMap<>();

  RobotNodes(RobotsNamespace namespace, RobotFeed robot, GatewayContext context) {
    this.namespace = namespace;
    this.robot = robot;
    this.context = context;
    String name = robot.name();
    UaObjectNode system =
        object(
            name,
            namespace.types().deviceSetId(),
            namespace.name(name),
            namespace.types().roboticsId(1002));
    UaObjectNode folder =
        object(
            name + "/Variables",
            system.getNodeId(),
            namespace.name("Variables"),
            NodeIds.FolderType);
    robot
        .plan()
        .variables()
        .values()
        .forEach(
            variable ->
                readings.put(
                    variable.key(),
                    new Reading(
                        name,
                        variable,
                        (own, label, parent, reading, part) ->
                            variableNode(
                                own, label, parent == null ? folder : parent, reading, part))));
    new RobotModel(this, namespace.types(), system).build();
  }

  RobotFeed robot() {
    return robot;
  }

  /** Keeps an update. */
  void put(Update update) {
    Reading reading = readings.get(update.variable().key());
    if (reading != null) {
      reading.put(update);
    }
  }

  /** Returns the reading of a variable; null if it is not read. */
  @Nullable Reading reading(String variable) {
    return readings.get(variable.toUpperCase(Locale.ROOT));
  }

  /** Returns the node of a variable, or of a field that is read with its structure. */
  private ValueNode variableNode(
      String name,
      String label,
      UaNode parent,
      Reading reading,
      UnaryOperator<@Nullable KrlValue> part) {
    NodeId id = namespace.id(robot.name() + ":" + name);
    if (namespace.node(id) instanceof ValueNode existing) {
      // the plan also reads the field on its own
      CompanionTypes.refer(existing, NodeIds.HasComponent, parent.getNodeId(), false);
      return existing;
    }
    ValueNode node =
        new ValueNode(
            namespace.getNodeContext(),
            id,
            namespace.name(label),
            NodeIds.BaseDataType,
            reading,
            part,
            UaValues::toUa,
            new VariableAccess(name, reading.variable()));
    add(node, NodeIds.BaseDataVariableType, NodeIds.HasComponent, parent.getNodeId());
    return node;
  }

  /** The current settings of a variable. */
  private final class VariableAccess implements ValueNode.Access {
    private final String name;
    private final PlannedVariable planned;

    VariableAccess(String name, PlannedVariable planned) {
      this.name = name;
      this.planned = planned;
    }

    @Override
    public String robot() {
      return robot.name();
    }

    @Override
    public String variable() {
      return name;
    }

    @Override
    public boolean isWritable() {
      VariableSettings settings = context.plant().settings(name);
      return settings != null && settings.writable() && robot.plan().robot().readOnlyBy() == null;
    }

    @Override
    public void describe(ValueNode node) {
      if (!node.isNumber()) {
        return;
      }
      VariableSettings settings = context.plant().settings(name);
      String unit =
          settings == null || settings.unit() == null ? planned.unit(UNITS, name) : settings.unit();
      RobotNodes.this.describe(node, unit, settings == null ? null : settings.range());
    }
  }

  /** Adds the unit and the range to a node. */
  void describe(UaVariableNode node, String unit, @Nullable Range range) {
    EUInformation information = UaValues.unit(unit);
    if (information != null) {
      property(node, "EngineeringUnits", NodeIds.EUInformation, information);
    }
    if (range != null) {
      property(
          node,
          "EURange",
          NodeIds.Range,
          new org.eclipse.milo.opcua.stack.core.types.structured.Range(range.low(), range.high()));
    }
    if (information != null || range != null) {
      node.removeReference(typeOf(node, NodeIds.BaseDataVariableType));
      node.addReference(
          typeOf(node, range == null ? NodeIds.AnalogUnitType : NodeIds.AnalogItemType));
    }
  }

  private static Reference typeOf(UaNode node, NodeId type) {
    return new Reference(node.getNodeId(), NodeIds.HasTypeDefinition, type.expanded(), true);
  }

  private void property(UaVariableNode owner, String name, NodeId type, UaStructuredType value) {
    NodeId id = namespace.id(owner.getNodeId().getIdentifier() + "/" + name);
    if (namespace.node(id) != null) {
      return;
    }
    UaVariableNode node =
        new UaVariableNode(
            namespace.getNodeContext(),
            id,
            new QualifiedName(0, name),
            LocalizedText.english(name),
            LocalizedText.NULL_VALUE,
            UInteger.MIN,
            UInteger.MIN);
    node.setDataType(type);
    node.setValue(new DataValue(new Variant(ExtensionObject.encode(namespace.encoding(), value))));
    add(node, NodeIds.PropertyType, NodeIds.HasProperty, owner.getNodeId());
  }

  /** Adds an object. */
  UaObjectNode object(String id, NodeId parent, QualifiedName name, NodeId type) {
    UaObjectNode node =
        new UaObjectNode(
            namespace.getNodeContext(),
            namespace.id(id),
            name,
            LocalizedText.english(name.name()),
            LocalizedText.NULL_VALUE,
            UInteger.MIN,
            UInteger.MIN);
    add(node, type, NodeIds.HasComponent, parent);
    return node;
  }

  /** Adds a variable of the companion model. */
  ValueNode value(
      UaNode parent,
      QualifiedName name,
      NodeId dataType,
      boolean property,
      @Nullable Reading reading,
      UnaryOperator<@Nullable KrlValue> part,
      Function<KrlValue, @Nullable Object> conversion) {
    ValueNode node =
        new ValueNode(
            namespace.getNodeContext(),
            namespace.id(parent.getNodeId().getIdentifier() + "/" + name.name()),
            name,
            dataType,
            reading,
            part,
            conversion,
            ValueNode.Access.READ_ONLY);
    add(
        node,
        property ? NodeIds.PropertyType : NodeIds.BaseDataVariableType,
        property ? NodeIds.HasProperty : NodeIds.HasComponent,
        parent.getNodeId());
    return node;
  }

  private void add(UaNode node, NodeId type, NodeId reference, NodeId parent) {
    node.addReference(typeOf(node, type));
    CompanionTypes.refer(node, reference, parent, false);
    nodes.add(node);
    namespace.add(node);
  }

  /** Removes all nodes. */
  void remove() {
    nodes.forEach(namespace::remove);
  }
}
