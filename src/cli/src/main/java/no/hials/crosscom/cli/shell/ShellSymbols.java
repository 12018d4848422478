package no.hials.crosscom.cli.shell;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * The names that a shell knows: from the table of system variables, from the data lists on a
 * controller with C3 Bridge, and those that were used. Each source is read when it is first needed,
 * the data lists in a separate daemon thread.
 */
final class ShellSymbols {
  private static final String ROOT = "KRC:\\R1";
  private static final int MAX_DEPTH = 6;

  /** The maximum number of files; more would take longer than a user waits. */
  private static final int MAX_FILES = 300;

  /** How long to wait for names from the controller before answering without them. */
  private static final long MAX_SECONDS_TO_WAIT = 2;

  private final RobotConnection controller;
  private final Set<String> used = new LinkedHashSet<>();
  private @Nullable CompletableFuture<Catalogue> system;
  private @Nullable CompletableFuture<Catalogue> all;

  ShellSymbols(RobotConnection controller) {
    this.controller = controller;
  }

  /** Remembers a name. */
  synchronized void used(String name) {
    used.add(name.toUpperCase(Locale.ROOT));
  }

  /** Returns the names that were used, the earliest first. */
  synchronized List<String> used() {
    return List.copyOf(used);
  }

  /** Begins to load the table of system variables in the background. */
  void preload() {
    Objects.requireNonNull(load());
  }

  private synchronized CompletableFuture<Catalogue> load() {
    if (system == null) {
      system = inBackground(this::system);
    }
    return system;
  }

  private Catalogue system() {
    MockServer simulation = Robots.simulation(controller);
    return simulation == null
        ? Catalogue.system()
        : Catalogue.of(simulation.variables().toDataList("$VARIABLES"));
  }

  /** Returns the names that are known without asking the controller. */
  Catalogue known() {
    CompletableFuture<Catalogue> everything;
    synchronized (this) {
      everything = all;
    }
    return everything != null && everything.isDone() ? everything.join() : load().join();
  }

  /** Finds the variable that a path names. */
  Optional<CatalogueEntry> find(String path) {
    Optional<CatalogueEntry> found = known().find(path);
    return found.isPresent() ? found : everything().find(path);
  }

  /**
   * Returns all names. Names of the controller that take too long are missing, and available at a
   * later call.
   */
  Catalogue everything() {
    try {
      return declared().get(MAX_SECONDS_TO_WAIT, TimeUnit.SECONDS);
    } catch (TimeoutException | ExecutionException e) {
      return known();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return known();
    }
  }

  private synchronized CompletableFuture<Catalogue> declared() {
    if (all == null) {
      all = load().thenCompose(base -> inBackground(() -> base.plus(dataLists())));
    }
    return all;
  }

  private static CompletableFuture<Catalogue> inBackground(
      java.util.function.Supplier<Catalogue> work) {
    return CompletableFuture.supplyAsync(
        work,
        task -> {
          Thread thread = new Thread(task, "shell-names");
          thread.setDaemon(true);
          thread.start();
        });
  }

  /** Returns the data lists on the controller that could be read. */
  private Map<String, DataList> dataLists() {
    Map<String, DataList> lists = new LinkedHashMap<>();
    try {
      if (controller.client().getServer().type() == ServerType.C3_BRIDGE) {
        collect(controller.client().files(), ROOT, 0, lists);
      }
    } catch (IOException e) {
      // the names only help to type; the next line reports what is wrong
    }
    return lists;
  }

  private static void collect(
      ControllerFiles files, String directory, int depth, Map<String, DataList> lists)
      throws IOException {
    for (FileEntry entry : files.list(directory)) {
      String path = directory + "\\" + entry.name();
      if (entry.isDirectory() && depth < MAX_DEPTH) {
        collect(files, path, depth + 1, lists);
      } else if (entry.name().toLowerCase(Locale.ROOT).endsWith(".dat")
          && lists.size() < MAX_FILES) {
        String text = files.downloadText(path, TransferConfig.DEFAULT);
        KrlParser.parse(path, text)
            .file()
            .filter(DataList.class::isInstance)
            .ifPresent(list -> lists.put(path, (DataList) list));
      }
    }
  }
}
