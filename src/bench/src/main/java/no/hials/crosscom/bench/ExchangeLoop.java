package no.hials.crosscom.bench;

import java.io.IOException;
import java.io.PrintStream;
import no.hials.crosscom.CrossComClient;

/** Runs many exchanges of one kind, for tools such as strace. */
public final class ExchangeLoop {
  private ExchangeLoop() {}

  /**
   * Runs the exchanges.
   *
   * @param args {@code client} or {@code socket}, the name of the operation, and the number of
   *     exchanges
   * @throws IOException if an exchange fails
   */
  public static void main(String[] args) throws IOException {
    run(
        args[0].equals("client"),
        Operation.valueOf(args[1]),
        Integer.parseInt(args[2]),
        System.out);
  }

  static void run(boolean throughClient, Operation operation, int count, PrintStream out)
      throws IOException {
    try (BareServer server = new BareServer(operation);
        CrossComClient client = new CrossComClient("127.0.0.1", server.port());
        BareClient bare = new BareClient(server.port(), operation)) {
      Exchange exchange = throughClient ? operation.through(client) : bare;
      for (int i = 0; i < count; i++) {
        exchange.run();
      }
      out.println(server.requests() + " requests came in " + server.segments() + " pieces");
    }
  }
}
