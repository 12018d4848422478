package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Checks the numbers of the error codes against docs/reference/c3-messages.md. */
class ErrorCodeTest {
  @Test
  void codesHaveTheNumbersOfTheReference() {
    assertThat(ErrorCode.values())
        .extracting(code -> code.code() + " " + code)
        .containsExactly(
            "0 GENERAL",
            "1 SUCCESS",
            "2 ACCESS",
            "3 ARGUMENT",
            "4 MEMORY",
            "5 POINTER",
            "6 UNEXPECTED",
            "7 NOT_IMPLEMENTED",
            "8 NO_INTERFACE",
            "9 PROTOCOL",
            "10 LONG_ANSWER");
  }

  @Test
  void everyCodeIsFoundByItsNumberAndNoOtherIs() {
    for (ErrorCode code : ErrorCode.values()) {
      assertThat(ErrorCode.from(code.code())).contains(code);
    }
    assertThat(ErrorCode.from(-1)).isEmpty();
    assertThat(ErrorCode.from(11)).isEmpty();
  }
}
