package no.hials.crosscom.simulator.internal.program;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.SourceFile;

/**
 * The routines of KSS that are written in KRL here. They are used where no loaded module has a
 * global routine of the same name that can be executed
 * (docs/reference/krl-language.md#routines-of-kss).
 */
final class BuiltInModules {
  private static final String FOLDER = "/no/hials/crosscom/simulator/krl/";

  /** Parsed once: the trees never change. */
  static final List<SourceFile> SOURCES =
      List.of(parse("bas.src"), parse("msglib.src"), parse("p00.src"));

  private BuiltInModules() {}

  private static SourceFile parse(String name) {
    try (InputStream in = BuiltInModules.class.getResourceAsStream(FOLDER + name)) {
      if (in == null) {
        throw new FileNotFoundException("resource " + name + " is missing");
      }
      String text = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
      ParseResult parsed = KrlParser.parse(name, text);
      if (parsed.errors().isEmpty() && parsed.file().orElseThrow() instanceof SourceFile source) {
        return source;
      }
      throw new IllegalStateException("resource " + name + " has errors: " + parsed.errors());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
