package no.hials.crosscom.simulator.internal.files;

import java.time.Clock;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import no.hials.crosscom.protocol.code.FileAttribute;
import org.jspecify.annotations.Nullable;

/** Stores items in memory; the times are those of a clock. */
final class MemoryStore implements ItemStore {
  private static final byte[] NOTHING = {};

  private final Clock clock;
  private final Entry root;
  private long used;

  MemoryStore(Clock clock) {
    this.clock = clock;
    root = new Entry("", true, clock.instant());
  }

  private static final class Entry {
    private final boolean directory;
    private final SortedMap<String, Entry> children = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    private String name;
    private byte[] content = NOTHING;
    private int attributes;
    private Instant created;
    private Instant accessed;
    private Instant modified;

    Entry(String name, boolean directory, Instant now) {
      this.name = name;
      this.directory = directory;
      attributes = (directory ? FileAttribute.DIRECTORY : FileAttribute.ARCHIVE).code();
      created = now;
      accessed = now;
      modified = now;
    }

    FileItem item(ControllerPath path) {
      return new FileItem(path, directory, content.length, attributes, created, accessed, modified);
    }
  }

  private @Nullable Entry entry(ControllerPath path) {
    Entry entry = root;
    for (String name : path.names()) {
      entry = entry == null ? null : entry.children.get(name);
    }
    return entry;
  }

  private Entry existing(ControllerPath path) {
    return Objects.requireNonNull(entry(path), path::fullName);
  }

  @Override
  public @Nullable FileItem find(ControllerPath path) {
    ControllerPath own = ControllerPath.ROOT;
    Entry entry = root;
    for (String name : path.names()) {
      entry = entry.children.get(name);
      if (entry == null) {
        return null;
      }
      own = own.known(entry.name);
    }
    return entry.item(own);
  }

  @Override
  public List<FileItem> children(ControllerPath folder) {
    List<FileItem> items = new ArrayList<>();
    existing(folder).children.values().forEach(e -> items.add(e.item(folder.known(e.name))));
    return items;
  }

  @Override
  public byte[] read(FileItem file) {
    Entry entry = existing(file.path());
    entry.accessed = clock.instant();
    return entry.content;
  }

  @Override
  public void write(ControllerPath path, byte[] content) {
    Entry entry = entry(path);
    if (entry == null) {
      entry = add(path, false);
    }
    used += content.length - entry.content.length;
    entry.content = content;
    entry.attributes |= FileAttribute.ARCHIVE.code();
    entry.modified = clock.instant();
  }

  @Override
  public void makeFolder(ControllerPath path) {
    add(path, true);
  }

  private Entry add(ControllerPath path, boolean directory) {
    Entry entry = new Entry(path.name(), directory, clock.instant());
    existing(path.parent()).children.put(path.name(), entry);
    used += ITEM_COST;
    return entry;
  }

  @Override
  public void delete(FileItem item) {
    existing(item.path().parent()).children.remove(item.path().name());
    used -= item.size() + ITEM_COST;
  }

  @Override
  public void move(FileItem item, ControllerPath to) {
    Entry entry = existing(item.path());
    existing(item.path().parent()).children.remove(entry.name);
    entry.name = to.name();
    existing(to.parent()).children.put(entry.name, entry);
  }

  @Override
  public void setAttributes(FileItem item, int attributes) {
    existing(item.path()).attributes = attributes;
  }

  @Override
  public long used() {
    return used;
  }
}
