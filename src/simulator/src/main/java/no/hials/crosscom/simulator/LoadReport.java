package no.hials.crosscom.simulator;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * The result of loading files.
 *
 * @param files the result of each file, in the order of loading
 */
public record LoadReport(List<FileReport> files) {

  /** Copies the list. */
  public LoadReport {
    files = List.copyOf(files);
  }

  /** The outcome for one file. */
  public enum Outcome {
    /** All of it was loaded. */
    LOADED,
    /** It was loaded without the parts that the warnings name. */
    WARNINGS,
    /** Nothing of it was loaded. */
    REFUSED
  }

  /**
   * The result of one file.
   *
   * @param path the name of the file
   * @param module the name of its module; empty if it was refused or has no module
   * @param outcome whether it was loaded
   * @param problems the warnings, or the reasons of the refusal, in the order of the file
   */
  public record FileReport(String path, String module, Outcome outcome, List<KrlError> problems) {

    /** Copies the list. */
    public FileReport {
      problems = List.copyOf(problems);
    }

    /** Returns the report of a file that was loaded. */
    static FileReport loaded(String path, String module, List<KrlError> warnings) {
      return new FileReport(
          path, module, warnings.isEmpty() ? Outcome.LOADED : Outcome.WARNINGS, warnings);
    }

    /** Returns the report of a file that was refused. */
    static FileReport refused(String path, List<KrlError> reasons) {
      return new FileReport(path, "", Outcome.REFUSED, reasons);
    }
  }

  /**
   * Returns whether a file was refused.
   *
   * @return false if all files were loaded, with or without warnings
   */
  public boolean anyRefused() {
    return files.stream().anyMatch(file -> file.outcome() == Outcome.REFUSED);
  }

  /**
   * Returns all problems.
   *
   * @return the problems of the files, one file after the other
   */
  public List<KrlError> problems() {
    return files.stream().flatMap(file -> file.problems().stream()).toList();
  }

  /** Returns a line for each file and each problem. */
  @Override
  public String toString() {
    List<String> lines = new ArrayList<>();
    for (FileReport file : files) {
      String count = file.outcome() == Outcome.WARNINGS ? ": " + file.problems().size() : "";
      lines.add(PrintableText.of(file.path()) + " " + file.outcome() + count);
      file.problems().forEach(problem -> lines.add("  " + PrintableText.of(problem.toString())));
    }
    return String.join("\n", lines);
  }
}
