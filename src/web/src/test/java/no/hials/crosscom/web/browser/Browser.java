package no.hials.crosscom.web.browser;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.logging.Level;
import javax.imageio.ImageIO;
import org.openqa.selenium.By;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;

/** The Chromium of the system, without a window. */
public final class Browser implements AutoCloseable {
  private static final File CHROMIUM = new File("/usr/bin/chromium");
  private static final File DRIVER = new File("/usr/bin/chromedriver");
  private static final Path PICTURES = Path.of("target", "pictures");
  private static final String AXE =
      resource("/META-INF/resources/webjars/axe-core/4.6.3/axe.min.js");
  private static final int SECONDS = 10;

  private final ChromeDriver driver;
  private final List<Map<String, Object>> fingers = new ArrayList<>();
  private Map<String, Object> place = Map.of();
  private int mouseButtons;

  /** A size of the window, in CSS pixels. */
  public enum Size {
    DESKTOP(1280, 800, false),
    PHONE(390, 844, true),
    SMALL_PHONE(360, 640, true),
    LARGE_SCREEN(3840, 2160, false);

    private final int width;
    private final int height;
    private final boolean touch;

    Size(int width, int height, boolean touch) {
      this.width = width;
      this.height = height;
      this.touch = touch;
    }
  }

  /** A button of the mouse. */
  public enum MouseButton {
    LEFT(1),
    MIDDLE(4);

    private final int bit;

    MouseButton(int bit) {
      this.bit = bit;
    }
  }

  private Browser(ChromeDriver driver) {
    this.driver = driver;
  }

  /** Returns whether there is a browser here; one is never downloaded. */
  static boolean isInstalled() {
    return CHROMIUM.canExecute() && DRIVER.canExecute();
  }

  static Browser start() {
    ChromeOptions options = new ChromeOptions();
    options.setBinary(CHROMIUM);
    options.addArguments(
        "--headless=new",
        "--no-sandbox", // root has none
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader");
    options.setAcceptInsecureCerts(true); // those that a test has made
    LoggingPreferences logs = new LoggingPreferences();
    logs.enable(LogType.BROWSER, Level.ALL);
    options.setCapability("goog:loggingPrefs", logs);
    ChromeDriverService service =
        new ChromeDriverService.Builder()
            .usingDriverExecutable(DRIVER)
            .usingAnyFreePort()
            .withSilent(true)
            .build();
    return new Browser(new ChromeDriver(service, options));
  }

  private static String resource(String path) {
    try (InputStream in = Browser.class.getResourceAsStream(path)) {
      if (in == null) {
        throw new IllegalStateException(path + " is not on the class path");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Releases everything, closes the page, and forgets what was logged and all cookies. */
  void reset() {
    lift();
    for (MouseButton button : MouseButton.values()) {
      if ((mouseButtons & button.bit) != 0) {
        release(button);
      }
    }
    driver.get("about:blank");
    forgetCookies();
    size(Size.DESKTOP);
    dark(false);
    errors();
  }

  /** Forgets its sessions, as another browser would not have them. */
  public void forgetCookies() {
    driver.executeCdpCommand("Network.clearBrowserCookies", Map.of());
  }

  /** Sets the size of the window, and whether it is touched. */
  public void size(Size size) {
    driver.executeCdpCommand(
        "Emulation.setDeviceMetricsOverride",
        Map.of(
            "width", size.width,
            "height", size.height,
            "deviceScaleFactor", 1,
            "mobile", size.touch));
    driver.executeCdpCommand(
        "Emulation.setTouchEmulationEnabled",
        Map.of("enabled", size.touch, "maxTouchPoints", size.touch ? 5 : 1));
  }

  /** Sets whether the person prefers dark pages. */
  public void dark(boolean dark) {
    Map<String, String> feature =
        Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light");
    driver.executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features", List.of(feature)));
  }

  /** Opens an address and waits until the page is loaded. */
  public void open(URI address) {
    driver.get(address.toString());
  }

  /** Returns the text of the first element that a CSS selector matches. */
  public String text(String selector) {
    return find(selector).getText();
  }

  /** Clicks the first element that a CSS selector matches. */
  public void click(String selector) {
    find(selector).click();
  }

  /** Presses keys, each alone: characters, or {@link org.openqa.selenium.Keys}. */
  public void press(CharSequence... keys) {
    new Actions(driver).sendKeys(keys).perform();
  }

  /** Puts another finger on the middle of the first element that a CSS selector matches. */
  public void touch(String selector) {
    Map<String, Object> middle = middle(selector);
    fingers.add(Map.of("x", middle.get("x"), "y", middle.get("y"), "id", fingers.size()));
    driver.executeCdpCommand(
        "Input.dispatchTouchEvent", Map.of("type", "touchStart", "touchPoints", fingers));
  }

  @SuppressWarnings("unchecked")
  private Map<String, Object> middle(String selector) {
    find(selector);
    return (Map<String, Object>)
        run(
            """
            const element = document.querySelector(arguments[0]);
            element.scrollIntoView({ block: 'center' });
            const box = element.getBoundingClientRect();
            return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
            """,
            selector);
  }

  /** Lifts all fingers. */
  public void lift() {
    if (!fingers.isEmpty()) {
      fingers.clear();
      driver.executeCdpCommand(
          "Input.dispatchTouchEvent", Map.of("type", "touchEnd", "touchPoints", List.of()));
    }
  }

  /** Presses a button of the mouse on the middle of the first element of a CSS selector. */
  public void press(MouseButton button, String selector) {
    place = middle(selector);
    mouseButtons |= button.bit;
    mouse("mousePressed", button);
  }

  /** Releases a button of the mouse. */
  public void release(MouseButton button) {
    mouseButtons &= ~button.bit;
    mouse("mouseReleased", button);
  }

  private void mouse(String type, MouseButton button) {
    driver.executeCdpCommand(
        "Input.dispatchMouseEvent",
        Map.of(
            "type",
            type,
            "x",
            place.get("x"),
            "y",
            place.get("y"),
            "button",
            button.name().toLowerCase(Locale.ROOT),
            "buttons",
            mouseButtons,
            "clickCount",
            1));
  }

  /** Waits for the element of a CSS selector and returns it. */
  public WebElement find(String selector) {
    await("document.querySelector(`" + selector + "`)");
    return driver.findElement(By.cssSelector(selector));
  }

  /** Runs a script in the page and returns what it returns. */
  public Object run(String script, Object... arguments) {
    return driver.executeScript(script, arguments);
  }

  /** Waits until an expression of JavaScript is true in the page. */
  public void await(String expression) {
    // in the page, since its policy allows no script that is made from text there
    Object failure =
        driver.executeAsyncScript(
            """
            const done = arguments[0];
            const end = performance.now() + %d;
            (function look() {
              let found = false;
              let failure = 'it is not true';
              try {
                found = %s;
              } catch (e) {
                failure = String(e);
              }
              if (found) {
                done(null);
              } else if (performance.now() > end) {
                done(failure);
              } else {
                setTimeout(look, 20);
              }
            })();
            """
                .formatted(SECONDS * 1000, expression));
    if (failure != null) {
      throw new AssertionError(
          "not within "
              + SECONDS
              + " s: "
              + expression
              + ": "
              + failure
              + "; the page shows:\n"
              + run("return document.body?.innerText"));
    }
  }

  /** Returns the violations of the rules of accessibility: each rule, and the elements. */
  @SuppressWarnings("unchecked")
  public List<String> barriers() {
    if (Boolean.TRUE.equals(run("return window.axe === undefined"))) {
      run(AXE);
    }
    return (List<String>)
        driver.executeAsyncScript(
            """
            const done = arguments[0];
            const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'];
            axe.run({ runOnly: tags, resultTypes: ['violations'] }).then(({ violations }) =>
              done(violations.flatMap(({ id, help, nodes }) =>
                nodes.map(({ html, any }) =>
                  `${id}: ${help}: ${html} ${any.map((it) => it.message).join('; ')}`))));
            """);
  }

  /** Returns the controls that are smaller than a finger, 44 pixels; not links within a text. */
  @SuppressWarnings("unchecked")
  public List<String> smallTargets() {
    return (List<String>)
        run(
            """
            return [...document.querySelectorAll('button:not(.link), input, select, nav a')]
              .map((it) => [it, (it.closest('label') ?? it).getBoundingClientRect()])
              .filter(([it, box]) => box.height > 0 && it.checkVisibility())
              .filter(([, box]) => box.height < 43.5)
              .map(([it, box]) => `${box.height} px: ${it.outerHTML.slice(0, 200)}`);
            """);
  }

  /** Returns by how many pixels the page is too wide for the window. */
  public long overflow() {
    return (Long) run("return document.documentElement.scrollWidth - window.innerWidth");
  }

  /** Returns the errors on the console since the last call, also those of the policy. */
  public List<String> errors() {
    return driver.manage().logs().get(LogType.BROWSER).getAll().stream()
        .filter(it -> it.getLevel().equals(Level.SEVERE))
        .map(it -> it.getMessage())
        .toList();
  }

  /** Returns a picture of the window. */
  BufferedImage picture() throws IOException {
    byte[] png = driver.getScreenshotAs(OutputType.BYTES);
    return ImageIO.read(new ByteArrayInputStream(png));
  }

  /** Saves what the window shows, for the eye: {@code target/pictures/NAME.png}. */
  public void picture(String name) throws IOException {
    Files.createDirectories(PICTURES);
    Files.write(PICTURES.resolve(name + ".png"), driver.getScreenshotAs(OutputType.BYTES));
  }

  @Override
  public void close() {
    driver.quit();
  }
}
