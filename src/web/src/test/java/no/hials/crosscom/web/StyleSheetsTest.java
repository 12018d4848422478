package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Compares the style sheets, all of which hold for every view. */
class StyleSheetsTest {
  private static final String PAGE = "/no/hials/crosscom/web/page/";
  private static final Pattern SHEET = Pattern.compile("href=\"/(style/\\w+\\.css)\"");
  private static final Pattern CLASS =
      Pattern.compile("^(\\.[\\w-]+)(?: \\{|,)$", Pattern.MULTILINE);

  private static String text(String name) throws IOException {
    try (InputStream file = StyleSheetsTest.class.getResourceAsStream(PAGE + name)) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Else a view gets another one's look, such as the text of a program the width of a QR code. */
  @Test
  void aClassIsStyledAloneInOneSheetOnly() throws IOException {
    Map<String, TreeSet<String>> sheets = new TreeMap<>();
    for (String sheet :
        SHEET.matcher(text("index.html")).results().map((MatchResult it) -> it.group(1)).toList()) {
      CLASS
          .matcher(text(sheet))
          .results()
          .forEach(it -> sheets.computeIfAbsent(it.group(1), key -> new TreeSet<>()).add(sheet));
    }
    assertThat(sheets).isNotEmpty();
    assertThat(new ArrayList<>(sheets.entrySet())).allMatch(it -> it.getValue().size() == 1);
  }
}
