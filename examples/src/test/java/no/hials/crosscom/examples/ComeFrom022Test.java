package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Objects;
import no.hials.crosscom.Callback;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.Request;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.variables.Variable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Compares calls of 0.2.2 with the short ones, for {@code docs/how-to/come-from-0.2.2.md}. */
class ComeFrom022Test {
  private enum Mode {
    T1,
    T2,
    AUT,
    EX
  }

  @KukaController private MockServer robot;

  private CrossComClient client;

  @BeforeEach
  void connect() throws IOException {
    client = new CrossComClient(ClientConfig.create(robot.host(), cfg -> cfg.port(robot.port())));
  }

  @AfterEach
  void disconnect() throws IOException {
    client.close();
  }

  private String onTheController(String name) {
    return Objects.requireNonNull(robot.variables().get(name));
  }

  @Test
  void theShortReadsReturnTheValuesOfTheOldOnes() throws Exception {
    KRLReal speed = new KRLReal("$VEL.CP");
    client.readVariable(speed);
    double velocity = client.readReal("$VEL.CP");
    assertThat(velocity).isEqualTo(speed.doubleValue()).isEqualTo(2);

    KRLInt override = new KRLInt("$OV_PRO");
    client.readVariable(override);
    int percent = client.readInt("$OV_PRO");
    assertThat(percent).isEqualTo(override.intValue()).isEqualTo(100);

    KRLBool input = new KRLBool("$IN[1025]");
    client.readVariable(input);
    boolean on = client.readBool("$IN[1025]");
    assertThat(on).isEqualTo(input.getValue()).isTrue();

    KRLEnum modeName = new KRLEnum("$MODE_OP");
    client.readVariable(modeName);
    Mode mode = client.readEnum("$MODE_OP", Mode.class);
    assertThat("#" + mode).isEqualTo(modeName.getValue()).isEqualTo("#T1");
  }

  @Test
  void theRecordHasTheFieldsOfTheStructure() throws Exception {
    KRLE6Pos structure = new KRLE6Pos("$POS_ACT");
    client.readVariable(structure);
    E6Pos position = client.read("$POS_ACT", E6Pos.class);
    assertThat(position).isEqualTo(structure.toE6Pos());
    assertThat(position.z()).isEqualTo(890);

    double[] angles = client.readJointAngles();
    Axis axes = client.read("$AXIS_ACT", Axis.class);
    assertThat(axes.toArray()).isEqualTo(angles);
  }

  @Test
  void theShortWritesWriteTheValuesOfTheOldOnes() throws Exception {
    KRLInt override = new KRLInt("$OV_PRO");
    override.setValue(50);
    client.writeVariable(override);
    assertThat(onTheController("$OV_PRO")).isEqualTo("50");
    client.writeInt("$OV_PRO", 40);
    assertThat(onTheController("$OV_PRO")).isEqualTo("40");

    KRLPos step = new KRLPos("MYPOS");
    step.setX(2);
    client.writeVariable(step);
    assertThat(client.readReal("MYPOS.X")).isEqualTo(2);
    client.writeReal("MYPOS.X", 3);
    assertThat(client.readReal("MYPOS.X")).isEqualTo(3);
  }

  @Test
  @SuppressWarnings("deprecation") // the old calls
  void accessesByTextReturnTheTextOfTheOldOnes() throws Exception {
    Callback answer = client.sendRequest(new Request(0, "$OV_PRO"));
    String text = client.readText("$OV_PRO");
    assertThat(text).isEqualTo(answer.getStringValue()).isEqualTo("100");

    Variable<?> number = answer.getVariable();
    KrlValue value = client.readValue("$OV_PRO");
    assertThat(value).isEqualTo(new KrlInt((Integer) number.getValue()));

    client.sendRequest(new Request(1, "$OV_PRO", "50"));
    assertThat(onTheController("$OV_PRO")).isEqualTo("50");
    client.writeText("$OV_PRO", "40");
    assertThat(client.simpleRead("$OV_PRO")).endsWith("#value=40");
  }
}
