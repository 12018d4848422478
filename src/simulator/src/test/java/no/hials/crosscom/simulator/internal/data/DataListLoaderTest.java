package no.hials.crosscom.simulator.internal.data;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.RefusedException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The declarations of data lists, their scope, and their errors. */
class DataListLoaderTest {
  private final Scope globals = new Scope();
  private final Scope module = new Scope(globals);

  @BeforeEach
  void declareGlobals() throws RefusedException {
    Declarations.declareEnum(globals, "MODE", List.of("A", "B"));
    Declarations.declareStruc(globals, "STRUC FRAME REAL X");
    Declarations.declareStruc(globals, "STRUC LOAD REAL M, FRAME CM");
    Declarations.declare(globals, "BOOL $OUT[8]", Access.READ_WRITE, null);
    Declarations.declare(globals, "INT $OV", Access.READ_ONLY, null);
    Declarations.declare(globals, "INT SHARED", Access.READ_WRITE, null);
  }

  /** Loads a data list whose declarations begin in line 2; returns the errors. */
  private List<String> load(String head, String... lines) {
    ParseResult result =
        KrlParser.parse("x", "DEFDAT " + head + "\n" + String.join("\n", lines) + "\nENDDAT");
    assertThat(result.errors()).isEmpty();
    List<KrlError> errors = new ArrayList<>();
    DataListLoader.load(
        (DataList) result.file().orElseThrow(), module, globals, LoadingMode.STRICT, errors::add);
    return errors.stream().map(KrlError::toString).toList();
  }

  @ParameterizedTest
  @EnumSource
  void namesTheStructuresThatContainEachOther(LoadingMode mode) {
    String text =
        "DEFDAT X\nSTRUC A INT I,B OTHER\nSTRUC B C NEXT\nSTRUC C a BACK\nDECL A V\nENDDAT";
    List<String> errors = new ArrayList<>();
    DataListLoader.load(
        (DataList) KrlParser.parse("x", text).file().orElseThrow(),
        module,
        globals,
        mode,
        error -> errors.add(error.toString()));

    String rule = "a structure cannot contain itself, ";
    assertThat(errors)
        .containsExactlyInAnyOrder(
            "x:2:17: " + rule + "A contains B, B contains C, C contains a",
            "x:3:11: " + rule + "B contains C, C contains a, a contains B",
            "x:4:11: " + rule + "C contains a, a contains B, B contains C");
  }

  @ParameterizedTest
  @ValueSource(strings = {"INT N%d", "SIGNAL N%d $OUT[1]", "ENUM N%d X,Y", "STRUC N%d INT I"})
  void namesAndTypesShareTheMemoryOfTheVariables(String declaration) {
    Scope small = new Scope(10_000);
    List<KrlError> errors = new ArrayList<>();
    StringBuilder text = new StringBuilder("DEFDAT $LIST\nBOOL $OUT[8]\n");
    for (int i = 0; i < 100; i++) {
      text.append(declaration.formatted(i)).append('\n');
    }
    DataList list = (DataList) KrlParser.parse("x", text + "ENDDAT").file().orElseThrow();

    DataListLoader.load(list, new Scope(small), small, LoadingMode.STRICT, errors::add);

    assertThat(errors)
        .isNotEmpty()
        .allSatisfy(error -> assertThat(error.message()).contains("at most 10000 bytes of memory"));
    assertThat(small.bytes()).isLessThanOrEqualTo(10_000);
  }

  @ParameterizedTest
  @ValueSource(strings = {"REAL N%d[1000,1000]", "BIG N%d", "BIG N%d[2]"})
  void aVariableWithoutRoomIsRefusedBeforeItsElementsAreCreated(String declaration) {
    Scope small = new Scope(10_000);
    List<KrlError> errors = new ArrayList<>();
    StringBuilder text = new StringBuilder("DEFDAT $LIST\nSTRUC BIG REAL A[1000,1000]\n");
    for (int i = 0; i < 200; i++) {
      text.append("DECL ").append(declaration.formatted(i)).append('\n');
    }
    DataList list = (DataList) KrlParser.parse("x", text + "ENDDAT").file().orElseThrow();
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();

    DataListLoader.load(list, new Scope(small), small, LoadingMode.STRICT, errors::add);

    // one array of a million elements takes 4 MB or more
    assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(4_000_000);
    assertThat(errors).hasSize(200);
    assertThat(small.names()).isEmpty();
  }

  private String printed(String name) throws RefusedException {
    return module.print(VariablePath.parse(name));
  }

  @Nested
  class Where {

    @Test
    void everythingOfASystemListIsGlobal() {
      assertThat(load("$CONFIG", "INT A=1", "ENUM E X,Y", "STRUC S INT I", "SIGNAL G $OUT[1]"))
          .isEmpty();
      assertThat(globals.names()).contains("A", "G");
      assertThat(globals.knowsType("E")).isTrue();
      assertThat(globals.knowsType("S")).isTrue();
      assertThat(module.names()).isEmpty();
    }

    @Test
    void onlyWhatAPublicModuleDeclaresGlobalIsGlobal() throws RefusedException {
      assertThat(
              load(
                  "M PUBLIC",
                  "GLOBAL INT A=1",
                  "INT B=2",
                  "GLOBAL ENUM E X,Y",
                  "ENUM F X,Y",
                  "GLOBAL STRUC S INT I",
                  "STRUC T INT I",
                  "GLOBAL SIGNAL G $OUT[1]",
                  "SIGNAL H $OUT[2] TO $OUT[4]",
                  "GLOBAL INT L[2]",
                  "L[2]=5"))
          .isEmpty();
      assertThat(globals.names()).contains("A", "G", "L").doesNotContain("B", "H");
      assertThat(module.names()).containsExactly("B", "H");
      assertThat(globals.knowsType("E")).isTrue();
      assertThat(globals.knowsType("F")).isFalse();
      assertThat(module.knowsType("F")).isTrue();
      assertThat(globals.knowsType("S")).isTrue();
      assertThat(globals.knowsType("T")).isFalse();
      assertThat(module.knowsType("T")).isTrue();
      assertThat(printed("L[2]")).isEqualTo("5");
    }

    @Test
    void aModulesOwnVariableHidesAGlobalOne() throws RefusedException {
      globals.write(VariablePath.parse("SHARED"), new KrlInt(1), Scope.Writer.SYSTEM);
      assertThat(load("M", "INT SHARED=2")).isEmpty();
      assertThat(printed("SHARED")).isEqualTo("2");
      assertThat(globals.print(VariablePath.parse("SHARED"))).isEqualTo("1");
    }

    @Test
    void globalNeedsAPublicList() {
      assertThat(load("M", "GLOBAL INT A", "GLOBAL ENUM E X"))
          .containsExactly(
              "x:2:12: GLOBAL needs a public data list, expected DEFDAT M PUBLIC, found no PUBLIC",
              "x:3:1: GLOBAL needs a public data list, expected DEFDAT M PUBLIC, found no PUBLIC");
    }

    @Test
    void aModuleDeclaresNoSystemVariables() {
      assertThat(load("M", "INT $A=1", "$A=2"))
          .containsExactly(
              "x:2:5: a system variable is declared in a system data list such as $CONFIG, $A is"
                  + " declared in M");
    }

    @Test
    void aModuleSetsOnlyWhatItDeclares() {
      assertThat(load("M", "SHARED=2"))
          .containsExactly(
              "x:2:1: a data list sets only its own variables, SHARED is not declared in it");
      assertThat(load("$CONFIG", "SHARED=2", "NOWHERE=3"))
          .containsExactly("x:3:1: no variable NOWHERE is declared");
    }

    @Test
    void importKeepsTheNameAndIsResolvedByPrograms() {
      assertThat(
              load(
                  "M",
                  "EXT BAS (CMD :IN,REAL :IN)",
                  "EXTFCT BOOL OK (INT :IN)",
                  "IMPORT INT SHARED IS /R1/OTHER..SHARED"))
          .isEmpty();
      assertThat(load("M", "IMPORT INT MINE IS /R1/OTHER..SHARED"))
          .containsExactly(
              "x:2:1: IMPORT keeps the name of the variable in this simulation, expected SHARED,"
                  + " found MINE");
      assertThat(load("M", "IMPORT INT HIDDEN IS /R1/OTHER..HIDDEN")).isEmpty();
    }
  }

  @Nested
  class Values {

    @Test
    void goToVariablesElementsAndComponents() throws RefusedException {
      assertThat(
              load(
                  "M",
                  "INT A=1,B,C[2],D[2,2]",
                  "C[2]=2",
                  "D[2,1]=21",
                  "DECL LOAD L={M 1,CM {X 2}}",
                  "L.CM.X=3.5",
                  "CHAR TEXT[5],ROWS[2,5],ONE=\"a\"",
                  "TEXT[]=\"abc\"",
                  "TEXT[2]=\"B\"",
                  "ROWS[2,]=\"row\"",
                  "CHAR SHORT[5]=\"xy\"",
                  "CHAR FITS[]=\"four\"",
                  "DECL MODE E=#b"))
          .isEmpty();
      assertThat(printed("A")).isEqualTo("1");
      assertThat(printed("C[2]")).isEqualTo("2");
      assertThat(printed("D[2,1]")).isEqualTo("21");
      assertThat(printed("L")).isEqualTo("{LOAD: M 1.00000, CM {FRAME: X 3.50000}}");
      assertThat(printed("TEXT[]")).isEqualTo("\"aBc\"");
      assertThat(printed("ROWS[2,]")).isEqualTo("\"row\"");
      assertThat(printed("ONE")).isEqualTo("\"a\"");
      assertThat(printed("SHORT[]")).isEqualTo("\"xy\"");
      assertThat(printed("FITS[]")).isEqualTo("\"four\"");
      assertThat(DataLists.describe(module, "FITS", Map.of()).orElseThrow().dimensions())
          .containsExactly(4);
      assertThat(printed("E")).isEqualTo("#B");
    }

    @Test
    void fillASystemArrayAndOnlyThat() throws RefusedException {
      assertThat(
              load("$X", "BOOL $OUT[4]=FALSE", "$OUT[2]=TRUE", "CHAR $N[2,3]=\"ab\"", "INT A[2]=0"))
          .containsExactly(
              "x:5:10: an array gets its values by element, expected lines such as"
                  + " A[1]=..., found a value for the whole array");
      assertThat(printed("$OUT[]")).isEqualTo("FALSE TRUE FALSE FALSE ");
      assertThat(printed("$N[2,]")).isEqualTo("\"ab\"");
      assertThat(load("$X", "BOOL $OUT[4]=5"))
          .containsExactly("x:2:14: $OUT: needs BOOL, was given 5");
    }

    @Test
    void takeTheLengthsOfArraysFromConstants() throws RefusedException {
      assertThat(load("M", "CONST INT N=3", "INT A[N],B[N*2,2]", "STRUC S INT I[N]", "A[N]=N+1"))
          .isEmpty();
      assertThat(printed("A[3]")).isEqualTo("4");
      assertThat(DataLists.describe(module, "B", Map.of()).orElseThrow().dimensions())
          .containsExactly(6, 2);
    }

    @Test
    void turnCharactersIntoCodesAndBack() throws RefusedException {
      assertThat(load("M", "INT I=\"A\"", "CHAR C=66,T[3]", "T[]=\"abc\"", "T[2]=67")).isEmpty();
      assertThat(printed("I")).isEqualTo("65");
      assertThat(printed("C")).isEqualTo("\"B\"");
      assertThat(printed("T[]")).isEqualTo("\"aCc\"");
    }

    @Test
    void ofASignalOfOneWireAreThoseOfItsForm() throws RefusedException {
      assertThat(
              load(
                  "$X",
                  "$OUT[3]=TRUE",
                  "SIGNAL ONE $OUT[3]",
                  "SIGNAL GROUP $OUT[3] TO $OUT[3]",
                  "SIGNAL $SYSTEM $OUT[3] TO $OUT[3]"))
          .isEmpty();
      assertThat(printed("ONE")).isEqualTo("TRUE");
      assertThat(printed("GROUP")).isEqualTo("1");
      assertThat(printed("$SYSTEM")).isEqualTo("TRUE");
      globals.write(VariablePath.parse("GROUP"), new KrlInt(0), Scope.Writer.SYSTEM);
      assertThat(printed("ONE")).isEqualTo("FALSE");
    }

    @Test
    void areDeclaredAnewEachTime() throws RefusedException {
      assertThat(load("M", "DECL LOAD L={M 1.0,CM {X 2.0}}")).isEmpty();
      assertThat(load("M", "DECL LOAD L={M 3.0}")).isEmpty();
      assertThat(printed("L")).isEqualTo("{LOAD: M 3.00000}");
    }
  }

  @Nested
  class Rights {

    private Access accessOf(String name) {
      return DataLists.describe(module, name, Map.of()).orElseThrow().access();
    }

    @Test
    void comeFromConstOrTheCommentUnlessASystemVariableHasThemAlready() {
      assertThat(
              load(
                  "$X",
                  "INT A ;only a comment",
                  "CONST INT B=1",
                  "INT C ;RO [mm] in our form (FIW)",
                  "INT $OV ;RW [%] override (FIW)",
                  "INT $NEW ;RO [%] override (FIW)",
                  "SIGNAL SIG $OUT[1] ;RO [-] a signal (FIW)"))
          .isEmpty();
      assertThat(accessOf("A")).isEqualTo(Access.READ_WRITE);
      assertThat(accessOf("B")).isEqualTo(Access.READ_ONLY);
      assertThat(accessOf("C")).isEqualTo(Access.READ_ONLY);
      assertThat(accessOf("$OV")).isEqualTo(Access.READ_ONLY);
      assertThat(accessOf("$NEW")).isEqualTo(Access.READ_ONLY);
      assertThat(accessOf("SIG")).isEqualTo(Access.READ_ONLY);
    }
  }

  @Nested
  class Errors {

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "INT A=TRUE|2:7|A: needs INT, was given TRUE",
          "INT A=1.5|2:7|A: needs INT, was given 1.50000",
          "INT A={X 1}|2:7|A: needs INT, was given {X 1}",
          "FRAME F=5|2:9|F: needs FRAME, was given 5",
          "FRAME F={LOAD: X 1}|2:9|F: needs FRAME, was given an aggregate of LOAD",
          "FRAME F={X 1,Q 2}|2:14|Q: FRAME has no .Q",
          "FRAME F={X #A}|2:12|X: needs REAL, was given #A",
          "FRAME F={X 1,X 2}|2:14|an aggregate has a field once, X is set again",
          "FRAME F={X[1] 1}|2:10|X[1]: not an array, was given index [1]",
          "DECL LOAD L={M 1,CM {Z 1}}|2:22|Z: FRAME has no .Z",
          "DECL MODE E=#C|2:13|E: ENUM MODE has no #C",
          "DECL MODE E=1|2:13|E: needs MODE, was given 1",
          "CHAR C=\"ab\"|2:8|C: needs one character, was given \"ab\"",
          "CHAR C[2]=\"abc\"|2:11|C: holds 2 characters, was given 3",
          "STRUC A INT I,A SELF|2:17|a structure cannot contain itself, A contains A",
          "DECL NOTYPE N|2:1|a type is declared before it is used, type NOTYPE is not declared",
          "INT A[0]|2:7|the length of a dimension is 1 or more, is 0",
          "INT A[-2]|2:7|the length of a dimension is 1 or more, is -2",
          "INT A[1.5]|2:7|an index is an INT, expected one, found 1.5",
          "INT A[SHARED]|2:7|found the variable SHARED",
          "INT A[2000000]|2:5|A must have 1 to 1000000 elements, has 2000000",
          "INT A[2000,2000,2000]|2:5|A must have 1 to 1000000 elements, has 8000000000",
          "INT A=SHARED|2:7|found the variable SHARED",
          "STRUC S NOTYPE A|2:16|type NOTYPE is not declared",
          "STRUC S INT A[0]|2:15|the length of a dimension is 1 or more, is 0",
          "STRUC S INT A,A|2:1|STRUC S has A twice",
          "STRUC INT REAL A|2:1|INT is a base type of KRL",
          "ENUM E A,a|2:1|must have at least one constant and none twice",
          "SIGNAL S $OUT[9]|2:10|$OUT[9]: an index is 1 to 8, was given [9]",
          "SIGNAL S $OUT[1] TO $OUT[9]|2:21|$OUT[9]: an index is 1 to 8",
          "SIGNAL S $OUT[1,2]|2:10|expected one such as $OUT[1], found $OUT[1,2]",
          "SIGNAL S $NOWHERE[1]|2:10|$NOWHERE[1]: no variable $NOWHERE",
          "SIGNAL S $OUT[3] TO $OUT[2]|2:1|a SIGNAL is $OUT[a]",
        })
    void haveTheirPlaceAndSayWhatWasExpectedAndFound(String line, String place, String message) {
      assertThat(load("M", line))
          .singleElement()
          .asString()
          .startsWith("x:" + place + ": ")
          .contains(message);
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "A[3]=1|A[3]: an index is 1 to 2, was given [3]",
          "A[0]=1|an index is 1 to 2",
          "A=1|A: an array of 1 dimensions, was given no index",
          "A[]=1|an array gets its values by element",
          "A[1].X=1|not a structure, has no .X",
          "A[1]=#A|A[1]: needs INT, was given #A",
          "F.Q=1|F.Q: FRAME has no .Q",
          "F={Q 1}|Q: FRAME has no .Q",
          "T=\"a\"|T: a CHAR array, needs []",
          "T[]=\"abcd\"|T[]: holds 3 characters, was given 4",
          "T[]=5|T[]: needs a text in double quotes, was given 5",
          "S=TRUE|a variable has an initial value, S is a SIGNAL",
        })
    void inInitialValuesHaveTheirPlace(String line, String message) {
      assertThat(load("M", "INT A[2]", "FRAME F", "CHAR T[3]", "SIGNAL S $OUT[1]", line, "A[1]=5"))
          .singleElement()
          .asString()
          .startsWith("x:6:")
          .contains(message);
    }

    @Test
    void areAllFoundAndTheRestIsDeclared() throws RefusedException {
      assertThat(
              load(
                  "M",
                  "INT A=TRUE,B=2,C=FALSE",
                  "FRAME F={X 1.0,Y 2,Z 3}",
                  "STRUC S NOTYPE P,INT Q[0]",
                  "INT LAST=9"))
          .hasSize(6);
      assertThat(printed("B")).isEqualTo("2");
      assertThat(printed("F.X")).isEqualTo("1.00000");
      assertThat(printed("LAST")).isEqualTo("9");
    }

    @Test
    void doNotDragOthersBehindThem() {
      assertThat(
              load(
                  "M",
                  "DECL NOTYPE N={X 1}",
                  "N.X=5",
                  "STRUC S NOTYPE P",
                  "DECL S V={P 1}",
                  "V.P=2",
                  "INT A[0]",
                  "A[1]=5",
                  "SIGNAL G $OUT[9]",
                  "G=TRUE",
                  "ENUM E A,A",
                  "DECL E W=#A"))
          .hasSize(5);
    }

    @Test
    void areNamesThatAreDeclaredTwice() {
      assertThat(
              load(
                  "M",
                  "INT A=1",
                  "REAL a=2.0",
                  "SIGNAL A $OUT[1]",
                  "INT B,B",
                  "ENUM E X",
                  "STRUC e INT I"))
          .containsExactly(
              "x:3:6: a data list declares a name once, a is declared again",
              "x:4:1: a data list declares a name once, A is declared again",
              "x:5:7: a data list declares a name once, B is declared again",
              "x:7:1: a data list declares a type once, type e is declared again");
    }

    @ParameterizedTest
    @ValueSource(
        strings = {"INT A[]", "CHAR A[]", "CHAR A[]=\"\"", "CHAR A[,5]", "STRUC S CHAR A[]"})
    void areLengthsLeftOpen(String line) {
      ParseResult result = KrlParser.parse("x", "DEFDAT M\n" + line + "\nENDDAT");
      List<KrlError> errors = new ArrayList<>(result.errors());
      DataListLoader.load(
          (DataList) result.file().orElseThrow(), module, globals, LoadingMode.STRICT, errors::add);
      assertThat(errors).isNotEmpty();
    }
  }
}
