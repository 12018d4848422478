package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.junit.jupiter.api.Test;

/**
 * Numbers its requests. One kind of server is enough for that: both get their requests by the same
 * way, and it takes very many of them.
 */
class RequestIdTest {
  @Test
  void idsAreTheClientsCountUpAndWrap() throws Exception {
    try (MockServer robot = MockServer.start();
        CrossComClient client =
            new CrossComClient(
                ClientConfig.create(
                    robot.host(), cfg -> cfg.port(robot.port()).keepAlive(Duration.ZERO)))) {
      KRLInt i = new KRLInt("MYINT");
      for (int n = 0; n < 65_540; n++) {
        client.readVariable(i);
      }

      List<Integer> ids =
          robot.requests().stream().map(r -> ((ReadRequest) r.request()).id()).toList();
      int wrap = ids.indexOf(0);
      assertThat(ids.subList(wrap - 1, wrap + 2)).containsExactly(65_535, 0, 1);
    }
  }
}
