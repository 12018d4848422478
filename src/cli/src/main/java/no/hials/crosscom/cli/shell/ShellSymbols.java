package no.hials.crosscom.cli.shell;

import java.io.IOException;
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
import java.util.function.Supplier;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.ControllerDataLists;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;

/**
 * The names that a shell knows: from the table of system variables, from the data lists on a
 * controller with C3 Bridge, and those that were used. Each source is read when it is first needed,
 * the data lists in a separate daemon thread.
 */
final class ShellSymbols {
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

  private static CompletableFuture<Catalogue> inBackground(Supplier<Catalogue> work) {
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
    try {
      return ControllerDataLists.read(controller.client());
    } catch (IOException e) {
      return Map.of(); // the names only help to type; the next line reports what is wrong
    }
  }
}
