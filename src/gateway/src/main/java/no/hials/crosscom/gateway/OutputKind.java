package no.hials.crosscom.gateway;

import java.io.IOException;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.TomlTable;

/**
 * A kind of output, with its table in the configuration.
 *
 * @param <S> its settings, equal if nothing has changed
 */
public interface OutputKind<S> {
  /** Returns the name of its table. */
  String table();

  /**
   * Reads the settings.
   *
   * @throws FileException if the table has an error; the message has its line and the rule
   */
  S read(TomlTable table) throws FileException;

  /**
   * Starts an output.
   *
   * @throws IOException if it cannot start. An output starts even if its remote system does not
   *     answer
   */
  Output open(S settings, GatewayContext context) throws IOException;
}
