package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ModulePart;

/** Creates files, modules and folders as message 22 of C3 Bridge asks for. Not thread-safe. */
final class ItemCreator {
  private final ItemStore store;
  private final FileNameResolver names;
  private final CheckedWriter writer;

  ItemCreator(ItemStore store, FileNameResolver names, CheckedWriter writer) {
    this.store = store;
    this.names = names;
    this.writer = writer;
  }

  void create(
      String name,
      ItemType type,
      Flags<ModulePart> parts,
      boolean always,
      String template,
      Predicate<String> inUse)
      throws IOException {
    switch (type) {
      case DIRECTORY -> createFolder(names.resolve(name), always);
      case MODULE -> createFiles(moduleFiles(name, parts, template), always, inUse);
      case BINARY, TEXT, RAW -> {
        byte[] content =
            template.isEmpty() ? new byte[0] : store.read(names.existingFile(template));
        createFiles(Map.of(names.resolve(name), content), always, inUse);
      }
      default ->
          throw FileRefusedException.argument("an item of type " + type + " cannot be created");
    }
  }

  private void createFolder(ControllerPath path, boolean always) throws IOException {
    FileItem old = store.find(path);
    if (old == null) {
      writer.makeFolder(path);
    } else if (!always || !old.directory()) {
      throw FileRefusedException.access(path, "already exists");
    }
  }

  private Map<ControllerPath, byte[]> moduleFiles(
      String name, Flags<ModulePart> parts, String template) throws IOException {
    boolean ended = FileItem.isModule(name);
    String base = ended ? FileItem.base(name) : name;
    List<String> extensions = new ArrayList<>();
    for (ModulePart part : List.of(ModulePart.SUB, ModulePart.SRC, ModulePart.DAT)) {
      if (parts.has(part)) {
        extensions.add(part.name().toLowerCase(Locale.ROOT));
      }
    }
    if (extensions.isEmpty() && ended) {
      extensions.add(FileItem.extension(name));
    }
    if (extensions.isEmpty()) {
      throw FileRefusedException.argument("a module needs a part, the flags are " + parts);
    }
    Map<ControllerPath, byte[]> files = new LinkedHashMap<>();
    for (String extension : extensions) {
      ControllerPath path = names.resolve(base + "." + extension);
      files.put(path, content(path, extension, template));
    }
    return files;
  }

  private byte[] content(ControllerPath path, String extension, String template)
      throws IOException {
    if (!template.isEmpty()) {
      String base = FileItem.isModule(template) ? FileItem.base(template) : template;
      return store.read(names.existingFile(base + "." + extension));
    }
    String name = FileItem.base(path.name());
    String text =
        extension.equals("dat")
            ? "DEFDAT " + name + "\r\nENDDAT\r\n"
            : "DEF " + name + "( )\r\nEND\r\n";
    return ("&ACCESS RVP\r\n" + text).getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Creates all of the files or none. */
  private void createFiles(
      Map<ControllerPath, byte[]> files, boolean always, Predicate<String> inUse)
      throws IOException {
    long bytes = 0;
    for (Map.Entry<ControllerPath, byte[]> file : files.entrySet()) {
      ControllerPath path = file.getKey();
      names.asStored(path);
      FileItem old = store.find(path);
      CheckedWriter.refuseFolder(path, old);
      if (old != null && !always) {
        throw FileRefusedException.access(path, "already exists");
      }
      if (old != null) {
        writer.refuseInUse(old, inUse);
      }
      bytes += file.getValue().length + (long) ItemStore.ITEM_COST;
    }
    writer.reserve(bytes, files.keySet().iterator().next());
    for (Map.Entry<ControllerPath, byte[]> file : files.entrySet()) {
      writer.write(file.getKey(), file.getValue(), store.find(file.getKey()));
    }
  }
}
