package no.hials.crosscom.cell;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.protocol.ServerType;

/** The data lists in the files of a controller. */
public final class ControllerDataLists {
  private static final String ROOT = "KRC:\\R1";
  private static final int MAX_DEPTH = 6;

  /** The maximum number of files; more would take longer than a user waits. */
  private static final int MAX_FILES = 300;

  private ControllerDataLists() {}

  /**
   * Downloads the data lists of a controller with C3 Bridge. Takes one access for each folder and
   * several for each file.
   *
   * @return the lists that could be parsed, by their files, at most 300; empty with other servers
   * @throws IOException if a file cannot be read
   */
  public static Map<String, DataList> read(CrossComClient client) throws IOException {
    Map<String, DataList> lists = new LinkedHashMap<>();
    if (client.getServer().type() == ServerType.C3_BRIDGE) {
      collect(client.files(), ROOT, 0, lists);
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
