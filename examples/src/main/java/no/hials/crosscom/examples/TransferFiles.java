package no.hials.crosscom.examples;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;

/** Uploads a program, lists the folder, and downloads the program again. It needs C3 Bridge. */
public final class TransferFiles {
  private static final String FOLDER = "KRC:\\R1\\Program";
  private static final String NAME = FOLDER + "\\ACTUATOR.SRC";

  private TransferFiles() {}

  /**
   * Runs the example in a simulated controller, since it would write a file on a real one.
   *
   * @param args not used
   * @throws IOException if a file could not be transferred
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      upload(client, KrlFolder.file("actuator.src"));
      list(client);
      download(client);
    }
  }

  private static void upload(CrossComClient client, Path source) throws IOException {
    TransferConfig careful =
        TransferConfig.create(
            cfg ->
                cfg.overwrite(true) // otherwise it fails if the file exists
                    .verification(Verification.CONTENT) // reads it back and compares
                    .progress((bytes, total) -> System.out.println(bytes + " of " + total)));
    client.files().upload(source, NAME, careful);
  }

  private static void list(CrossComClient client) throws IOException {
    for (FileEntry entry : client.files().list(FOLDER)) {
      System.out.println(entry.name() + ", " + entry.size().orElse(0) + " bytes");
    }
  }

  private static void download(CrossComClient client) throws IOException {
    Path folder = Files.createTempDirectory("jopenshowvar");
    Path copy = folder.resolve("actuator.src");
    try {
      client.files().download(NAME, copy); // complete or not at all
      System.out.println(Files.readAllLines(copy, StandardCharsets.ISO_8859_1).get(0));
    } finally {
      Files.deleteIfExists(copy);
      Files.delete(folder);
    }
  }
}
