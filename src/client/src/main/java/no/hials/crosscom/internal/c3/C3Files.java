package no.hials.crosscom.internal.c3;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.FileEntry;
import no.hials.crosscom.c3.FileInfo;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.CreateFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.ItemTime;
import no.hials.crosscom.protocol.value.KrlEncoding;
import org.jspecify.annotations.Nullable;

/** Works with files by messages of types 20 to 30. */
public final class C3Files implements ControllerFiles {
  /**
   * Type, attributes and size in a list entry (docs/reference/c3-messages.md#files-20-to-28). The
   * form is known only from an example, so other texts are left unchanged.
   */
  private static final Pattern LONG_INFO = Pattern.compile("(\\d{1,9}),(-?\\d{1,9}),(\\d{1,18})");

  private final MessageChannel channel;
  private final Transfers transfers;

  /** Creates an object that sends its messages on a channel. */
  public C3Files(MessageChannel channel) {
    this.channel = channel;
    this.transfers = new Transfers(channel);
  }

  // --- directories and properties

  @Override
  public List<FileEntry> list(String directory, Set<ItemType> types, Set<ListFlag> flags)
      throws IOException {
    Objects.requireNonNull(types, "types");
    Objects.requireNonNull(flags, "flags");
    String what = "listing of " + checked(directory, "directory");
    ListDirectoryResponse answer =
        channel.ask(
            new ListDirectoryRequest(
                0, Flags.of(ItemType.class, types), Flags.of(ListFlag.class, flags), directory),
            ListDirectoryResponse.class,
            what);
    List<String> items = answer.items();
    List<String> infos = answer.infos();
    if (!infos.isEmpty() && infos.size() != items.size()) {
      throw channel.transferFailed(
          what,
          directory,
          0,
          "there must be as many infos as items, there are "
              + infos.size()
              + " and "
              + items.size());
    }
    List<FileEntry> entries = new ArrayList<>(items.size());
    for (int i = 0; i < items.size(); i++) {
      entries.add(entry(items.get(i), infos.isEmpty() ? "" : infos.get(i)));
    }
    return List.copyOf(entries);
  }

  private static FileEntry entry(String name, String info) {
    Matcher matcher = LONG_INFO.matcher(info);
    if (!matcher.matches()) {
      return new FileEntry(name, Optional.empty(), Optional.empty(), OptionalLong.empty(), info);
    }
    return new FileEntry(
        name,
        Optional.of(new Code<>(ItemType.class, Integer.parseInt(matcher.group(1)))),
        Optional.of(new Flags<>(FileAttribute.class, Integer.parseInt(matcher.group(2)))),
        OptionalLong.of(Long.parseLong(matcher.group(3))),
        info);
  }

  @Override
  public boolean exists(String name) throws IOException {
    return exists(channel, checked(name), "request for the properties of " + name);
  }

  /**
   * Returns whether a file exists.
   *
   * @param what the request for error messages
   */
  static boolean exists(MessageChannel channel, String name, String what) throws CrossComException {
    try {
      askProperties(channel, name, Flags.of(FileProperty.TYPE), what);
      return true;
    } catch (CrossComRefusedException e) {
      if (e.getErrorCode().orElse(null) == ErrorCode.GENERAL) {
        return false;
      }
      throw e;
    }
  }

  @Override
  public FileInfo getProperties(String name) throws IOException {
    return info(
        askProperties(
                channel,
                checked(name),
                Flags.all(FileProperty.class),
                "request for the properties of " + name)
            .properties());
  }

  private static FileInfo info(FileProperties properties) {
    return new FileInfo(
        properties.name(),
        properties.itemType(),
        properties.size(),
        properties.attributes(),
        time(properties.created()),
        time(properties.accessed()),
        time(properties.modified()),
        properties.editMode());
  }

  private static Optional<Instant> time(ItemTime time) {
    return time.ticks() == 0 ? Optional.empty() : Optional.of(time.instant());
  }

  private static FilePropertiesResponse askProperties(
      MessageChannel channel, String name, Flags<FileProperty> properties, String what)
      throws CrossComException {
    return channel.ask(
        new FilePropertiesRequest(0, properties, name), FilePropertiesResponse.class, what);
  }

  @Override
  public String getFullName(String path) throws IOException {
    return name(MessageType.FULL_NAME, path, "request for the full name of ");
  }

  @Override
  public String getKrcName(String path) throws IOException {
    return name(MessageType.KRC_NAME, path, "request for the KRC name of ");
  }

  private String name(MessageType type, String path, String what) throws CrossComException {
    return channel
        .ask(new FileNameRequest(0, type, checked(path, "path")), TextResponse.class, what + path)
        .text();
  }

  // --- changes

  @Override
  public void create(
      String name, ItemType type, Set<ModulePart> parts, @Nullable String template, boolean always)
      throws IOException {
    change(
        new CreateFileRequest(
            0,
            Code.of(Objects.requireNonNull(type, "type")),
            Flags.of(ModulePart.class, Objects.requireNonNull(parts, "parts")),
            always,
            checked(name),
            template == null ? "" : template),
        "creation of " + name);
  }

  @Override
  public void delete(String name, boolean always) throws IOException {
    change(new DeleteFileRequest(0, always, checked(name)), "deletion of " + name);
  }

  @Override
  public void copy(String source, String destination, CopyFlag... flags) throws IOException {
    copy(MessageType.COPY_FILE, source, destination, flags);
  }

  @Override
  public void move(String source, String destination, CopyFlag... flags) throws IOException {
    copy(MessageType.MOVE_FILE, source, destination, flags);
  }

  private void copy(MessageType type, String source, String destination, CopyFlag... flags)
      throws CrossComException {
    change(
        new CopyFileRequest(
            0,
            type,
            Flags.of(CopyFlag.class, List.of(Objects.requireNonNull(flags, "flags"))),
            checked(source, "source"),
            checked(destination, "destination")),
        (type == MessageType.COPY_FILE ? "copying of " : "move of ")
            + source
            + " to "
            + destination);
  }

  @Override
  public void setAttributes(String name, Set<FileAttribute> set, Set<FileAttribute> cleared)
      throws IOException {
    Objects.requireNonNull(set, "set");
    Objects.requireNonNull(cleared, "cleared");
    for (FileAttribute attribute : set) {
      if (cleared.contains(attribute)) {
        throw new IllegalArgumentException(attribute + " cannot be both set and cleared");
      }
    }
    Flags<FileAttribute> attributes = Flags.of(FileAttribute.class, set);
    int mask = attributes.bits() | Flags.of(FileAttribute.class, cleared).bits();
    change(
        new SetAttributesRequest(
            0, attributes, new Flags<>(FileAttribute.class, mask), checked(name)),
        "change of the attributes of " + name);
  }

  private void change(Request request, String what) throws CrossComException {
    channel.ask(request, PlainResponse.class, what);
  }

  private static String checked(String name) {
    return checked(name, "name");
  }

  private static String checked(String name, String parameter) {
    if (Objects.requireNonNull(name, parameter).isBlank()) {
      throw new IllegalArgumentException("a file's name must not be blank");
    }
    return name;
  }

  // --- transfers

  @Override
  public void upload(Path source, String name, TransferConfig config) throws IOException {
    checkNull(source, "source", name, config);
    transfers.upload(source, checked(name), config, Cancellation.NEVER);
  }

  @Override
  public void upload(byte[] content, String name, TransferConfig config) throws IOException {
    checkNull(content, "content", name, config);
    transfers.upload(content, checked(name), config, Cancellation.NEVER);
  }

  @Override
  public void upload(InputStream content, long size, String name, TransferConfig config)
      throws IOException {
    checkNull(content, "content", name, config);
    transfers.upload(content, checkedSize(size), checked(name), config, Cancellation.NEVER);
  }

  @Override
  public void uploadText(String text, String name, TransferConfig config) throws IOException {
    checkNull(text, "text", name, config);
    upload(KrlEncoding.encodeWindows(text), name, config);
  }

  @Override
  public byte[] download(String name, TransferConfig config) throws IOException {
    checkNull(name, "name", name, config);
    return transfers.download(checked(name), config, Cancellation.NEVER);
  }

  @Override
  public void download(String name, Path target, TransferConfig config) throws IOException {
    checkNull(target, "target", name, config);
    transfers.download(checked(name), target, config, Cancellation.NEVER);
  }

  @Override
  public String downloadText(String name, TransferConfig config) throws IOException {
    return KrlEncoding.decode(download(name, config));
  }

  private static long checkedSize(long size) {
    if (size < 0) {
      throw new IllegalArgumentException("size must be 0 or more, is " + size);
    }
    return size;
  }

  // --- transfers in another thread

  @Override
  public CompletableFuture<Void> uploadAsync(Path source, String name, TransferConfig config) {
    checkNull(source, "source", name, config);
    return transferAsync(
        cancellation -> transfers.upload(source, checked(name), config, cancellation));
  }

  @Override
  public CompletableFuture<Void> uploadAsync(byte[] content, String name, TransferConfig config) {
    checkNull(content, "content", name, config);
    return transferAsync(
        cancellation -> transfers.upload(content, checked(name), config, cancellation));
  }

  @Override
  public CompletableFuture<Void> uploadAsync(
      InputStream content, long size, String name, TransferConfig config) {
    checkNull(content, "content", name, config);
    return transferAsync(
        cancellation ->
            transfers.upload(content, checkedSize(size), checked(name), config, cancellation));
  }

  @Override
  public CompletableFuture<Void> uploadTextAsync(String text, String name, TransferConfig config) {
    checkNull(text, "text", name, config);
    return transferAsync(
        cancellation ->
            transfers.upload(KrlEncoding.encodeWindows(text), checked(name), config, cancellation));
  }

  @Override
  public CompletableFuture<byte[]> downloadAsync(String name, TransferConfig config) {
    checkNull(name, "name", name, config);
    return channel.asyncTransfer(
        cancellation -> transfers.download(checked(name), config, cancellation));
  }

  @Override
  public CompletableFuture<Void> downloadAsync(String name, Path target, TransferConfig config) {
    checkNull(target, "target", name, config);
    return transferAsync(
        cancellation -> transfers.download(checked(name), target, config, cancellation));
  }

  @Override
  public CompletableFuture<String> downloadTextAsync(String name, TransferConfig config) {
    checkNull(name, "name", name, config);
    return channel.asyncTransfer(
        cancellation ->
            KrlEncoding.decode(transfers.download(checked(name), config, cancellation)));
  }

  /** Refuses null before a transfer begins, in the thread of the program. */
  private static void checkNull(
      Object local, String parameter, String name, TransferConfig config) {
    Objects.requireNonNull(local, parameter);
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(config, "config");
  }

  /** A transfer. */
  @FunctionalInterface
  private interface CancellableAction {
    void run(Cancellation cancellation) throws IOException;
  }

  private CompletableFuture<Void> transferAsync(CancellableAction action) {
    return channel.asyncTransfer(
        cancellation -> {
          action.run(cancellation);
          return null;
        });
  }

  @Override
  public String toString() {
    return "ControllerFiles{" + channel + "}";
  }
}
