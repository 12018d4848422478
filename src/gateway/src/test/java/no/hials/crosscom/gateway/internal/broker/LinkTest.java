package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.exceptions.ConnectionFailedException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5DisconnectException;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5Disconnect;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
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

  private static Mqtt5DisconnectException disconnected(
      Mqtt5DisconnectReasonCode code, String message) {
    return new Mqtt5DisconnectException(
        Mqtt5Disconnect.builder().reasonCode(code).build(), message);
  }

  @Test
  void aBrokerEndsAConnectionBecauseOfAMessageOnlyForSomeReasons() {
    String byBroker = "Server sent DISCONNECT.";
    assertThat(Link.isEndedByBroker(new ConnectionClosedException("reset"))).isTrue();
    assertThat(
            Link.isEndedByBroker(
                disconnected(Mqtt5DisconnectReasonCode.PACKET_TOO_LARGE, byBroker)))
        .isTrue();
    assertThat(
            Link.isEndedByBroker(
                disconnected(Mqtt5DisconnectReasonCode.SERVER_SHUTTING_DOWN, byBroker)))
        .isFalse();
  }

  @Test
  void anInvalidPacketFromTheBrokerIsNotTheFaultOfAPublishedMessage() {
    Mqtt5DisconnectException invalid =
        disconnected(
            Mqtt5DisconnectReasonCode.MALFORMED_PACKET,
            "Exception while decoding PUBLISH: malformed response topic");

    assertThat(Link.isEndedByBroker(invalid)).isFalse();
    assertThat(Link.isInvalidPacket(invalid)).isTrue();
    assertThat(Link.reason(invalid))
        .isEqualTo(
            "the broker has passed on an invalid message: Exception while decoding PUBLISH:"
                + " malformed response topic");
  }
}
