package no.hials.crosscom.cli;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Writes the files of the distribution that are generated from the commands: completion, manual
 * pages and the build's id. The build runs it; it is not in the jar.
 */
final class Documents {
  private static final int ID_BYTES = 8;

  private Documents() {}

  /** Creates all commands. */
  static CommandLine commands() {
    return Main.commandLine(new Console(new StringWriter(), new StringWriter(), Map.of()));
  }

  /**
   * Runs it.
   *
   * @param args the folder for the files, the jar, and the version of the program
   */
  public static void main(String... args) throws IOException, NoSuchAlgorithmException {
    Path folder = Path.of(args[0]);
    Path jar = Path.of(args[1]);
    String version = args[2];
    CommandLine main = commands();
    for (CommandSpec command : CommandTree.withAllBelow(main.getCommandSpec()).toList()) {
      write(
          folder.resolve("man/man1/" + ManPage.name(command) + ".1"), ManPage.of(command, version));
    }
    write(folder.resolve("completion/jopenshowvar.bash"), Completion.bash(main));
    write(folder.resolve("completion/jopenshowvar.fish"), Completion.fish(main.getCommandSpec()));
    write(folder.resolve("lib/build-id"), idOf(jar) + "\n");
  }

  /** Returns a hash of the jar. */
  private static String idOf(Path jar) throws IOException, NoSuchAlgorithmException {
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(jar));
    return HexFormat.of().formatHex(digest, 0, ID_BYTES);
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}
