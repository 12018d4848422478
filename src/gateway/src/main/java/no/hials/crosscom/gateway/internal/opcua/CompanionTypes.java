package no.hials.crosscom.gateway.internal.opcua;

import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import org.eclipse.milo.opcua.sdk.core.Reference;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.nodes.UaNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaObjectNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaObjectTypeNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaReferenceTypeNode;
import org.eclipse.milo.opcua.sdk.server.nodes.UaVariableNode;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.Variant;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UByte;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;

/**
 * The types of OPC 40010 that robots need, and those of DI below them, with the node ids of
 * docs/reference/opcua.md#types. The page says which of them are assumed.
 */
final class CompanionTypes {
  static final String ROBOTICS_URI = "http://opcfoundation.org/UA/Robotics/";
  static final String DI_URI = "http://opcfoundation.org/UA/DI/";

  /** Assumed, like all ids of DI: docs/reference/opcua.md#assumed. */
  private static final int TOPOLOGY_ELEMENT_TYPE = 1001;

  private static final int COMPONENT_TYPE = 15063;
  private static final int DEVICE_SET = 5001;

  private final StaticNamespace di;
  private final StaticNamespace robotics;
  private final NodeId componentType;

  CompanionTypes(OpcUaServer server) {
    di = new StaticNamespace(server, DI_URI);
    robotics = new StaticNamespace(server, ROBOTICS_URI);
    NodeId topologyElementType =
        type(di, TOPOLOGY_ELEMENT_TYPE, "TopologyElementType", NodeIds.BaseObjectType, true);
    componentType = type(di, COMPONENT_TYPE, "ComponentType", topologyElementType, true);
    deviceSet();
    addTypes();
    addReferenceTypes();
  }

  void startup() {
    di.startup();
    robotics.startup();
  }

  void shutdown() {
    robotics.shutdown();
    di.shutdown();
  }

  private void deviceSet() {
    UaObjectNode node =
        new UaObjectNode(
            di.getNodeContext(),
            deviceSetId(),
            diName("DeviceSet"),
            LocalizedText.english("DeviceSet"),
            LocalizedText.english("The robots"),
            UInteger.MIN,
            UInteger.MIN);
    di.getNodeManager().addNode(node);
    refer(node, NodeIds.HasTypeDefinition, NodeIds.BaseObjectType, true);
    refer(node, NodeIds.Organizes, NodeIds.ObjectsFolder, false);
  }

  private void addTypes() {
    component(1002, "MotionDeviceSystemType");
    component(1003, "ControllerType");
    component(1004, "MotionDeviceType");
    component(1011, "TaskControlType");
    component(1013, "SafetyStateType");
    type(robotics, 1018, "LoadType", NodeIds.BaseObjectType, false);
    component(1019, "MotorType");
    component(1022, "GearType");
    NodeId axis = component(16601, "AxisType");
    member(axis, 16637, "MotionProfile", NodeIds.Enumeration, NodeIds.HasProperty);
    member(axis, 16662, "ActualPosition", NodeIds.Double, NodeIds.HasComponent);
    component(16794, "PowerTrainType");
    type(robotics, 18175, "UserType", NodeIds.BaseObjectType, false);
  }

  private void addReferenceTypes() {
    referenceType(4002, "Controls", "IsControlledBy");
    referenceType(18178, "Moves", "IsMovedBy");
    referenceType(18179, "Requires", "IsRequiredBy");
    referenceType(18180, "IsDrivenBy", "Drives");
    referenceType(18182, "HasSafetyStates", "SafetyStatesOf");
  }

  private NodeId component(int id, String name) {
    return type(robotics, id, name, componentType, false);
  }

  private static NodeId type(
      StaticNamespace namespace, int id, String name, NodeId superType, boolean isAbstract) {
    UaObjectTypeNode node =
        new UaObjectTypeNode(
            namespace.getNodeContext(),
            new NodeId(namespace.getNamespaceIndex(), uint(id)),
            new QualifiedName(namespace.getNamespaceIndex(), name),
            LocalizedText.english(name),
            LocalizedText.NULL_VALUE,
            UInteger.MIN,
            UInteger.MIN,
            isAbstract);
    namespace.getNodeManager().addNode(node);
    refer(node, NodeIds.HasSubtype, superType, false);
    return node.getNodeId();
  }

  /** Adds a variable that each instance of a type has. */
  private void member(NodeId type, int id, String name, NodeId dataType, NodeId reference) {
    UaVariableNode node =
        new UaVariableNode(
            robotics.getNodeContext(),
            new NodeId(robotics.getNamespaceIndex(), uint(id)),
            roboticsName(name),
            LocalizedText.english(name),
            LocalizedText.NULL_VALUE,
            UInteger.MIN,
            UInteger.MIN,
            new DataValue(Variant.NULL_VALUE),
            dataType,
            -1,
            null,
            UByte.valueOf(1),
            UByte.valueOf(1),
            0.0,
            false);
    robotics.getNodeManager().addNode(node);
    boolean property = reference.equals(NodeIds.HasProperty);
    refer(
        node,
        NodeIds.HasTypeDefinition,
        property ? NodeIds.PropertyType : NodeIds.AnalogUnitType,
        true);
    refer(node, NodeIds.HasModellingRule, NodeIds.ModellingRule_Mandatory, true);
    refer(node, reference, type, false);
  }

  /**
   * Adds a reference type, which is assumed not to be hierarchical:
   * docs/reference/opcua.md#assumed.
   */
  private void referenceType(int id, String name, String inverse) {
    UaReferenceTypeNode node =
        new UaReferenceTypeNode(
            robotics.getNodeContext(),
            roboticsId(id),
            roboticsName(name),
            LocalizedText.english(name),
            LocalizedText.NULL_VALUE,
            UInteger.MIN,
            UInteger.MIN,
            false,
            false,
            LocalizedText.english(inverse));
    robotics.getNodeManager().addNode(node);
    refer(node, NodeIds.HasSubtype, NodeIds.NonHierarchicalReferences, false);
  }

  /** Adds a reference between nodes, in both directions. */
  static void refer(UaNode node, NodeId type, NodeId other, boolean forward) {
    node.addReference(new Reference(node.getNodeId(), type, other.expanded(), forward));
  }

  NodeId deviceSetId() {
    return new NodeId(di.getNamespaceIndex(), uint(DEVICE_SET));
  }

  NodeId roboticsId(int id) {
    return new NodeId(robotics.getNamespaceIndex(), uint(id));
  }

  QualifiedName roboticsName(String name) {
    return new QualifiedName(robotics.getNamespaceIndex(), name);
  }

  QualifiedName diName(String name) {
    return new QualifiedName(di.getNamespaceIndex(), name);
  }
}
