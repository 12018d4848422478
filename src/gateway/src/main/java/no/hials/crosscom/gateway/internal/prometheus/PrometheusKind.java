package no.hials.crosscom.gateway.internal.prometheus;

import java.io.IOException;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.HostAndPort;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Output;
import no.hials.crosscom.gateway.OutputKind;

/** The table {@code prometheus}: an endpoint for Prometheus. */
public final class PrometheusKind implements OutputKind<HostAndPort> {
  private static final int PORT = 9464;
  private static final String ADDRESS = "address";

  @Override
  public String table() {
    return "prometheus";
  }

  @Override
  public HostAndPort read(TomlTable table) throws FileException {
    table.allow(ADDRESS);
    HostAndPort address =
        table.converted(
            ADDRESS, text -> HostAndPort.listening(text, PORT), TomlTable.TEXT, String.class);
    return address == null ? new HostAndPort("127.0.0.1", PORT) : address;
  }

  @Override
  public Output open(HostAndPort settings, GatewayContext context) throws IOException {
    return new PrometheusOutput(settings, context.health());
  }
}
