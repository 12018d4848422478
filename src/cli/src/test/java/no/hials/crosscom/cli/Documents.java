package no.hials.crosscom.cli;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Writes what the distribution has besides the jar, and is made from the commands themselves. The
 * build runs it; it is here and not in the jar, where nobody needs it.
 */
final class Documents {
  private static final int ID_BYTES = 8;

  private Documents() {}

  /** Makes all commands. */
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
    for (CommandSpec command : HelpText.commands(main.getCommandSpec()).toList()) {
      write(
          folder.resolve("man/man1/" + ManPage.name(command) + ".1"), ManPage.of(command, version));
    }
    write(folder.resolve("completion/jopenshowvar.bash"), Completion.bash(main));
    write(folder.resolve("completion/jopenshowvar.fish"), Completion.fish(main.getCommandSpec()));
    write(folder.resolve("lib/build-id"), idOf(jar) + "\n");
  }

  /** Gives what tells one jar from another. */
  private static String idOf(Path jar) throws IOException, NoSuchAlgorithmException {
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(jar));
    return HexFormat.of().formatHex(digest, 0, ID_BYTES);
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}
