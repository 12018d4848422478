package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.lang.internal.TreeBytes;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Builds the tree of a file from its lines. */
final class FileBuilder {
  private final LineReader lines;
  private final Errors errors;
  private final TreeBytes tree;
  private final Map<String, String> headers = new LinkedHashMap<>();
  private final List<Routine> routines = new ArrayList<>();
  private @Nullable RoutineBuilder routine;
  private @Nullable DataListBuilder dataBuilder;
  private @Nullable DataList dataList;
  private @Nullable Position begin;
  private boolean isDataList;
  private boolean lost;

  FileBuilder(String file, String text) {
    errors = new Errors(file);
    tree = new TreeBytes(file);
    lines = new LineReader(text);
  }

  ParseResult build() {
    for (Line line = lines.next(); line != null; line = lines.next()) {
      add(line);
    }
    Token end = lines.end();
    close(end);
    tree.close();
    if (begin == null) {
      outside(end);
    }
    return new ParseResult(Optional.ofNullable(file()), errors.inOrder());
  }

  private @Nullable KrlFile file() {
    if (dataList != null) {
      return dataList;
    }
    return begin == null || routines.isEmpty()
        ? null
        : new SourceFile(begin, headers(), List.copyOf(routines));
  }

  private Map<String, String> headers() {
    return Collections.unmodifiableMap(headers);
  }

  private void add(Line line) {
    switch (line.keyword().getType()) {
      case KrlGrammarParser.HEADER -> header(line.first());
      case KrlGrammarParser.DEF, KrlGrammarParser.DEFFCT -> beginRoutine(line);
      case KrlGrammarParser.DEFDAT -> beginDataList(line);
      case KrlGrammarParser.END, KrlGrammarParser.ENDFCT, KrlGrammarParser.ENDDAT -> end(line);
      default -> content(line);
    }
  }

  private void content(Line line) {
    if (routine != null) {
      routine.add(line);
    } else if (dataBuilder != null) {
      dataBuilder.add(line);
    } else {
      outside(line.first());
    }
  }

  private void header(Token token) {
    String[] words = token.getText().substring(1).strip().split("\\s+", 2);
    if (words[0].isEmpty()) {
      errors.add(token, "expected a word after &");
      return;
    }
    headers.merge(
        words[0].toUpperCase(Locale.ROOT),
        words.length > 1 ? words[1] : "",
        (before, now) -> before + "\n" + now);
  }

  private void beginRoutine(Line line) {
    close(line.keyword());
    if (isDataList) {
      outside(line.keyword());
      return;
    }
    begin(line);
    routine = new RoutineBuilder(line, tree, errors);
  }

  private void beginDataList(Line line) {
    close(line.keyword());
    if (begin != null) {
      outside(line.keyword());
      return;
    }
    begin(line);
    isDataList = true;
    dataBuilder = new DataListBuilder(line, tree, errors);
  }

  private void begin(Line line) {
    if (begin == null) {
      begin = errors.at(line.first());
    }
    lost = false;
  }

  private void end(Line line) {
    if (routine == null && dataBuilder == null) {
      outside(line.first());
      return;
    }
    close(line.first());
    // Tokens after END are another error.
    line.parse(errors);
  }

  /** Ends the open routine or data list. */
  private void close(Token found) {
    if (routine != null) {
      Routine finished = routine.finish(found);
      if (finished != null) {
        routines.add(finished);
      }
      routine = null;
    } else if (dataBuilder != null) {
      dataList = dataBuilder.finish(found, headers());
      dataBuilder = null;
    }
  }

  /** Reports the first line outside all routines. */
  private void outside(Token found) {
    if (!lost) {
      String expected =
          isDataList
              ? "the end of the file"
              : begin == null ? "DEF, DEFFCT or DEFDAT" : "DEF, DEFFCT or the end of the file";
      errors.add(found, "expected " + expected + ", found " + ErrorWords.found(found));
    }
    lost = true;
  }
}
