package no.hials.crosscom.gateway.internal.sparkplug;

/**
 * The name of an edge node.
 *
 * @param group the group of nodes
 * @param node the node in its group
 */
public record SparkplugId(String group, String node) {
  /** The first part of all topics of Sparkplug B. */
  public static final String NAMESPACE = "spBv1.0";

  /** The level below it that host applications use in place of a group. */
  public static final String STATE = "STATE";

  /** Returns a topic of the node. */
  String topic(String type) {
    return NAMESPACE + "/" + group + "/" + type + "/" + node;
  }
}
