package no.hials.crosscom.cli.base;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Finds the words that a mistyped word may stand for. */
public final class Suggestions {
  private static final int SHORT = 4;

  private Suggestions() {}

  /**
   * Returns the words with the fewest typing mistakes; if there are none, those that begin with the
   * typed word.
   *
   * @param words the words to choose from
   */
  public static List<String> of(String typed, Collection<String> words) {
    List<String> near = near(typed, words);
    return near.isEmpty()
        ? words.stream().filter(word -> word.startsWith(typed)).sorted().toList()
        : near;
  }

  /** Returns the words with the fewest typing mistakes: at most two, in a short word one. */
  public static List<String> near(String typed, Collection<String> words) {
    int most = typed.replace("-", "").length() <= SHORT ? 1 : 2;
    Map<Integer, List<String>> byMistakes =
        words.stream()
            // of a long text only the length is compared
            .filter(word -> Math.abs(word.length() - typed.length()) <= most)
            .sorted()
            .collect(
                Collectors.groupingBy(
                    word -> mistakes(typed.toLowerCase(Locale.ROOT), word),
                    TreeMap::new,
                    Collectors.toList()));
    return byMistakes.entrySet().stream()
        .filter(entry -> entry.getKey() <= most)
        .findFirst()
        .map(Map.Entry::getValue)
        .orElse(List.of());
  }

  /** Returns a question for them; empty if there are none. */
  public static String question(List<String> words) {
    return words.isEmpty() ? "" : "did you mean " + String.join(" or ", words) + "?";
  }

  /**
   * Returns the number of letters that are wrong, missing, too many, or swapped with their
   * neighbour: the optimal string alignment distance.
   */
  private static int mistakes(String typed, String word) {
    int[][] least = new int[typed.length() + 1][word.length() + 1];
    for (int i = 0; i <= typed.length(); i++) {
      for (int j = 0; j <= word.length(); j++) {
        if (i == 0 || j == 0) {
          least[i][j] = i + j;
          continue;
        }
        int wrong = typed.charAt(i - 1) == word.charAt(j - 1) ? 0 : 1;
        least[i][j] =
            Math.min(least[i - 1][j - 1] + wrong, 1 + Math.min(least[i - 1][j], least[i][j - 1]));
        if (i > 1
            && j > 1
            && typed.charAt(i - 1) == word.charAt(j - 2)
            && typed.charAt(i - 2) == word.charAt(j - 1)) {
          least[i][j] = Math.min(least[i][j], least[i - 2][j - 2] + 1);
        }
      }
    }
    return least[typed.length()][word.length()];
  }
}
