package no.hials.crosscom.simulator.internal.data;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.simulator.Access;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a comment behind a declaration says. */
class NoteTest {

  @Test
  void readsAccessUnitMeaningAndSource() {
    assertThat(Note.of("RO [mm/deg] tool (base) or beside it (FIW RSIB)"))
        .isEqualTo(new Note(Access.READ_ONLY, "mm/deg", "tool (base) or beside it", "FIW RSIB"));
    assertThat(Note.of(" RW [-] counters (NAQ) "))
        .isEqualTo(new Note(Access.READ_WRITE, "", "counters", "NAQ"));
    assertThat(Note.of("RO [-] ()")).isEqualTo(new Note(Access.READ_ONLY, "", "", ""));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "what a user writes",
        "ROUTE [1] of (two)",
        "RO [mm] without a source",
        "RO (no unit)",
        "RO [mm) only half]",
        "RW [mm] (two) ends late"
      })
  void takesAnyOtherCommentAsTheMeaning(String comment) {
    assertThat(Note.of(comment)).isEqualTo(new Note(null, "", comment, ""));
  }

  @ParameterizedTest
  @CsvSource({
    "RO [mm] speed (FIW)",
    "RW [-] speed (mm/s) (NAQ U)",
    "RO [-] ()",
    "RW [%] ()",
    "plain words",
    "''"
  })
  void writesWhatItReads(String comment) {
    Note note = Note.of(comment);
    Access access = note.access() == null ? Access.READ_WRITE : note.access();
    assertThat(note.comment(access)).isEqualTo(comment);
  }

  @Test
  void writesThePlainMeaningOfWhatMayOnlyBeReadSoThatItIsReadBack() {
    Note note = new Note(null, "", "RO [x] odd (y)", "");
    assertThat(Note.of(note.comment(Access.READ_WRITE)))
        .isEqualTo(new Note(Access.READ_WRITE, "", "RO [x] odd (y)", ""));
  }
}
