package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.exceptions.ConnectionFailedException;
import java.net.ConnectException;
import java.net.SocketException;
import java.nio.channels.ClosedChannelException;
import org.junit.jupiter.api.Test;

class LinkTest {
  @Test
  void aReasonHasNoNameOfAClass() {
    assertThat(Link.reason(new ConnectionClosedException(new ClosedChannelException())))
        .isEqualTo("the connection was closed");
    assertThat(Link.reason(new ConnectionClosedException(new SocketException("reset"))))
        .isEqualTo("reset");
    assertThat(Link.reason(new ConnectionFailedException(new ConnectException("refused"))))
        .isEqualTo("refused");
    assertThat(Link.reason(new ConnectionClosedException("timeout"))).isEqualTo("timeout");
  }
}
