package no.hials.crosscom.protocol.internal;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.server.SystemTime;

/** The layouts of the messages about the server: types 13, 14 and 63. */
final class ServerLayouts {
  /** The bytes of the bit set of features. */
  private static final int FEATURES_LENGTH = 32;

  private ServerLayouts() {}

  static void addTo(Layouts all) {
    all.writer(ServerRequest.class, (m, out) -> {});
    for (MessageType type :
        List.of(MessageType.INFORMATION, MessageType.FEATURES, MessageType.CONFIRM_ALL)) {
      all.request(type, (id, in) -> new ServerRequest(id, type));
    }
    all.answer(
        MessageType.INFORMATION,
        InformationResponse.class,
        (m, out) -> write(m.information(), out),
        (id, in, tail) -> new InformationResponse(id, information(in), tail));
    all.answer(
        MessageType.FEATURES,
        FeaturesResponse.class,
        (m, out) -> write(m.features(), out),
        (id, in, tail) -> new FeaturesResponse(id, features(in), tail));
    all.plainAnswer(MessageType.CONFIRM_ALL);
  }

  private static void write(ServerInformation information, FieldWriter out) {
    out.u8(information.major()).u8(information.minor()).u8(information.build().number());
    write(information.time(), out);
    out.wide(information.computerName());
  }

  private static ServerInformation information(FieldReader in) throws MalformedFrameException {
    return new ServerInformation(
        in.u8("major"),
        in.u8("minor"),
        new Code<>(BuildType.class, in.u8("build")),
        time(in),
        in.wide("computer name"));
  }

  private static void write(SystemTime time, FieldWriter out) {
    out.u16(time.year())
        .u16(time.month())
        .u16(time.dayOfWeek())
        .u16(time.day())
        .u16(time.hour())
        .u16(time.minute())
        .u16(time.second())
        .u16(time.millisecond());
  }

  private static SystemTime time(FieldReader in) throws MalformedFrameException {
    return new SystemTime(
        in.u16("year"),
        in.u16("month"),
        in.u16("day of week"),
        in.u16("day"),
        in.u16("hour"),
        in.u16("minute"),
        in.u16("second"),
        in.u16("millisecond"));
  }

  private static void write(Features features, FieldWriter out) {
    byte[] bytes = new byte[FEATURES_LENGTH];
    for (int type : features.types()) {
      bytes[index(type)] |= (byte) bit(type);
    }
    out.bytes(Bytes.of(bytes));
  }

  private static Features features(FieldReader in) throws MalformedFrameException {
    byte[] bytes = in.bytes(FEATURES_LENGTH, "features").toByteArray();
    Set<Integer> types = new TreeSet<>();
    for (int type = 0; type < 8 * FEATURES_LENGTH; type++) {
      if ((bytes[index(type)] & bit(type)) != 0) {
        types.add(type);
      }
    }
    return new Features(types);
  }

  private static int index(int type) {
    return FEATURES_LENGTH - 1 - type / 8;
  }

  private static int bit(int type) {
    return 1 << type % 8;
  }
}
