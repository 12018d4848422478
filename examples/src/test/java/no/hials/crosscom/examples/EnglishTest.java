package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Finds words that nobody says, in comments, docs, help texts and messages. */
class EnglishTest {
  private static final Set<String> NOT_OURS = Set.of("target", ".git", ".idea", "node_modules");
  private static final Pattern TEXT =
      Pattern.compile(
          "[^.]+|.*\\.(java|g4|md|xml|sh|bat|py|toml|properties|yml|src|sub|dat|tsv|js|css|html)",
          Pattern.CASE_INSENSITIVE);

  /** May grow. Whole words, in upper or lower case. */
  private static final String WORDS =
      "anew|for want of|mend|bears?|in vain|seldom|whoever|(?-i:(?<!there )is none)|takes the"
          + " news|(?:end|result) to come|what came of|alike, too|for one thread|may stand"
          + " there|argument too many|it is not said|gone after it|is waited|to be had|the leave"
          + " to|is what is left|it has enough|as it were|beside|behind it|behind each|for ever|stands in|was"
          + " not asked for|as of|(?-i:(?<![Tt]here )(?:is|are) no (?!longer|more))|the"
          + " (?:rest|rest of the file|last one) counts|put aside|read all the same|may take,"
          + " about|sees to it|values? of now|can no more";

  /** May grow. First words of a doc comment, in Java or Python. */
  private static final String FIRST_WORDS = "Gives|Hears|Says|What|Returns what|Returns such as";

  private static final Pattern WRONG =
      Pattern.compile("(?i:\\b(" + WORDS + ")\\b)|(?:/\\*\\* |\"\"\")(" + FIRST_WORDS + ")\\b");

  @Test
  void nobodySaysSo() throws IOException {
    List<String> wrong = new ArrayList<>();
    List<Path> files = files(MarkdownPages.ROOT);
    assertThat(files)
        .extracting(file -> MarkdownPages.ROOT.relativize(file).toString().replace('\\', '/'))
        .contains(
            "README.md",
            ".ci/run",
            "examples/python/read_and_move.py",
            "src/cli/src/main/dist/bin/jopenshowvar",
            "src/cli/src/main/dist/bin/jopenshowvar.bat",
            "src/site/hooks.py");
    for (Path file : files) {
      String text = Files.readString(file, StandardCharsets.ISO_8859_1);
      for (String found : wrongWords(text)) {
        wrong.add(MarkdownPages.ROOT.relativize(file) + ": " + found);
      }
    }

    assertThat(wrong).isEmpty();
  }

  @Test
  void findsWordsAlsoAcrossLines() {
    String text =
        """
        /**
         * Gives it. Mended, amend, is
         * none. Returns the result to
         * come.
         */
        \"""Gives it.\"""
        """;

    assertThat(wrongWords(text))
        .containsExactly("/** Gives", "is none", "result to come", "\"\"\"Gives");
  }

  private static List<String> wrongWords(String text) {
    String words = text.replaceAll("\\s*\\R\\s*(\\*(?!/)|//|#)?\\s*", " ");
    return WRONG.matcher(words).results().map(MatchResult::group).toList();
  }

  /** Returns the texts of the repository, without this test and the results of builds. */
  private static List<Path> files(Path folder) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> entries = Files.list(folder)) {
      for (Path entry : entries.sorted().toList()) {
        String name = entry.getFileName().toString();
        if (Files.isDirectory(entry)) {
          files.addAll(NOT_OURS.contains(name) ? List.of() : files(entry));
        } else if (TEXT.matcher(name).matches() && !name.equals("EnglishTest.java")) {
          files.add(entry);
        }
      }
    }
    return files;
  }
}
