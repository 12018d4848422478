package no.hials.crosscom.cli.krl;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.LoadReport;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.simulator.VariableTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code krl check}. */
@Command(
    name = "check",
    description = {
      "Checks KRL files: grammar, declarations, and routines and variables that are missing.",
      "A folder or a zip is an archive of a controller or a part of it; all files are checked"
          + " together. The data list next to a single program is included."
    },
    footer = {
      "",
      "Each problem is a line: file, line, column, and reason. Exit code 1 stands for a problem.",
      "",
      "With --json each file is an object: file, outcome (loaded, warnings, or refused), and"
          + " problems with line, column and message.",
      "",
      "Examples:",
      "  jopenshowvar krl check krl/config.dat krl/actuator.src",
      "  jopenshowvar krl check cell.zip --json"
    })
final class KrlCheck extends ConsoleCommand {
  @Parameters(
      arity = "1..*",
      paramLabel = "PATH",
      description = "The .src, .sub and .dat files, folders and zips.")
  private List<Path> places = new ArrayList<>();

  @Option(names = "--json", description = "Print one JSON object for each file.")
  private boolean json;

  @Option(
      names = "--strict",
      description =
          "Refuse a file with an error, as mock --strict does. Default: the rest of the file"
              + " is loaded and checked.")
  private boolean strict;

  @Override
  public ExitCode run() throws IOException {
    Archive archive = LoadedFiles.open(withDataLists());
    LoadReport report;
    try (Controller controller =
        new Controller(
            VariableTable.krc4(),
            SimulationClock.stepped(),
            RobotModel.kr6r900sixx(),
            "krl-check")) {
      report = controller.load(archive, new LoadedFiles(strict).mode());
    }
    for (FileReport file : report.files()) {
      if (json) {
        console().print(LoadedFiles.json(file));
      } else {
        LoadedFiles.problems(file).forEach(console()::print);
      }
    }
    int problems = report.problems().size();
    console().hint("files: " + report.files().size() + ", problems: " + problems);
    return problems == 0 ? ExitCode.DONE : ExitCode.REFUSED;
  }

  private List<Path> withDataLists() throws FileException {
    Set<Path> all = new LinkedHashSet<>(places);
    for (Path place : places) {
      if (Files.isRegularFile(place) && place.toString().matches("(?i).*\\.(src|sub)")) {
        Path list = LocalFiles.dataListOf(place);
        boolean given = list == null || all.stream().anyMatch(p -> p.toAbsolutePath().equals(list));
        if (!given) {
          all.add(list);
        }
      }
    }
    return List.copyOf(all);
  }
}
