package no.hials.crosscom.protocol.code;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Checks names and numbers against docs/reference/c3-messages.md, and what becomes of numbers that
 * it has not.
 */
class CodesTest {

  static Stream<Arguments> numbers() {
    return Stream.of(
        arguments(ProgramCommand.class, "1 RESET, 2 START, 3 STOP, 4 CANCEL, 5 SELECT, 6 RUN"),
        arguments(Interpreter.class, "0 SUBMIT, 1 ROBOT"),
        arguments(MotionType.class, "1 PTP, 2 LIN, 3 PTP_REL, 4 LIN_REL"),
        arguments(PendantKey.class, "1 START, 2 STOP, 3 JOG, 4 MOUSE"),
        arguments(
            FileAttribute.class,
            "1 READ_ONLY, 2 HIDDEN, 4 SYSTEM, 16 DIRECTORY, 32 ARCHIVE, 16384 ENCRYPTED,"
                + " 268435456 SIGNED"),
        arguments(
            ItemType.class,
            "0 UNKNOWN, 1 DIRECTORY, 2 VIRTUAL_DIRECTORY, 4 ARCHIVE, 8 BINARY, 16 TEXT, 32 MODULE,"
                + " 64 RAW, 128 MOTION_FILE, 256 PROTECTED_CONTAINER"),
        arguments(
            ListFlag.class,
            "1 RECURSIVE, 2 EXPAND, 4 LONG, 8 OLD_LONG, 16 NO_PFC, 32 PFC_AS_FILE, 64 ZIP_AS_FILE"),
        arguments(ModulePart.class, "1 SUB, 2 SRC, 4 DAT, 8 TEMPLATE, 16 MOTION"),
        arguments(
            CopyFlag.class,
            "1 ARCHIVE, 3 MODIFY, 4 CONTINUE, 8 RECURSIVE, 16 REFRESH, 48 UPDATE, 64 OVERWRITE,"
                + " 128 NO_DIRECTORY_ENTRIES, 256 JUNK_DIRECTORY, 512 FORCE_BINARY,"
                + " 1024 FORCE_TEXT, 2048 NO_VERSION_CHECK, 4096 OVERWRITE_READ_ONLY,"
                + " 8192 NO_KRL_ANALYSIS"),
        arguments(
            FileProperty.class,
            "1 TYPE, 2 NAME, 4 SIZE, 8 ATTRIBUTES, 16 CREATION, 32 ACCESS, 64 MODIFICATION,"
                + " 128 EDIT_MODE"),
        arguments(EditMode.class, "-1 UNKNOWN, 0 FULL, 1 DAT_KOR, 2 PRO_KOR, 3 READ_ONLY"),
        arguments(BuildType.class, "0 OPEN_SOURCE, 1 PROPRIETARY, 2 FREEWARE, 3 INTERNAL"),
        arguments(ContentOperation.class, "1 BEGIN, 2 DATA, 3 SIZE, 4 END"));
  }

  @ParameterizedTest(name = "{1}")
  @MethodSource("numbers")
  <E extends Enum<E> & WireCode> void codesHaveTheNumbersOfTheReferenceAndAreFoundByThem(
      Class<E> type, String golden) {
    assertThat(type.getEnumConstants())
        .extracting(constant -> constant.code() + " " + constant)
        .containsExactly(golden.split(", "));
    for (E constant : type.getEnumConstants()) {
      assertThat(WireCode.find(type, constant.code()).orElseThrow()).isSameAs(constant);
    }
    assertThat(WireCode.find(type, -2)).isEmpty();
    assertThat(WireCode.find(type, 99)).isEmpty();
  }

  @Test
  void aKnownCodeHasItsConstantAndItsName() {
    Code<MotionType> code = new Code<>(MotionType.class, 2);

    assertThat(code.known()).contains(MotionType.LIN);
    assertThat(code.is(MotionType.LIN)).isTrue();
    assertThat(code.is(MotionType.PTP)).isFalse();
    assertThat(code).isEqualTo(Code.of(MotionType.LIN)).hasToString("LIN");
  }

  @Test
  void anUnknownCodeKeepsItsNumber() {
    Code<MotionType> code = new Code<>(MotionType.class, 77);

    assertThat(code.known()).isEmpty();
    assertThat(code.number()).isEqualTo(77);
    assertThat(code).hasToString("77");
  }

  @Test
  void flagsKeepTheBitsThatAreUnknown() {
    Flags<ListFlag> flags = new Flags<>(ListFlag.class, 0x8000_0005);

    assertThat(flags.known()).containsExactly(ListFlag.RECURSIVE, ListFlag.LONG);
    assertThat(flags.unknown()).isEqualTo(0x8000_0000);
    assertThat(flags.has(ListFlag.LONG)).isTrue();
    assertThat(flags.has(ListFlag.EXPAND)).isFalse();
    assertThat(flags).hasToString("[RECURSIVE, LONG, 0x80000000]");
  }

  @Test
  void noFlagsAreEmpty() {
    Flags<ItemType> flags = Flags.none(ItemType.class);

    assertThat(flags.known()).isEmpty();
    assertThat(flags.unknown()).isZero();
    assertThat(flags.has(ItemType.UNKNOWN)).isFalse();
    assertThat(flags).hasToString("[]").isEqualTo(Flags.of(ItemType.class, List.of()));
  }

  @Test
  void allPropertiesAre255() {
    // docs/reference/c3-messages.md#property-flags
    assertThat(Flags.all(FileProperty.class).bits()).isEqualTo(255);
    assertThat(Flags.all(FileProperty.class).known()).containsExactly(FileProperty.values());
  }

  @Test
  void ofTwoFlagsThatOverlapTheOneWithMoreBitsStandsForBoth() {
    Flags<CopyFlag> update = Flags.of(CopyFlag.UPDATE, CopyFlag.OVERWRITE);
    Flags<CopyFlag> both = Flags.of(CopyFlag.class, Set.of(CopyFlag.REFRESH, CopyFlag.UPDATE));

    assertThat(update.bits()).isEqualTo(48 | 64);
    assertThat(update.known()).containsExactly(CopyFlag.UPDATE, CopyFlag.OVERWRITE);
    assertThat(update.has(CopyFlag.REFRESH)).isTrue();
    assertThat(both.known()).containsExactly(CopyFlag.UPDATE);
    assertThat(new Flags<>(CopyFlag.class, 16).known()).containsExactly(CopyFlag.REFRESH);
    assertThat(new Flags<>(CopyFlag.class, 32).known()).isEmpty();
    assertThat(new Flags<>(CopyFlag.class, 32).unknown()).isEqualTo(32);
  }

  @Test
  void theReferencesModulePartsAreFlagsTogether() {
    // 5 SUBDAT, 6 SRCDAT (docs/reference/c3-messages.md#module-parts)
    assertThat(Flags.of(ModulePart.SUB, ModulePart.DAT).bits()).isEqualTo(5);
    assertThat(Flags.of(ModulePart.SRC, ModulePart.DAT).bits()).isEqualTo(6);
  }
}
