package no.hials.crosscom.cli.lab;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.NoFontsException;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options of commands that draw a picture. */
final class PictureOptions {
  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = SizeConverter.class,
      description =
          "Size of the picture in pixels, such as 1200x800. Default: 1000 wide, with the height"
              + " it needs.")
  private Chart.@Nullable Size size;

  /**
   * Refuses a file that is not a picture or already exists.
   *
   * @param overwrite whether to overwrite an existing file
   */
  static void check(ConsoleCommand command, Path file, boolean overwrite) throws FileException {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (!name.endsWith(".png") && !name.endsWith(".svg")) {
      throw command.wrongUsage("the name of a picture must end with .png or .svg, is " + file);
    }
    LocalFiles.checkNew(file, overwrite);
  }

  /**
   * Refuses a size that is too small.
   *
   * @param largest a chart that needs at least as much space as the one to draw
   */
  void checkSize(ConsoleCommand command, Chart largest) throws FileException {
    if (size != null) {
      try {
        largest.checkSize(size);
      } catch (IllegalArgumentException e) {
        throw command.wrongUsage(String.valueOf(e.getMessage()));
      } catch (NoFontsException e) {
        throw new FileException("cannot draw a picture: " + e.getMessage(), e);
      }
    }
  }

  /**
   * Draws a chart.
   *
   * @param usual the size if the user chose none
   */
  void write(ConsoleCommand command, Chart chart, Path file, Chart.Size usual)
      throws FileException {
    try {
      chart.write(file, size == null ? usual : size);
    } catch (IllegalArgumentException e) {
      throw command.wrongUsage(String.valueOf(e.getMessage()));
    } catch (NoFontsException e) {
      throw new FileException("cannot draw " + file + ": " + e.getMessage(), e);
    } catch (IOException e) {
      throw new OutputException(file.toString(), e);
    }
  }

  /** A size in pixels. */
  static final class SizeConverter implements ITypeConverter<Chart.Size> {
    private static final Pattern FORM = Pattern.compile("(\\d{1,5})[xX](\\d{1,5})");

    @Override
    public Chart.Size convert(String text) {
      Matcher matcher = FORM.matcher(text);
      if (!matcher.matches()) {
        throw new TypeConversionException("must be like 1200x800, is " + text);
      }
      try {
        return new Chart.Size(
            Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(String.valueOf(e.getMessage()));
      }
    }
  }
}
