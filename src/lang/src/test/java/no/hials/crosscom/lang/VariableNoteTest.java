package no.hials.crosscom.lang;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The comment after a declaration. */
class VariableNoteTest {

  @Test
  void readsAccessUnitMeaningAndSource() {
    assertThat(VariableNote.of("RO [mm/deg] tool (base) or next to it (FIW RSIB)"))
        .isEqualTo(
            new VariableNote(Access.READ_ONLY, "mm/deg", "tool (base) or next to it", "FIW RSIB"));
    assertThat(VariableNote.of(" RW [-] counters (NAQ) "))
        .isEqualTo(new VariableNote(Access.READ_WRITE, "", "counters", "NAQ"));
    assertThat(VariableNote.of("RO [-] ()"))
        .isEqualTo(new VariableNote(Access.READ_ONLY, "", "", ""));
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
    assertThat(VariableNote.of(comment)).isEqualTo(new VariableNote(null, "", comment, ""));
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
    VariableNote note = VariableNote.of(comment);
    Access access = note.access() == null ? Access.READ_WRITE : note.access();
    assertThat(note.comment(access)).isEqualTo(comment);
  }

  @Test
  void writesThePlainMeaningOfWhatMayOnlyBeReadSoThatItIsReadBack() {
    VariableNote note = new VariableNote(null, "", "RO [x] odd (y)", "");
    assertThat(VariableNote.of(note.comment(Access.READ_WRITE)))
        .isEqualTo(new VariableNote(Access.READ_WRITE, "", "RO [x] odd (y)", ""));
  }
}
