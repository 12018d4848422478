package no.hials.crosscom.gateway.internal.mqtt;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.net.URLDecoder;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The plain topics. The names of variables are in capital letters, so that no variable has the name
 * of one of the gateway's own topics.
 *
 * @param prefix the first part
 */
record Topics(String prefix) {
  private static final String SET = "set";

  /** Returns a name as one level of a topic: characters with a meaning in topics are escaped. */
  private static String level(String name) {
    return name.replace("%", "%25").replace("/", "%2F").replace("+", "%2B").replace("#", "%23");
  }

  /** Returns the topic that tells whether the gateway is connected. */
  String gateway() {
    return prefix + "/gateway/status";
  }

  /** Returns the topic that tells whether a robot is connected. */
  String robot(String robot) {
    return prefix + "/" + level(robot) + "/$status";
  }

  /** Returns the topic of a variable. */
  String variable(String robot, String key) {
    return prefix + "/" + level(robot) + "/" + level(key);
  }

  /** Returns the filter of all commands. */
  String commands() {
    return prefix + "/+/+/" + SET;
  }

  /** Returns the topic of the result of a command. */
  static String result(String commandTopic) {
    return commandTopic + "/result";
  }

  /** Returns robot and variable of a command; null for another topic. */
  @Nullable List<String> target(String topic) {
    if (!topic.startsWith(prefix + "/")) {
      return null;
    }
    String[] levels = topic.substring(prefix.length() + 1).split("/", -1);
    try {
      // the decoder would turn a plus into a space, but level() escapes every plus
      return levels.length == 3 && levels[2].equals(SET)
          ? List.of(URLDecoder.decode(levels[0], UTF_8), URLDecoder.decode(levels[1], UTF_8))
          : null;
    } catch (IllegalArgumentException e) {
      return null;
    }
  }
}
