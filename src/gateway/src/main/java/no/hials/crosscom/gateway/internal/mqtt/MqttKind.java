package no.hials.crosscom.gateway.internal.mqtt;

import java.io.IOException;
import java.math.BigDecimal;
import java.net.URI;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.SettingText;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Output;
import no.hials.crosscom.gateway.OutputKind;
import no.hials.crosscom.gateway.internal.broker.BrokerSettings;
import no.hials.crosscom.gateway.internal.broker.FolderLock;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import org.jspecify.annotations.Nullable;

/** The table {@code mqtt}: an MQTT broker that gets the values of the robots. */
public final class MqttKind implements OutputKind<MqttSettings> {
  private static final String URL = "url";
  private static final String VERSION = "version";
  private static final String CLIENT_ID = "client-id";
  private static final String USER = "user";
  private static final String PASSWORD_FILE = "password-file";
  private static final String CA_FILE = "ca-file";
  private static final String TOPIC = "topic";
  private static final String QOS = "qos";
  private static final String STORE_LIMIT = "store-limit";
  private static final String COMMANDS = "commands";
  private static final String GROUP = "sparkplug-group";
  private static final String NODE = "sparkplug-node";
  private static final long DEFAULT_LIMIT = 100_000_000;
  private static final long LEAST_LIMIT = 100_000;
  private static final Pattern SIZE =
      Pattern.compile("(\\d{1,9}) ?(kB|MB|GB)", Pattern.CASE_INSENSITIVE);

  @Override
  public String table() {
    return "mqtt";
  }

  @Override
  public MqttSettings read(TomlTable table) throws FileException {
    table.allow(
        URL,
        VERSION,
        CLIENT_ID,
        USER,
        PASSWORD_FILE,
        CA_FILE,
        TOPIC,
        QOS,
        STORE_LIMIT,
        COMMANDS,
        GROUP,
        NODE);
    URI url = table.converted(URL, MqttKind::url, TomlTable.TEXT, String.class);
    if (url == null) {
      throw table.error("needs the url of the broker, such as url = \"tcp://broker:1883\"");
    }
    boolean tls = url.getScheme().equals("ssl");
    int port = url.getPort() < 0 ? (tls ? 8883 : 1883) : url.getPort();
    Integer version = whole(table, VERSION);
    if (version != null && version != 3 && version != 5) {
      throw table.error(VERSION, "must be 3 (MQTT 3.1.1) or 5, is " + version);
    }
    Integer qos = whole(table, QOS);
    if (qos != null && (qos < 0 || qos > 2)) {
      throw table.error(QOS, "must be 0, 1 or 2, is " + qos);
    }
    String clientId = table.text(CLIENT_ID);
    if (clientId != null && clientId.isEmpty()) {
      throw table.error(CLIENT_ID, "must not be empty; without it the identifier is random");
    }
    String host = url.getHost().replaceAll("[\\[\\]]", "");
    Long limit = table.converted(STORE_LIMIT, MqttKind::size, TomlTable.TEXT, String.class);
    BrokerSettings broker =
        new BrokerSettings(
            host,
            port,
            tls,
            version == null ? 5 : version,
            clientId,
            table.text(USER),
            passwordFile(table),
            caFile(table, tls),
            limit == null ? DEFAULT_LIMIT : limit);
    String topic = topic(table, TOPIC, true);
    if (topic != null && (topic + "/").startsWith(SparkplugId.NAMESPACE + "/")) {
      throw table.error(
          TOPIC, "must not begin with " + SparkplugId.NAMESPACE + ", the namespace of Sparkplug");
    }
    return new MqttSettings(
        broker,
        topic == null ? "robots" : topic,
        qos == null ? 1 : qos,
        table.flag(COMMANDS),
        sparkplug(table));
  }

  private static @Nullable Integer whole(TomlTable table, String key) throws FileException {
    return table.converted(
        key,
        text -> SettingText.number(text, 0, Integer.MAX_VALUE),
        "must be a whole number, without quotes",
        Integer.class,
        Long.class);
  }

  private static URI url(String text) {
    String shown = text.replaceFirst("^([^:/]*://)?.*@", "$1...@");
    String rule = "must be like tcp://host:1883 or ssl://host:8883, is " + shown;
    URI url;
    try {
      url = URI.create(text);
    } catch (IllegalArgumentException e) {
      // without the cause, which has a password of the text
      throw new IllegalArgumentException(rule);
    }
    boolean known = "tcp".equals(url.getScheme()) || "ssl".equals(url.getScheme());
    boolean rest =
        url.getUserInfo() != null
            || !Objects.requireNonNullElse(url.getPath(), "").isEmpty()
            || url.getQuery() != null
            || url.getFragment() != null;
    if (!known || url.getHost() == null || rest || url.getPort() == 0 || url.getPort() > 65_535) {
      throw new IllegalArgumentException(rule);
    }
    return url;
  }

  private static long size(String text) {
    Matcher matcher = SIZE.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("must be like 500 kB, 100 MB or 2 GB, is " + text);
    }
    int zeros =
        switch (matcher.group(2).toUpperCase(Locale.ROOT)) {
          case "KB" -> 3;
          case "MB" -> 6;
          default -> 9;
        };
    long size = new BigDecimal(matcher.group(1)).scaleByPowerOfTen(zeros).longValueExact();
    if (size < LEAST_LIMIT) {
      throw new IllegalArgumentException("must be 100 kB or more, is " + text);
    }
    return size;
  }

  private static @Nullable Path passwordFile(TomlTable table) throws FileException {
    Path file = table.file(PASSWORD_FILE);
    if (file == null) {
      return null;
    }
    if (!table.has(USER)) {
      throw table.error(PASSWORD_FILE, "needs a user");
    }
    try {
      if (BrokerSettings.password(file).isEmpty()) {
        throw new FileException(file + " has no password");
      }
    } catch (FileException e) {
      throw table.error(PASSWORD_FILE, String.valueOf(e.getMessage()));
    }
    return file;
  }

  private static @Nullable Path caFile(TomlTable table, boolean tls) throws FileException {
    Path file = table.file(CA_FILE);
    if (file == null) {
      return null;
    }
    if (!tls) {
      throw table.error(CA_FILE, "needs a url that begins with ssl://");
    }
    try {
      Object unused = BrokerSettings.trust(file);
    } catch (FileException e) {
      throw table.error(CA_FILE, String.valueOf(e.getMessage()));
    }
    return file;
  }

  /** Returns a text that can be part of a topic; null if it is absent. */
  private static @Nullable String topic(TomlTable table, String key, boolean levels)
      throws FileException {
    String text = table.text(key);
    if (text == null) {
      return null;
    }
    boolean ends = text.isEmpty() || text.startsWith("/") || text.endsWith("/");
    if (ends || text.startsWith("$") || text.matches("(?s).*[+#\\p{Cntrl}].*")) {
      throw table.error(
          key,
          "must not be empty, begin with $ or a slash, end with a slash, or have +, # or a control"
              + " character in it");
    }
    if (!levels && text.contains("/")) {
      throw table.error(key, "must not have a slash in it");
    }
    return text;
  }

  private static @Nullable SparkplugId sparkplug(TomlTable table) throws FileException {
    String group = topic(table, GROUP, false);
    String node = topic(table, NODE, false);
    if (group == null && node == null) {
      return null;
    }
    if (group == null || node == null) {
      throw table.error(GROUP + " and " + NODE + " need each other");
    }
    if (group.equals(SparkplugId.STATE)) {
      throw table.error(GROUP, "must not be STATE, which is the topic of host applications");
    }
    return new SparkplugId(group, node);
  }

  @Override
  public Output open(MqttSettings settings, GatewayContext context) throws IOException {
    Path folder = context.folder().resolve("mqtt-store");
    FolderLock lock = FolderLock.of(folder);
    try {
      return new MqttOutput(settings, context, folder, lock);
    } catch (RuntimeException | Error e) {
      lock.close();
      throw e;
    }
  }
}
