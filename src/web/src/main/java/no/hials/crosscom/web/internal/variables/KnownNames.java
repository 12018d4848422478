package no.hials.crosscom.web.internal.variables;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.ControllerDataLists;
import no.hials.crosscom.web.internal.robot.RobotSession;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The variables of a robot that the page knows: those of every controller, and those declared in
 * the data lists on this controller, which only C3 Bridge can read. Thread-safe.
 */
final class KnownNames {
  private static final Logger LOG = LoggerFactory.getLogger(KnownNames.class);

  private final RobotSession robot;
  private final Runnable listener;

  // guarded by this
  private @Nullable Catalogue known;
  private List<SearchedVariable> searched = List.of();
  private boolean loading;
  private boolean complete;

  /**
   * Creates the names of a robot.
   *
   * @param listener called when further names are known
   */
  KnownNames(RobotSession robot, Runnable listener) {
    this.robot = robot;
    this.listener = listener;
  }

  /** Loads the names in the background, unless they are loaded. */
  void load() {
    Thread thread = new Thread(this::now, "web-names");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * A variable.
   *
   * @param text where a search looks for words, in small letters
   */
  record SearchedVariable(CatalogueEntry entry, String text) {
    static List<SearchedVariable> listOf(Catalogue catalogue) {
      return catalogue.variables().stream()
          .map(
              it ->
                  new SearchedVariable(
                      it,
                      String.join(
                              "\n",
                              it.declarator(),
                              it.type(),
                              it.unit(),
                              it.shortAccess(),
                              it.meaning())
                          .toLowerCase(Locale.ROOT)))
          .toList();
    }
  }

  /**
   * The names that are known at a time.
   *
   * @param searched the variables, with texts that each search would build again
   * @param loading whether the data lists are being read, so that there may soon be more
   */
  record Names(Catalogue catalogue, List<SearchedVariable> searched, boolean loading) {}

  /** Returns the names that are known now. Starts to read the data lists on the controller. */
  synchronized Names now() {
    Catalogue names = known;
    if (names == null) {
      complete = robot.simulation().isPresent();
      names =
          robot
              .simulation()
              .map(server -> Catalogue.of(server.variables().toDataList("$VARIABLES")))
              .orElseGet(Catalogue::system);
      known = names;
      searched = SearchedVariable.listOf(names);
    }
    if (!complete && !loading) {
      loading = true;
      Catalogue base = names;
      Thread thread = new Thread(() -> readLists(base), "web-data-lists");
      thread.setDaemon(true);
      thread.start();
    }
    return new Names(names, searched, loading);
  }

  private void readLists(Catalogue base) {
    try {
      Catalogue all = base.plus(ControllerDataLists.read(robot.client()));
      List<SearchedVariable> allSearched = SearchedVariable.listOf(all);
      synchronized (this) {
        known = all;
        searched = allSearched;
        complete = true;
        loading = false;
      }
      listener.run();
    } catch (IOException e) {
      LOG.debug("the data lists could not be read, the next search tries again", e);
      synchronized (this) {
        loading = false;
      }
    }
  }
}
