package no.hials.crosscom.c3;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
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
import no.hials.crosscom.protocol.file.CopyFileRequest;
import no.hials.crosscom.protocol.file.CreateFileRequest;
import no.hials.crosscom.protocol.file.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileNameRequest;
import no.hials.crosscom.protocol.file.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.SetAttributesRequest;
import org.jspecify.annotations.Nullable;

/**
 * Works with the files of the controller: lists, creates, deletes, copies, moves, uploads and
 * downloads them. Needs C3 Bridge Interface 1.1.2; before 1.4 it has errors with large files
 * (c3-bridge.md, "Minimum server versions"), which show as failed transfers, since what arrived is
 * always checked.
 *
 * <p>Files have names such as {@code KRC:\R1\PROGRAM\X.SRC} or {@code /R1/X.SRC}; which form the
 * controller takes is up to it, and the messages carry all of Unicode. Every method blocks and may
 * be called by several threads; its {@code ...Async} twin does the same in another thread. On a
 * server without files all throw {@link CrossComUnsupportedException}; what the controller refuses
 * is a {@link CrossComRefusedException} with its code. What changes a file is never repeated.
 *
 * <p>Uploads and downloads are many exchanges, each with the request time-out. Between them other
 * threads have their turn, but only one transfer of a client is under way at a time. A connection
 * that is lost in the middle ends the transfer, as the server forgets what it had of it:
 *
 * <ul>
 *   <li>Of an upload that fails, the controller has nothing, unless the exception says otherwise:
 *       that the outcome is unknown, or that the file is stored but differs.
 *   <li>A download to a file of this computer is written beside it as {@code NAME.RANDOM.part},
 *       which takes its place when all of it is there, and is removed if the download fails.
 * </ul>
 *
 * <p>The {@code ...Async} twins of transfers run in the daemon thread {@code crosscom-files-PORT}.
 * They can be cancelled until what they do takes effect, and nothing is left of them then.
 */
public final class ControllerFiles {
  /** KRL files have one byte a character; that it is this code page is assumed, as for values. */
  private static final Charset TEXT = StandardCharsets.ISO_8859_1;

  private static final Set<ModulePart> SRC_DAT = EnumSet.of(ModulePart.SRC, ModulePart.DAT);

  private final MessageChannel link;
  private final Transfers transfers;

  /**
   * For the client.
   *
   * @param link sends the messages
   * @param turn held by the transfer that is under way
   */
  public ControllerFiles(MessageChannel link, ReentrantLock turn) {
    this.link = link;
    this.transfers = new Transfers(link, turn);
  }

  // --- directories and properties

  /**
   * Lists a directory, with the type, attributes and size of each item.
   *
   * @param directory its name
   * @return the items in the server's order
   * @throws CrossComRefusedException if the controller refused; with {@link ErrorCode#LONG_ANSWER}
   *     if the list does not fit into an answer: fewer types of items, or no {@link ListFlag#LONG},
   *     make it shorter
   * @throws CrossComException if the exchange failed
   */
  public List<FileEntry> list(String directory) throws IOException {
    return list(directory, Set.of(), Set.of(ListFlag.LONG));
  }

  /**
   * Lists a directory.
   *
   * @param directory its name
   * @param types the types of items to list; none for all
   * @param flags how; only with {@link ListFlag#LONG} the server says more than names
   * @return the items in the server's order
   * @throws CrossComRefusedException if the controller refused, as {@link #list(String)}
   * @throws CrossComException if the exchange failed
   */
  public List<FileEntry> list(String directory, Set<ItemType> types, Set<ListFlag> flags)
      throws IOException {
    String what = "listing of " + checked(directory);
    ListDirectoryResponse answer =
        link.ask(
            new ListDirectoryRequest(
                0, Flags.of(ItemType.class, types), Flags.of(ListFlag.class, flags), directory),
            ListDirectoryResponse.class,
            what);
    List<String> items = answer.items();
    List<String> infos = answer.infos();
    if (!infos.isEmpty() && infos.size() != items.size()) {
      throw link.transferFailed(
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
      entries.add(FileEntry.of(items.get(i), infos.isEmpty() ? "" : infos.get(i)));
    }
    return List.copyOf(entries);
  }

  /**
   * Says whether there is a file or directory.
   *
   * @param name its name
   * @return false if the controller refuses to give its type with {@link ErrorCode#GENERAL}, as C3
   *     Bridge does for one that is not there (c3-vectors.tsv, type 26)
   * @throws CrossComRefusedException if it refuses with another code
   * @throws CrossComException if the exchange failed
   */
  public boolean exists(String name) throws IOException {
    return exists(link, checked(name));
  }

  static boolean exists(MessageChannel link, String name) throws CrossComException {
    try {
      askProperties(link, name, Flags.of(FileProperty.TYPE));
      return true;
    } catch (CrossComRefusedException e) {
      if (e.getErrorCode().orElse(null) == ErrorCode.GENERAL) {
        return false;
      }
      throw e;
    }
  }

  /**
   * Gives the properties of a file or directory.
   *
   * @param name its name
   * @return all that the controller knows
   * @throws CrossComRefusedException if the controller refused, as for a file that is not there
   * @throws CrossComException if the exchange failed
   */
  public FileInfo getProperties(String name) throws IOException {
    return FileInfo.of(
        askProperties(link, checked(name), Flags.all(FileProperty.class)).properties());
  }

  private static FilePropertiesResponse askProperties(
      MessageChannel link, String name, Flags<FileProperty> properties) throws CrossComException {
    return link.ask(
        new FilePropertiesRequest(0, properties, name),
        FilePropertiesResponse.class,
        "request for the properties of " + name);
  }

  /**
   * Gives the name of a file in the tree of the controller.
   *
   * @param path such as {@code /R1/TEST.SRC}
   * @return such as {@code KRC:\R1\PROGRAM\TEST.SRC}
   * @throws CrossComRefusedException if the controller refused, as for a file that is not there
   * @throws CrossComException if the exchange failed
   */
  public String getFullName(String path) throws IOException {
    return name(MessageType.FULL_NAME, path, "request for the full name of ");
  }

  /**
   * Gives the short name of a file, the reverse of {@link #getFullName}.
   *
   * @param path such as {@code KRC:\R1\PROGRAM\TEST.SRC}
   * @return such as {@code /R1/TEST.SRC}
   * @throws CrossComRefusedException if the controller refused, as for a file that is not there
   * @throws CrossComException if the exchange failed
   */
  public String getKrcName(String path) throws IOException {
    return name(MessageType.KRC_NAME, path, "request for the KRC name of ");
  }

  private String name(MessageType type, String path, String what) throws CrossComException {
    return link.ask(new FileNameRequest(0, type, checked(path)), TextResponse.class, what + path)
        .text();
  }

  // --- changes

  /**
   * Creates an empty text file, or fails if there is one.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void createFile(String name) throws IOException {
    create(name, ItemType.TEXT, Set.of(), null, false);
  }

  /**
   * Creates a directory, or fails if there is one. The one above has to be there.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void createDirectory(String name) throws IOException {
    create(name, ItemType.DIRECTORY, Set.of(), null, false);
  }

  /**
   * Creates a module of a SRC and a DAT file, or fails if there is one.
   *
   * @param name its name, without {@code .SRC} and {@code .DAT}
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void createModule(String name) throws IOException {
    create(name, ItemType.MODULE, SRC_DAT, null, false);
  }

  /**
   * Creates a file, a module or a directory.
   *
   * @param name its name
   * @param type what it is to be
   * @param parts what a module is to have; none for other types
   * @param template the file or module from which to take the content; null for none
   * @param always whether one that is there already is replaced
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void create(
      String name, ItemType type, Set<ModulePart> parts, @Nullable String template, boolean always)
      throws IOException {
    change(
        new CreateFileRequest(
            0,
            Code.of(type),
            Flags.of(ModulePart.class, parts),
            always,
            checked(name),
            template == null ? "" : template),
        "creation of " + name);
  }

  /**
   * Deletes a file or directory, or fails if it is read-only.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void delete(String name) throws IOException {
    delete(name, false);
  }

  /**
   * Deletes a file or directory.
   *
   * @param name its name
   * @param always whether to do so although it is read-only
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void delete(String name, boolean always) throws IOException {
    change(new DeleteFileRequest(0, always, checked(name)), "deletion of " + name);
  }

  /**
   * Copies a file on the controller.
   *
   * @param source the file
   * @param destination the name of the copy
   * @param flags how; without {@link CopyFlag#OVERWRITE} it fails if there is a file of this name
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void copy(String source, String destination, CopyFlag... flags) throws IOException {
    copy(MessageType.COPY_FILE, source, destination, flags);
  }

  /**
   * Moves or renames a file on the controller.
   *
   * @param source the file
   * @param destination its new name
   * @param flags how; without {@link CopyFlag#OVERWRITE} it fails if there is a file of this name
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public void move(String source, String destination, CopyFlag... flags) throws IOException {
    copy(MessageType.MOVE_FILE, source, destination, flags);
  }

  private void copy(MessageType type, String source, String destination, CopyFlag... flags)
      throws CrossComException {
    change(
        new CopyFileRequest(
            0,
            type,
            Flags.of(CopyFlag.class, List.of(flags)),
            checked(source),
            checked(destination)),
        (type == MessageType.COPY_FILE ? "copying of " : "move of ")
            + source
            + " to "
            + destination);
  }

  /**
   * Changes attributes of a file or directory; those that are not named stay as they are.
   *
   * @param name its name
   * @param set the attributes to be set
   * @param cleared the attributes to be cleared
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if the exchange failed
   * @throws IllegalArgumentException if an attribute is to be both
   */
  public void setAttributes(String name, Set<FileAttribute> set, Set<FileAttribute> cleared)
      throws IOException {
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
    link.ask(request, PlainResponse.class, what);
  }

  private static String checked(String name) {
    if (name.isBlank()) {
      throw new IllegalArgumentException("a file's name must not be blank");
    }
    return name;
  }

  // --- transfers

  /**
   * Uploads a file of this computer, or fails if the controller has one of this name.
   *
   * @param source the file
   * @param name the name it is to have on the controller
   * @throws CrossComTransferException if the file is there, or what arrived is not what was sent
   * @throws CrossComRefusedException if the controller refused
   * @throws CrossComException if an exchange failed
   * @throws IOException if the file of this computer cannot be read
   */
  public void upload(Path source, String name) throws IOException {
    upload(source, name, TransferConfig.DEFAULT);
  }

  /**
   * Uploads a file of this computer.
   *
   * @param source the file
   * @param name the name it is to have on the controller
   * @param config how
   * @throws IOException as for {@link #upload(Path, String)}
   */
  public void upload(Path source, String name, TransferConfig config) throws IOException {
    transfers.upload(source, checked(name), config, Cancellation.NEVER);
  }

  /**
   * Uploads bytes as a file, or fails if the controller has one of this name.
   *
   * @param content the bytes
   * @param name the name of the file on the controller
   * @throws IOException as for {@link #upload(Path, String)}
   */
  public void upload(byte[] content, String name) throws IOException {
    upload(content, name, TransferConfig.DEFAULT);
  }

  /**
   * Uploads bytes as a file.
   *
   * @param content the bytes
   * @param name the name of the file on the controller
   * @param config how
   * @throws IOException as for {@link #upload(Path, String)}
   */
  public void upload(byte[] content, String name, TransferConfig config) throws IOException {
    transfers.upload(content, checked(name), config, Cancellation.NEVER);
  }

  /**
   * Uploads what a stream gives as a file.
   *
   * @param content read to its end by this thread, and left open
   * @param size how many bytes it gives; the server has to be told at the beginning
   * @param name the name of the file on the controller
   * @param config how
   * @throws IOException as for {@link #upload(Path, String)}, or if the stream fails; also if it
   *     gives more or fewer bytes, and nothing is stored then
   */
  public void upload(InputStream content, long size, String name, TransferConfig config)
      throws IOException {
    transfers.upload(content, checkedSize(size), checked(name), config, Cancellation.NEVER);
  }

  /**
   * Uploads a KRL text, in ISO 8859-1 and with its line ends as they are; the controller's own are
   * CR LF.
   *
   * @param text the content
   * @param name the name of the file on the controller
   * @param config how
   * @throws IOException as for {@link #upload(Path, String)}
   * @throws IllegalArgumentException if the text is not ISO 8859-1
   */
  public void uploadText(String text, String name, TransferConfig config) throws IOException {
    upload(encoded(text), name, config);
  }

  /**
   * Downloads a file of at most 64 MiB.
   *
   * @param name its name on the controller
   * @return its content
   * @throws CrossComTransferException if it is larger, or what came is not the whole file
   * @throws CrossComRefusedException if the controller refused, as for a file that is not there
   * @throws CrossComException if an exchange failed
   */
  public byte[] download(String name) throws IOException {
    return download(name, TransferConfig.DEFAULT);
  }

  /**
   * Downloads a file of at most 64 MiB.
   *
   * @param name its name on the controller
   * @param config how; it overwrites nothing
   * @return its content
   * @throws IOException as for {@link #download(String)}
   */
  public byte[] download(String name, TransferConfig config) throws IOException {
    return transfers.download(checked(name), config, Cancellation.NEVER);
  }

  /**
   * Downloads a file to one of this computer, or fails if that is there.
   *
   * @param name its name on the controller
   * @param target the file to be made, in a directory that is there
   * @throws CrossComTransferException if what came is not the whole file
   * @throws CrossComRefusedException if the controller refused, as for a file that is not there
   * @throws CrossComException if an exchange failed
   * @throws IOException if the file of this computer is there or cannot be written
   */
  public void download(String name, Path target) throws IOException {
    download(name, target, TransferConfig.DEFAULT);
  }

  /**
   * Downloads a file to one of this computer.
   *
   * @param name its name on the controller
   * @param target the file to be made or replaced, in a directory that is there
   * @param config how
   * @throws IOException as for {@link #download(String, Path)}
   */
  public void download(String name, Path target, TransferConfig config) throws IOException {
    transfers.download(checked(name), target, config, Cancellation.NEVER);
  }

  /**
   * Downloads a KRL text, in ISO 8859-1 and with its line ends as they are.
   *
   * @param name its name on the controller
   * @param config how; it overwrites nothing
   * @return the content
   * @throws IOException as for {@link #download(String)}
   */
  public String downloadText(String name, TransferConfig config) throws IOException {
    return new String(download(name, config), TEXT);
  }

  private static long checkedSize(long size) {
    if (size < 0) {
      throw new IllegalArgumentException("size must be 0 or more, is " + size);
    }
    return size;
  }

  private static byte[] encoded(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) > 0xFF) {
        throw new IllegalArgumentException(
            String.format(
                "the text must be ISO 8859-1, has U+%04X at index %d", (int) text.charAt(i), i));
      }
    }
    return text.getBytes(TEXT);
  }

  // --- the same in another thread

  /**
   * Does what {@link #upload(Path, String, TransferConfig)} does, in another thread.
   *
   * @param source the file
   * @param name the name it is to have on the controller
   * @param config how
   * @return the result to come; cancelled before all is sent, nothing is stored
   */
  public CompletableFuture<Void> uploadAsync(Path source, String name, TransferConfig config) {
    return transferAsync(
        cancellation -> transfers.upload(source, checked(name), config, cancellation));
  }

  /**
   * Does what {@link #upload(byte[], String, TransferConfig)} does, in another thread.
   *
   * @param content the bytes, not to be changed until it is done
   * @param name the name of the file on the controller
   * @param config how
   * @return the result to come; cancelled before all is sent, nothing is stored
   */
  public CompletableFuture<Void> uploadAsync(byte[] content, String name, TransferConfig config) {
    return transferAsync(
        cancellation -> transfers.upload(content, checked(name), config, cancellation));
  }

  /**
   * Does what {@link #upload(InputStream, long, String, TransferConfig)} does, in another thread.
   *
   * @param content read to its end, and left open
   * @param size how many bytes it gives
   * @param name the name of the file on the controller
   * @param config how
   * @return the result to come; cancelled before all is sent, nothing is stored
   */
  public CompletableFuture<Void> uploadAsync(
      InputStream content, long size, String name, TransferConfig config) {
    return transferAsync(
        cancellation ->
            transfers.upload(content, checkedSize(size), checked(name), config, cancellation));
  }

  /**
   * Does what {@link #uploadText} does, in another thread.
   *
   * @param text the content
   * @param name the name of the file on the controller
   * @param config how
   * @return the result to come; cancelled before all is sent, nothing is stored
   */
  public CompletableFuture<Void> uploadTextAsync(String text, String name, TransferConfig config) {
    return transferAsync(
        cancellation -> transfers.upload(encoded(text), checked(name), config, cancellation));
  }

  /**
   * Does what {@link #download(String, TransferConfig)} does, in another thread.
   *
   * @param name its name on the controller
   * @param config how; it overwrites nothing
   * @return the result to come
   */
  public CompletableFuture<byte[]> downloadAsync(String name, TransferConfig config) {
    return link.asyncTransfer(
        cancellation -> transfers.download(checked(name), config, cancellation));
  }

  /**
   * Does what {@link #download(String, Path, TransferConfig)} does, in another thread.
   *
   * @param name its name on the controller
   * @param target the file to be made or replaced, in a directory that is there
   * @param config how
   * @return the result to come; cancelled before all has come, no file is left
   */
  public CompletableFuture<Void> downloadAsync(String name, Path target, TransferConfig config) {
    return transferAsync(
        cancellation -> transfers.download(checked(name), target, config, cancellation));
  }

  /**
   * Does what {@link #downloadText} does, in another thread.
   *
   * @param name its name on the controller
   * @param config how; it overwrites nothing
   * @return the result to come
   */
  public CompletableFuture<String> downloadTextAsync(String name, TransferConfig config) {
    return link.asyncTransfer(
        cancellation -> new String(transfers.download(checked(name), config, cancellation), TEXT));
  }

  /** Transfers something. */
  @FunctionalInterface
  private interface CancellableAction {
    void run(Cancellation cancellation) throws IOException;
  }

  private CompletableFuture<Void> transferAsync(CancellableAction action) {
    return link.asyncTransfer(
        cancellation -> {
          action.run(cancellation);
          return null;
        });
  }

  @Override
  public String toString() {
    return "ControllerFiles{" + link + "}";
  }
}
