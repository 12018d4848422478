package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Follows the links of the documentation within the repository. */
class LinksTest {
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
  private static final Pattern ELSEWHERE = Pattern.compile("^(https?|mailto):.*");
  private static final Pattern CODE = Pattern.compile("`[^`]*`");

  static List<Path> pages() throws IOException {
    return MarkdownPages.ofTheDocumentation();
  }

  @ParameterizedTest
  @MethodSource("pages")
  void everyRelativeLinkAndAnchorOfTheDocumentationLeadsSomewhere(Path page) throws IOException {
    assertThat(broken(page)).isEmpty();
  }

  @Test
  void aLinkToNoFileOrNoHeadingIsFound(@TempDir Path folder) throws IOException {
    Path page = folder.resolve("page.md");
    Files.writeString(
        page,
        """
        # A page
        [good](page.md), [good](#what-it-does), [good](page.md#a-page), [good](https://example.org)
        [bad](other.md), [bad](#what-it-is), [bad](page.md#page)
        ```
        [code](nowhere.md)
        ```
        `[code](nowhere.md)`
        ## What `it` does?
        """);

    assertThat(broken(page))
        .containsExactly(
            "line 3: other.md is not there",
            "line 3: #what-it-is is not a heading",
            "line 3: page.md#page is not a heading");
  }

  private static List<String> broken(Path page) throws IOException {
    List<String> broken = new ArrayList<>();
    int number = 0;
    for (String line : MarkdownPages.withoutCode(page)) {
      number++;
      Matcher link = LINK.matcher(CODE.matcher(line).replaceAll(""));
      while (link.find()) {
        int at = number;
        fault(page, link.group(1)).ifPresent(fault -> broken.add("line " + at + ": " + fault));
      }
    }
    return broken;
  }

  private static Optional<String> fault(Path page, String link) throws IOException {
    if (ELSEWHERE.matcher(link).matches()) {
      return Optional.empty();
    }
    int sign = link.indexOf('#');
    String file = sign < 0 ? link : link.substring(0, sign);
    Path target = file.isEmpty() ? page : page.resolveSibling(file).normalize();
    if (!Files.exists(target)) {
      return Optional.of(link + " is not there");
    }
    if (sign < 0 || MarkdownPages.anchors(target).contains(link.substring(sign + 1))) {
      return Optional.empty();
    }
    return Optional.of(link + " is not a heading");
  }
}
