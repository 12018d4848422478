package no.hials.crosscom.c3;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import org.jspecify.annotations.Nullable;

/**
 * Lists, creates, deletes, copies, moves, uploads and downloads the files of the controller. Needs
 * C3 Bridge Interface 1.1.2. Versions before 1.4 have errors with large files
 * (docs/reference/c3-messages.md#server-versions), which appear as failed transfers, because the
 * received content is always checked.
 *
 * <p>Files have names such as {@code KRC:\R1\PROGRAM\X.SRC} or {@code /R1/X.SRC}. The controller
 * decides which forms it accepts; the messages carry all of Unicode. All methods block, except
 * those that end in {@code Async}, and can be called by several threads. On a server without files
 * they throw {@link CrossComUnsupportedException}; if the controller refuses, {@link
 * CrossComRefusedException} with its code. A change of a file is never repeated.
 *
 * <p>An upload or download takes many exchanges, each with the request time-out. Other threads can
 * use the client between them, but it runs only one transfer at a time. If the connection is lost
 * in the middle, the transfer fails, because the server forgets the content:
 *
 * <ul>
 *   <li>If an upload fails, the controller stores nothing, unless the exception says that the
 *       outcome is unknown, or that the file is stored but differs.
 *   <li>A download to a file of this computer is written next to it as {@code NAME.RANDOM.part}.
 *       When it is complete, it replaces the file; if the download fails, it is removed.
 * </ul>
 *
 * <p>The {@code ...Async} methods transfer in the daemon thread {@code crosscom-files-PORT}. They
 * can be cancelled until the transfer takes effect; a cancelled transfer leaves nothing.
 *
 * <p>Programs get this object from {@link no.hials.crosscom.CrossComClient#files}.
 */
public interface ControllerFiles {
  // --- directories and properties

  /**
   * Lists a directory, with the type, attributes and size of each item.
   *
   * @param directory its name
   * @return the items in the server's order
   * @throws CrossComRefusedException if the controller refuses; with {@link ErrorCode#LONG_ANSWER}
   *     if the list does not fit into an answer; with fewer types of items, or without {@link
   *     ListFlag#LONG}, it is shorter
   * @throws CrossComException if the exchange fails
   */
  default List<FileEntry> list(String directory) throws IOException {
    return list(directory, Set.of(), Set.of(ListFlag.LONG));
  }

  /**
   * Lists a directory.
   *
   * @param directory its name
   * @param types the types of items to list; none for all
   * @param flags how to list; without {@link ListFlag#LONG} the server lists only names
   * @return the items in the server's order
   * @throws CrossComRefusedException if the controller refuses, as for {@link #list(String)}
   * @throws CrossComException if the exchange fails
   */
  List<FileEntry> list(String directory, Set<ItemType> types, Set<ListFlag> flags)
      throws IOException;

  /**
   * Returns whether a file or directory exists.
   *
   * @param name its name
   * @return false if the controller refuses with {@link ErrorCode#GENERAL}, the answer of C3 Bridge
   *     for a name that does not exist (docs/reference/c3-messages.md#files-20-to-28)
   * @throws CrossComRefusedException if the controller refuses with another code
   * @throws CrossComException if the exchange fails
   */
  boolean exists(String name) throws IOException;

  /**
   * Returns the properties of a file or directory.
   *
   * @param name its name
   * @return all properties that the controller knows
   * @throws CrossComRefusedException if the controller refuses, for example if the file does not
   *     exist
   * @throws CrossComException if the exchange fails
   */
  FileInfo getProperties(String name) throws IOException;

  /**
   * Returns the full name of a file.
   *
   * @param path such as {@code /R1/TEST.SRC}
   * @return such as {@code KRC:\R1\PROGRAM\TEST.SRC}
   * @throws CrossComRefusedException if the controller refuses, for example if the file does not
   *     exist
   * @throws CrossComException if the exchange fails
   */
  String getFullName(String path) throws IOException;

  /**
   * Returns the short name of a file, the reverse of {@link #getFullName}.
   *
   * @param path such as {@code KRC:\R1\PROGRAM\TEST.SRC}
   * @return such as {@code /R1/TEST.SRC}
   * @throws CrossComRefusedException if the controller refuses, for example if the file does not
   *     exist
   * @throws CrossComException if the exchange fails
   */
  String getKrcName(String path) throws IOException;

  // --- changes

  /**
   * Creates an empty text file. Fails if the name exists.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  default void createFile(String name) throws IOException {
    create(name, ItemType.TEXT, Set.of(), null, false);
  }

  /**
   * Creates a directory in an existing directory. Fails if the name exists.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  default void createDirectory(String name) throws IOException {
    create(name, ItemType.DIRECTORY, Set.of(), null, false);
  }

  /**
   * Creates a module of a SRC and a DAT file. Fails if the name exists.
   *
   * @param name its name, without {@code .SRC} and {@code .DAT}
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  default void createModule(String name) throws IOException {
    create(name, ItemType.MODULE, EnumSet.of(ModulePart.SRC, ModulePart.DAT), null, false);
  }

  /**
   * Creates a file, a module or a directory.
   *
   * @param name its name
   * @param type the type of the item
   * @param parts the parts of a module; none for other types
   * @param template the file or module whose content is copied; null for none
   * @param always whether to replace an existing item
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  void create(
      String name, ItemType type, Set<ModulePart> parts, @Nullable String template, boolean always)
      throws IOException;

  /**
   * Deletes a file or directory. Fails if it is read-only.
   *
   * @param name its name
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  default void delete(String name) throws IOException {
    delete(name, false);
  }

  /**
   * Deletes a file or directory.
   *
   * @param name its name
   * @param always whether to delete it even if it is read-only
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  void delete(String name, boolean always) throws IOException;

  /**
   * Copies a file on the controller.
   *
   * @param source the file
   * @param destination the name of the copy
   * @param flags how to copy; without {@link CopyFlag#OVERWRITE} it fails if the name exists
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  void copy(String source, String destination, CopyFlag... flags) throws IOException;

  /**
   * Moves or renames a file on the controller.
   *
   * @param source the file
   * @param destination its new name
   * @param flags how to copy; without {@link CopyFlag#OVERWRITE} it fails if the name exists
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  void move(String source, String destination, CopyFlag... flags) throws IOException;

  /**
   * Changes attributes of a file or directory. Other attributes stay as they are.
   *
   * @param name its name
   * @param set the attributes to set
   * @param cleared the attributes to clear
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if an attribute is in both
   */
  void setAttributes(String name, Set<FileAttribute> set, Set<FileAttribute> cleared)
      throws IOException;

  // --- transfers

  /**
   * Uploads a file of this computer. Fails if the name exists on the controller.
   *
   * @param source the file
   * @param name the name of the file on the controller
   * @throws CrossComTransferException if the name exists, or the received content differs
   * @throws CrossComRefusedException if the controller refuses
   * @throws CrossComException if an exchange fails
   * @throws IOException if the file of this computer cannot be read
   */
  default void upload(Path source, String name) throws IOException {
    upload(source, name, TransferConfig.DEFAULT);
  }

  /**
   * Uploads a file of this computer.
   *
   * @param source the file
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @throws IOException as for {@link #upload(Path, String)}
   */
  void upload(Path source, String name, TransferConfig config) throws IOException;

  /**
   * Uploads bytes as a file. Fails if the name exists on the controller.
   *
   * @param content the bytes
   * @param name the name of the file on the controller
   * @throws IOException as for {@link #upload(Path, String)}
   */
  default void upload(byte[] content, String name) throws IOException {
    upload(content, name, TransferConfig.DEFAULT);
  }

  /**
   * Uploads bytes as a file.
   *
   * @param content the bytes
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @throws IOException as for {@link #upload(Path, String)}
   */
  void upload(byte[] content, String name, TransferConfig config) throws IOException;

  /**
   * Uploads the content of a stream as a file.
   *
   * @param content read to its end by this thread, and left open
   * @param size the number of bytes in the stream, which the server needs at the beginning
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @throws IOException as for {@link #upload(Path, String)}, if the stream fails, or if it has
   *     more or fewer bytes; nothing is stored then
   */
  void upload(InputStream content, long size, String name, TransferConfig config)
      throws IOException;

  /**
   * Uploads a KRL text in Windows-1252, as a controller writes it
   * (docs/reference/krl-language.md#files). Line ends stay as they are; those of the controller are
   * CR LF.
   *
   * @param text the content
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @throws IOException as for {@link #upload(Path, String)}
   * @throws IllegalArgumentException if Windows-1252 does not have a character of the text
   */
  void uploadText(String text, String name, TransferConfig config) throws IOException;

  /**
   * Downloads a file of at most 64 MiB.
   *
   * @param name its name on the controller
   * @return the content
   * @throws CrossComTransferException if the file is larger, or did not arrive whole
   * @throws CrossComRefusedException if the controller refuses, for example if the file does not
   *     exist
   * @throws CrossComException if an exchange fails
   */
  default byte[] download(String name) throws IOException {
    return download(name, TransferConfig.DEFAULT);
  }

  /**
   * Downloads a file of at most 64 MiB.
   *
   * @param name its name on the controller
   * @param config how to transfer; it overwrites nothing
   * @return the content
   * @throws IOException as for {@link #download(String)}
   */
  byte[] download(String name, TransferConfig config) throws IOException;

  /**
   * Downloads a file to a file of this computer. Fails if that exists.
   *
   * @param name its name on the controller
   * @param target the file to create, in an existing directory
   * @throws CrossComTransferException if the file did not arrive whole
   * @throws CrossComRefusedException if the controller refuses, for example if the file does not
   *     exist
   * @throws CrossComException if an exchange fails
   * @throws IOException if the file of this computer exists or cannot be written
   */
  default void download(String name, Path target) throws IOException {
    download(name, target, TransferConfig.DEFAULT);
  }

  /**
   * Downloads a file to a file of this computer. A symbolic link stays, and the file that it points
   * to is replaced; a device, a pipe or a link to nothing is refused.
   *
   * @param name its name on the controller
   * @param target the file to create or replace, in an existing directory
   * @param config how to transfer
   * @throws IOException as for {@link #download(String, Path)}
   */
  void download(String name, Path target, TransferConfig config) throws IOException;

  /**
   * Downloads a KRL text: in UTF-8, with or without a byte order mark, if all of the file is valid
   * UTF-8, otherwise in Windows-1252 (docs/reference/krl-language.md#files). Line ends stay as they
   * are.
   *
   * @param name its name on the controller
   * @param config how to transfer; it overwrites nothing
   * @return the content, without a byte order mark
   * @throws IOException as for {@link #download(String)}
   */
  String downloadText(String name, TransferConfig config) throws IOException;

  // --- transfers in another thread

  /**
   * Works like {@link #upload(Path, String, TransferConfig)} in another thread.
   *
   * @param source the file
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @return completes at the end; if it is cancelled before all is sent, nothing is stored
   */
  CompletableFuture<Void> uploadAsync(Path source, String name, TransferConfig config);

  /**
   * Works like {@link #upload(byte[], String, TransferConfig)} in another thread.
   *
   * @param content the bytes, which must not change until the upload is done
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @return completes at the end; if it is cancelled before all is sent, nothing is stored
   */
  CompletableFuture<Void> uploadAsync(byte[] content, String name, TransferConfig config);

  /**
   * Works like {@link #upload(InputStream, long, String, TransferConfig)} in another thread.
   *
   * @param content read to its end, and left open
   * @param size the number of bytes in the stream
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @return completes at the end; if it is cancelled before all is sent, nothing is stored
   */
  CompletableFuture<Void> uploadAsync(
      InputStream content, long size, String name, TransferConfig config);

  /**
   * Works like {@link #uploadText} in another thread.
   *
   * @param text the content
   * @param name the name of the file on the controller
   * @param config how to transfer
   * @return completes at the end; if it is cancelled before all is sent, nothing is stored
   */
  CompletableFuture<Void> uploadTextAsync(String text, String name, TransferConfig config);

  /**
   * Works like {@link #download(String, TransferConfig)} in another thread.
   *
   * @param name its name on the controller
   * @param config how to transfer; it overwrites nothing
   * @return completes with the content
   */
  CompletableFuture<byte[]> downloadAsync(String name, TransferConfig config);

  /**
   * Works like {@link #download(String, Path, TransferConfig)} in another thread.
   *
   * @param name its name on the controller
   * @param target the file to create or replace, in an existing directory
   * @param config how to transfer
   * @return completes at the end; if it is cancelled before all has arrived, no file is left
   */
  CompletableFuture<Void> downloadAsync(String name, Path target, TransferConfig config);

  /**
   * Works like {@link #downloadText} in another thread.
   *
   * @param name its name on the controller
   * @param config how to transfer; it overwrites nothing
   * @return completes with the content
   */
  CompletableFuture<String> downloadTextAsync(String name, TransferConfig config);
}
