package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The lists of watched variables. */
@ExtendWith(WithBrowser.class)
class VariablesBrowserIT {
  @TempDir private Path folder;
  private TestPages pages;

  @BeforeEach
  void start() throws IOException {
    pages = TestPages.start(folder);
  }

  @AfterEach
  void stop() throws IOException {
    pages.close();
  }

  @ParameterizedTest
  @EnumSource(
      value = Browser.Size.class,
      names = {"DESKTOP", "PHONE"})
  void aListIsSavedWithTheButtonOfItsDialog(Browser.Size size, Browser browser) {
    browser.size(size);
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=variables#/variables"));

    browser.click(".lists button");
    browser.find("dialog input").sendKeys("Cell");
    browser.click("dialog button.main");

    browser.await("document.querySelector('.lists select').value === 'Cell'");
    assertThat(folder.resolve("lists/Cell.txt")).content().contains("$POS_ACT");
  }

  @Test
  void aFileThatIsTooLargeForAListIsRefusedBeforeItIsSent(Browser browser) throws IOException {
    Path file = Files.writeString(folder.resolve("big.txt"), "$POS_ACT\n".repeat(50_000));
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=variables#/variables"));

    browser.find(".lists input[type=file]").sendKeys(file.toString());

    browser.await(
        "document.querySelector('.notes').textContent.includes("
            + "'big.txt has 450000 bytes; a list has at most 200000')");
  }

  @Test
  void aFileWithoutAVariableDoesNotReplaceTheList(Browser browser) throws IOException {
    Path file = Files.writeString(folder.resolve("empty.txt"), "");
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=variables#/variables"));

    browser.find(".lists input[type=file]").sendKeys(file.toString());

    browser.await(
        "document.querySelector('.notes').textContent.includes("
            + "'empty.txt has no variable; the list is unchanged')");
  }

  private void watchUnlocked(Browser browser, String variable) throws IOException {
    Path file = Files.writeString(folder.resolve("one.txt"), variable + "\n");
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=variables#/variables"));
    browser.click(".lock");
    browser.await("document.querySelector('.lock[aria-pressed=true]')");
    browser.find(".lists input[type=file]").sendKeys(file.toString());
  }

  @Test
  void aVariableWithoutAValueCanBeChanged(Browser browser) throws Exception {
    pages
        .controller()
        .controller()
        .load("notes.dat", "DEFDAT NOTES PUBLIC\nDECL GLOBAL CHAR TXT[8]\nENDDAT\n");
    watchUnlocked(browser, "TXT[]");
    browser.await("document.querySelector('[aria-label=\"Change TXT[]\"]')");

    browser.click("[aria-label=\"Change TXT[]\"]");
    browser.await(
        "document.querySelector('dialog .failure')?.textContent.startsWith("
            + "'It has no value, or cannot be read: ')");
    browser.find("dialog input").sendKeys("\"abc\"");
    browser.click("dialog button.main");
    browser.await("document.querySelector('dialog .new')");
    assertThat(browser.text("dialog dd.variable")).isEqualTo("unreadable");
    browser.click("dialog button.main");
    browser.await("!document.querySelector('dialog')");

    assertThat(pages.controller().variables().get("TXT[]")).isEqualTo("\"abc\"");
  }

  @Test
  void aSlowReadingKeepsWhatIsTypedMeanwhile(Browser browser) throws Exception {
    pages.controller().variables().set("MYINT", "100");
    watchUnlocked(browser, "MYINT");
    browser.await("document.querySelector('[aria-label=\"Change MYINT\"]:not(:disabled)')");
    CountDownLatch released = new CountDownLatch(1);
    try {
      pages.hold("MYINT", released).await();

      browser.click("[aria-label=\"Change MYINT\"]");
      browser.find("dialog input").sendKeys("2");
    } finally {
      released.countDown();
    }
    browser.await("document.querySelector('dialog button.main:not(:disabled)')");
    browser.press("5");
    browser.click("dialog button.main");

    browser.await("document.querySelector('dialog .new')");
    assertThat(browser.text("dialog dd.variable")).isEqualTo("100");
    assertThat(browser.text("dialog .new")).isEqualTo("25");
  }
}
