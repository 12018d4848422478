package no.hials.crosscom.web.internal.http;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The files of the page: our own, and those of the libraries that it loads. */
final class PageFiles {
  private static final String OWN = "/no/hials/crosscom/web/page";
  private static final Pattern PATH = Pattern.compile("(/[a-z0-9][a-z0-9-]*)+\\.(js|css|svg)");
  private static final Pattern IMPORT_MAP =
      Pattern.compile("<script type=\"importmap\">(.*?)</script>", Pattern.DOTALL);

  private static final Map<String, String> TYPES =
      Map.of(
          "js", "text/javascript; charset=utf-8",
          "css", "text/css; charset=utf-8",
          "svg", "image/svg+xml");

  /** The files of libraries by their paths on this server: the webjar, and the path within it. */
  private static final Map<String, String> LIBRARIES =
      Map.of(
          "/lib/preact.js", "preact dist/preact.mjs",
          "/lib/preact-hooks.js", "preact hooks/dist/hooks.mjs",
          "/lib/uplot.js", "uplot dist/uPlot.esm.js",
          "/lib/uplot.css", "uplot dist/uPlot.min.css",
          "/lib/three.module.min.js", "three build/three.module.min.js",
          "/lib/three.core.min.js", "three build/three.core.min.js",
          "/lib/orbit-controls.js", "three examples/jsm/controls/OrbitControls.js",
          "/lib/stl-loader.js", "three examples/jsm/loaders/STLLoader.js");

  private final Map<String, PageFile> files = new ConcurrentHashMap<>();
  private final String index;

  PageFiles() throws IOException {
    index = new String(PageFile.resource(OWN + "/index.html"), StandardCharsets.UTF_8);
  }

  /** Returns the page with the token for its socket. */
  String index(String token) {
    return index.replace("{socket-token}", token);
  }

  /** Returns the hash of the import map, the only script within the page. */
  String importMapHash() {
    Matcher map = IMPORT_MAP.matcher(index);
    if (!map.find()) {
      throw new IllegalStateException("index.html has no import map");
    }
    return PageFile.hash(map.group(1).getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the file at a path; empty if the page has no such file. */
  Optional<PageFile> find(String path) throws IOException {
    PageFile known = files.get(path);
    if (known != null) {
      return Optional.of(known);
    }
    String library = LIBRARIES.get(path);
    if (library == null && !PATH.matcher(path).matches()) {
      return Optional.empty();
    }
    String resource = library == null ? OWN + path : ofLibrary(library);
    if (PageFiles.class.getResource(resource) == null) {
      return Optional.empty();
    }
    String type = TYPES.get(path.substring(path.lastIndexOf('.') + 1));
    PageFile file = new PageFile(String.valueOf(type), PageFile.resource(resource));
    files.put(path, file);
    return Optional.of(file);
  }

  /** Returns the resource of a library's file, with the version from the webjar. */
  private static String ofLibrary(String library) throws IOException {
    String[] parts = library.split(" ", 2);
    Properties pom = new Properties();
    byte[] text =
        PageFile.resource("/META-INF/maven/org.webjars.npm/" + parts[0] + "/pom.properties");
    pom.load(new StringReader(new String(text, StandardCharsets.ISO_8859_1)));
    String version = pom.getProperty("version");
    return "/META-INF/resources/webjars/" + parts[0] + "/" + version + "/" + parts[1];
  }
}
