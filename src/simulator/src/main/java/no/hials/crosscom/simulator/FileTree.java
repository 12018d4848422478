package no.hials.crosscom.simulator;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;
import no.hials.crosscom.simulator.internal.files.ControllerFileSystem;

/**
 * The files of the simulated controller, which clients reach with the messages 20 to 30 of C3
 * Bridge and Java code with this class.
 *
 * <p>Names are {@code KRC:\R1\Program\X.SRC}, in any case and with either kind of slash, or {@code
 * /R1/X.SRC}, which finds a file wherever below {@code R1} it is, in {@code Program} first; a new
 * one comes into {@code Program}. The folders are those that a KR C4 has: {@code KRC:\R1} with
 * {@code Mada}, {@code Program}, {@code System} and {@code TP}, and {@code KRC:\STEU\Mada}.
 *
 * <p>Thread-safe. It creates no threads.
 */
public final class FileTree {
  /** How many bytes a tree holds if nothing else is said: 64 MiB. */
  public static final long DEFAULT_CAPACITY = 64L << 20;

  private final ControllerFileSystem tree;
  private final boolean inMemory;

  private FileTree(ControllerFileSystem tree, boolean inMemory) {
    this.tree = tree;
    this.inMemory = inMemory;
  }

  /**
   * Makes a tree in memory that has the data lists {@code $machine.dat} and {@code $config.dat} of
   * the built-in table, and no program.
   *
   * @return the tree
   */
  public static FileTree inMemory() {
    return inMemory(java.time.Clock.systemUTC(), DEFAULT_CAPACITY);
  }

  /**
   * Makes a tree as {@link #inMemory()} does.
   *
   * @param clock gives the times of the files, and the controller's time zone
   * @param capacity how many bytes it holds, 1 MiB or more; a file counts 512 bytes more than its
   *     content. As much again is for files that are on their way
   * @return the tree
   */
  public static FileTree inMemory(java.time.Clock clock, long capacity) {
    FileTree files = new FileTree(ControllerFileSystem.inMemory(clock, checked(capacity)), true);
    try {
      files.put("KRC:\\R1\\Mada\\$machine.dat", BuiltInDataLists.text("$MACHINE.DAT"));
      files.put("KRC:\\R1\\System\\$config.dat", BuiltInDataLists.text("$CONFIG.DAT"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return files;
  }

  /**
   * Makes a tree of a folder of this machine. What clients do happens to its files. They never
   * reach anything outside: names with {@code ..} and the like are refused, and links are not
   * followed. The folders of a KR C4 are made if they are missing.
   *
   * <p>The attributes that clients set, read-only too, are kept in memory only.
   *
   * @param folder what {@code KRC:\} is
   * @return the tree
   * @throws IOException if the folder cannot be used
   */
  public static FileTree over(Path folder) throws IOException {
    return over(folder, java.time.Clock.systemUTC(), DEFAULT_CAPACITY);
  }

  /**
   * Makes a tree as {@link #over(Path)} does.
   *
   * @param folder what {@code KRC:\} is
   * @param clock gives the controller's time zone; the times are the files'
   * @param capacity as for {@link #inMemory(java.time.Clock, long)}; what is in the folder counts
   * @return the tree
   * @throws IOException if the folder cannot be used
   */
  public static FileTree over(Path folder, java.time.Clock clock, long capacity)
      throws IOException {
    Objects.requireNonNull(clock, "clock");
    return new FileTree(ControllerFileSystem.over(folder, clock, checked(capacity)), false);
  }

  private static long checked(long capacity) {
    if (capacity < 1 << 20) {
      throw new IllegalArgumentException("capacity must be 1 MiB or more, is " + capacity);
    }
    return capacity;
  }

  /**
   * Returns the file system behind this view, as C3 Bridge reaches it.
   *
   * @return the file system
   */
  public ControllerFileSystem tree() {
    return tree;
  }

  /**
   * Returns whether the files are in memory, not in a folder of this machine.
   *
   * @return true if they are in memory
   */
  public boolean isInMemory() {
    return inMemory;
  }

  /**
   * Writes a file, read-only or selected or not, and makes the folders that it needs.
   *
   * @param name its full or KRC name
   * @param content all of it
   * @throws IOException if the name is none, is that of a folder, or there is no room
   */
  public void put(String name, byte[] content) throws IOException {
    tree.put(name, content.clone());
  }

  /**
   * Writes a file of text, as {@link #put(String, byte[])} does.
   *
   * @param name its full or KRC name
   * @param text all of it; written as ISO 8859-1, as KRL is
   * @throws IOException if the name is none, is that of a folder, or there is no room
   */
  public void put(String name, String text) throws IOException {
    tree.put(name, text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /**
   * Reads a file.
   *
   * @param name its full or KRC name
   * @return its content, a copy
   * @throws IOException if it is not there or a folder
   */
  public byte[] get(String name) throws IOException {
    return tree.read(name).clone();
  }

  /**
   * Reads a file of text.
   *
   * @param name its full or KRC name
   * @return its content, read as ISO 8859-1; nothing if there is no such file
   */
  public Optional<String> text(String name) {
    try {
      return Optional.of(new String(tree.read(name), StandardCharsets.ISO_8859_1));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /**
   * Says whether there is a file or a folder.
   *
   * @param name its full or KRC name, or anything
   * @return true if so
   */
  public boolean exists(String name) {
    try {
      tree.item(name);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Lists a folder.
   *
   * @param folder its full or KRC name
   * @return the names in it, without that of the folder; sorted, whatever their case
   * @throws IOException if it is not there or no folder
   */
  public List<String> list(String folder) throws IOException {
    return tree.names(folder);
  }

  /**
   * Deletes a file, read-only or selected or not, or a folder with all that is in it.
   *
   * @param name its full or KRC name
   * @throws IOException if it is not there, or {@code KRC:\} or a folder directly in it
   */
  public void delete(String name) throws IOException {
    tree.delete(name, true, module -> false);
  }
}
