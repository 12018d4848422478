package no.hials.crosscom.simulator;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.internal.files.ControllerFileSystem;

/**
 * The files of the simulated controller. Clients access them with messages 20 to 30 of C3 Bridge,
 * Java code with this interface.
 *
 * <p>A name is {@code KRC:\R1\Program\X.SRC}, in any case and with either kind of slash, or {@code
 * /R1/X.SRC}, which finds a file in any folder below {@code R1}, in {@code Program} first; a new
 * file goes into {@code Program}. The folders are those of a KR C4: {@code KRC:\R1} with {@code
 * Mada}, {@code Program}, {@code System} and {@code TP}, and {@code KRC:\STEU\Mada}.
 *
 * <p>Thread-safe. It creates no threads. Not for implementation by users: a controller and a server
 * accept only the trees that this interface creates.
 */
public interface FileTree {
  /** The default capacity of a tree: 64 MiB. */
  long DEFAULT_CAPACITY = 64L << 20;

  /**
   * Creates a tree in memory with the data lists {@code $machine.dat} and {@code $config.dat} of
   * the built-in table, and no program.
   *
   * @return the tree
   */
  static FileTree inMemory() {
    return inMemory(java.time.Clock.systemUTC(), DEFAULT_CAPACITY);
  }

  /**
   * Creates a tree in memory, as {@link #inMemory()} does.
   *
   * @param clock the source of the files' times, and of the controller's time zone
   * @param capacity the maximum bytes, 1 MiB or more; each file counts 512 bytes more than its
   *     content. Transfers can use as much again
   * @return the tree
   */
  static FileTree inMemory(java.time.Clock clock, long capacity) {
    try {
      return ControllerFileSystem.inMemory(clock, capacity);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Opens a folder of this machine as a tree. Clients change its files. They cannot access anything
   * outside: names with {@code ..} are refused, and so are links, even those to a file in the
   * folder, whether to read, write, move or delete. Missing folders of a KR C4 are created.
   *
   * <p>The attributes that clients set, read-only too, are kept in memory only.
   *
   * @param folder the folder that becomes {@code KRC:\}
   * @return the tree
   * @throws IOException if the folder cannot be used
   */
  static FileTree over(Path folder) throws IOException {
    return over(folder, java.time.Clock.systemUTC(), DEFAULT_CAPACITY);
  }

  /**
   * Opens a folder of this machine as a tree, as {@link #over(Path)} does.
   *
   * @param folder the folder that becomes {@code KRC:\}
   * @param clock the source of the controller's time zone; the times are those of the files
   * @param capacity as for {@link #inMemory(java.time.Clock, long)}; includes the files in the
   *     folder
   * @return the tree
   * @throws IOException if the folder cannot be used
   */
  static FileTree over(Path folder, java.time.Clock clock, long capacity) throws IOException {
    return ControllerFileSystem.over(folder, clock, capacity);
  }

  /**
   * Returns whether the files are in memory, not in a folder of this machine.
   *
   * @return true if they are in memory
   */
  boolean isInMemory();

  /**
   * Writes a file, even if it is read-only or selected, and creates missing folders.
   *
   * @param name its full or KRC name
   * @param content the whole content
   * @throws IOException if the name is invalid or that of a folder, or the tree is full
   */
  void put(String name, byte[] content) throws IOException;

  /**
   * Writes a file of text, as {@link #put(String, byte[])} does.
   *
   * @param name its full or KRC name
   * @param text the whole text; written as {@link KrlEncoding#encode} does
   * @throws IOException if the name is invalid or that of a folder, the tree is full, or a
   *     character is half a surrogate pair
   */
  default void put(String name, String text) throws IOException {
    put(name, KrlEncoding.encode(text));
  }

  /**
   * Reads a file.
   *
   * @param name its full or KRC name
   * @return its content, a copy
   * @throws IOException if it does not exist or is a folder
   */
  byte[] get(String name) throws IOException;

  /**
   * Reads a file of text.
   *
   * @param name its full or KRC name
   * @return its content, read as {@link KrlEncoding#decode} does; empty if the file does not exist
   */
  default Optional<String> text(String name) {
    try {
      return Optional.of(KrlEncoding.decode(get(name)));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns whether a file or folder exists.
   *
   * @param name its full or KRC name; false for an invalid name
   * @return true if it exists
   */
  boolean exists(String name);

  /**
   * Lists a folder.
   *
   * @param folder its full or KRC name
   * @return the names in it, without that of the folder; sorted, ignoring case
   * @throws IOException if it does not exist or is not a folder
   */
  List<String> list(String folder) throws IOException;

  /**
   * Deletes a file, even if it is read-only or selected, or a folder with its content.
   *
   * @param name its full or KRC name
   * @throws IOException if it does not exist, or is {@code KRC:\} or a folder directly in it
   */
  void delete(String name) throws IOException;
}
