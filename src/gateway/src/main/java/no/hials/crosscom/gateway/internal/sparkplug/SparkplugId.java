package no.hials.crosscom.gateway.internal.sparkplug;

/**
 * The name of an edge node.
 *
 * @param group the group of nodes
 * @param node the node in its group
 */
public record SparkplugId(String group, String node) {
  /** Returns a topic of the node. */
  String topic(String type) {
    return "spBv1.0/" + group + "/" + type + "/" + node;
  }
}
