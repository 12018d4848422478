package no.hials.crosscom.examples;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;

/**
 * Uploads {@code krl/actuator.src} to the controller, runs it, and moves the robot with it, all
 * over the network. It needs C3 Bridge.
 *
 * <p><b>On a real controller this moves the robot</b>, by 40 mm and more: start in T1.
 */
public final class RunKrlProgram {
  private static final String CONFIG = "KRC:\\R1\\System\\$config.dat";
  private static final String PROGRAM = "KRC:\\R1\\Program\\actuator";

  /** Type and name. */
  private static final Pattern DECLARATION = Pattern.compile("^DECL \\w+ \\w+\\b");

  private static final TransferConfig REPLACE =
      TransferConfig.create(cfg -> cfg.overwrite(true).verification(Verification.CONTENT));

  private RunKrlProgram() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if an access failed
   */
  public static void main(String[] args) throws IOException {
    if (Arguments.nameAController(args)) {
      try (CrossComClient client = new CrossComClient(args[0], Integer.parseInt(args[1]))) {
        run(client);
      }
      return;
    }
    try (MockServer robot = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      robot.controller().setMode(OperatingMode.AUT);
      try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
        run(client);
      }
    }
  }

  private static void run(CrossComClient client) throws IOException {
    declareGlobals(client);
    client.files().upload(KrlFolder.file("actuator.src"), PROGRAM + ".src", REPLACE);
    client.files().upload(KrlFolder.file("actuator.dat"), PROGRAM + ".dat", REPLACE);
    client.programs().select("/R1/ACTUATOR");
    client.programs().start(Interpreter.ROBOT);
    try {
      move(client);
    } finally {
      client.programs().stop(Interpreter.ROBOT);
    }
    System.out.println("stopped: " + client.readText("$PRO_STATE1"));
    client.programs().cancel(Interpreter.ROBOT);
    byte[] sent = Files.readAllBytes(KrlFolder.file("actuator.src"));
    byte[] stored = client.files().download(PROGRAM + ".src");
    System.out.println("the same bytes: " + Arrays.equals(sent, stored));
  }

  /** Adds the lines of {@code krl/config.dat} that are missing in the controller's list. */
  private static void declareGlobals(CrossComClient client) throws IOException {
    String list = client.files().downloadText(CONFIG, TransferConfig.DEFAULT);
    StringBuilder added = new StringBuilder();
    for (String line :
        Files.readAllLines(KrlFolder.file("config.dat"), StandardCharsets.ISO_8859_1)) {
      Matcher declared = DECLARATION.matcher(line);
      if (declared.find() && !list.contains(declared.group())) {
        added.append(line).append("\r\n");
      }
    }
    int end = list.lastIndexOf("ENDDAT");
    client
        .files()
        .uploadText(list.substring(0, end) + added + list.substring(end), CONFIG, REPLACE);
  }

  private static void move(CrossComClient client) throws IOException {
    double z = height(client);
    awaitLoop(client);
    System.out.println("started: " + client.readText("$PRO_STATE1"));
    client.writeVariable(new KRLPos("MYPOS").setZ(1)); // mm per step
    while (height(client) < z + 40) {
      checkActive(client);
    }
    client.writeVariable(new KRLPos("MYPOS")); // zeros: stop
    System.out.println("moved up by 40 mm or more");
  }

  /** Waits until the program is in its loop, and starts it again at the end of its BCO run. */
  private static void awaitLoop(CrossComClient client) throws IOException {
    boolean again = false;
    while (client.readInt("JOV_STEPS") == 0) {
      String state = client.readText("$PRO_STATE1");
      boolean reached = state.equals("#P_STOP") && client.readText("$ON_PATH").equals("TRUE");
      if (reached && !again) {
        client.programs().start(Interpreter.ROBOT); // moves a machine
        again = true;
      } else {
        requireActive(state);
      }
    }
  }

  private static double height(CrossComClient client) throws IOException {
    return client.readReal("$POS_ACT.Z");
  }

  private static void checkActive(CrossComClient client) throws IOException {
    requireActive(client.readText("$PRO_STATE1"));
  }

  private static void requireActive(String state) {
    if (!state.equals("#P_ACTIVE")) {
      throw new IllegalStateException("the program must be active, is " + state);
    }
  }
}
