package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;

/**
 * Answers a {@link PlainRequest} of type {@link MessageType#INFORMATION} (c3-bridge.md, type 13):
 * {@code major, minor, build, time, computer name}.
 *
 * @param id u16, of the request
 * @param information u8 three times, u16 eight times, WSTRING
 * @param tail how the access ended
 */
public record InformationResponse(int id, ServerInformation information, Tail tail)
    implements TypedResponse {
  static final Layout<InformationResponse> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.u8(m.information.major());
            out.u8(m.information.minor());
            out.u8(m.information.build().number());
            m.information.time().write(out);
            out.putWide(m.information.computerName());
          },
          (id, in, tail) ->
              new InformationResponse(
                  id,
                  new ServerInformation(
                      in.u8("major"),
                      in.u8("minor"),
                      new Code<>(BuildType.class, in.u8("build")),
                      SystemTime.read(in),
                      in.wide("computer name")),
                  tail));

  /** Checks the ranges. */
  public InformationResponse {
    Ranges.u16("id", id);
    Ranges.frame(
        "computer name", 1 + 3 + 8 * 2 + Ranges.wide(information.computerName()) + Tail.LENGTH);
  }

  @Override
  public MessageType type() {
    return MessageType.INFORMATION;
  }
}
