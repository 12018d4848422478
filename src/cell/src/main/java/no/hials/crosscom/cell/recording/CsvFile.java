package no.hials.crosscom.cell.recording;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Printable;

/** Reads CSV files (RFC 4180, UTF-8), with a byte order mark or without. */
public final class CsvFile {
  private CsvFile() {}

  /** Converts rows. */
  @FunctionalInterface
  public interface Contents<T> {
    T of(Iterable<CsvRecord> rows) throws IOException;
  }

  /**
   * Reads a file. The rows may differ in their number of fields, see {@link #checkFields}.
   *
   * @param torn whether the file may end inside quotes, as after a power failure
   * @throws FileException if the file cannot be read or is not CSV
   */
  public static <T> T read(Path file, boolean torn, Contents<T> contents) throws FileException {
    if (Files.isDirectory(file)) {
      throw new FileException("cannot read " + file + ": it is a folder");
    }
    try (CsvReader<CsvRecord> csv =
        CsvReader.builder()
            .detectBomHeader(true)
            .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
            .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
            .allowUnclosedQuote(torn)
            .ofCsvRecord(file)) {
      return contents.of(csv);
    } catch (FileException e) {
      throw e;
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    } catch (CsvParseException e) {
      throw unreadable(file, e);
    }
  }

  /** Returns a message with the line where the file is not CSV. */
  private static FileException unreadable(Path file, CsvParseException e) {
    String reason =
        file.toString().endsWith(".jsonl")
            ? "it must be CSV, not JSON Lines"
            : Printable.lowerFirst(String.valueOf(e.getMessage()));
    return new FileException("cannot read " + file + ": " + reason, e);
  }

  /**
   * Checks that a row has as many fields as the first one.
   *
   * @throws IllegalArgumentException if the number of fields differs
   */
  public static void checkFields(CsvRecord row, int columns) {
    if (row.getFieldCount() != columns) {
      throw new IllegalArgumentException(
          "line "
              + row.getStartingLineNumber()
              + " must have "
              + columns
              + " fields, has "
              + row.getFieldCount());
    }
  }
}
