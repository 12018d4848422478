package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.simulator.VariableInfo;
import no.hials.crosscom.simulator.VariableTable;
import org.junit.jupiter.api.Test;

/** Compares the table of system variables in the documentation with the built-in data lists. */
class SystemVariablesPageTest {
  private static final Path PAGE = Path.of("..", "docs", "reference", "system-variables.md");
  private static final String BEGIN = "<!-- from the data lists -->\n";
  private static final String END = "<!-- end of the data lists -->";
  private static final String RENEW =
      "mvn -B test -pl examples -am -Dtest=SystemVariablesPageTest -Dtests.required=false"
          + " -Dsurefire.failIfNoSpecifiedTests=false -Drenew.reference=true";

  @Test
  void theTableIsWhatTheDataListsSay() throws IOException {
    String page = Files.readString(PAGE);
    assertThat(page).contains(BEGIN, END);
    String renewed =
        page.substring(0, page.indexOf(BEGIN) + BEGIN.length())
            + "\n"
            + table()
            + "\n"
            + page.substring(page.indexOf(END));
    if (Boolean.getBoolean("renew.reference")) {
      Files.writeString(PAGE, renewed);
      return;
    }

    assertThat(page.equals(renewed)).as("the table is outdated; renew it with: " + RENEW).isTrue();
  }

  private static String table() {
    StringBuilder table = new StringBuilder("| name | type | unit | access | meaning |\n");
    table.append("|---|---|---|---|---|\n");
    for (VariableInfo info : VariableTable.krc4().describeAll()) {
      if (info.name().startsWith("$")) {
        table.append(row(info));
      }
    }
    return table.toString();
  }

  private static String row(VariableInfo info) {
    String name =
        info.dimensions().isEmpty()
            ? info.name()
            : info.name() + info.dimensions().toString().replace(" ", "");
    return String.join(
            " | ",
            "| `" + name + "`",
            info.type(),
            info.unit(),
            (info.access() == Access.READ_ONLY ? "RO" : "RW")
                + (info.source().matches(".*\\bU\\b.*") ? "?" : ""),
            info.meaning().replace("|", "\\|") + " |")
        + "\n";
  }
}
