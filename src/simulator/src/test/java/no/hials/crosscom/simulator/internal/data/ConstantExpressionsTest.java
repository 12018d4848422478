package no.hials.crosscom.simulator.internal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.simulator.RefusedException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The expressions allowed as values of declarations. */
class ConstantExpressionsTest {
  private final Scope scope = new Scope();

  @BeforeEach
  void declareVariables() throws RefusedException {
    Declarations.declare(scope, "INT TWO", Access.READ_ONLY, new KrlInt(2));
    Declarations.declare(scope, "REAL HALF", Access.READ_ONLY, new KrlReal(0.5f));
    Declarations.declare(scope, "INT LIST[2]", Access.READ_ONLY, new KrlInt(7));
    Declarations.declare(scope, "INT VARIABLE", Access.READ_WRITE, new KrlInt(1));
    Declarations.declare(scope, "INT $SYSTEM", Access.READ_ONLY, new KrlInt(1));
    Declarations.declare(scope, "INT EMPTY", Access.READ_ONLY, null);
    Declarations.declare(scope, "SIGNAL SIG FALSE", Access.READ_ONLY, null);
  }

  /** Returns the tree of an expression, which begins in column 7. */
  private static Expression parse(String text) {
    ParseResult result = KrlParser.parse("x", "DEFDAT X\nINT Y=" + text + "\nENDDAT");
    assertThat(result.errors()).isEmpty();
    DataList list = (DataList) result.file().orElseThrow();
    Declaration.Variables group = (Declaration.Variables) list.declarations().get(0);
    Expression initial = group.variables().get(0).initial();
    assertThat(initial).isNotNull();
    return initial;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '\0',
      value = {
        "100|100",
        "'B0101'|5",
        "'HFF'|255",
        "-2147483648|-2147483648",
        "1.5|1.50000",
        "-90.0|-90.0000",
        "1E5|100000.0",
        "+3|3",
        "- -3|3",
        "TRUE|TRUE",
        "#t1|#t1",
        "\"text; {no} comment\"|\"text; {no} comment\"",
        "{X 1,Y -2.5}|{X 1, Y -2.50000}",
        "{FRAME: X 1}|{FRAME: X 1}",
        "{CM {X TWO},NAME[] \"a\",A[2] 5}|{CM {X 2}, NAME[] \"a\", A[2] 5}",
        "TWO|2",
        "two|2",
        "LIST[TWO]|7",
        "2*TWO+1|5",
        "2+TWO*3|8",
        "(2+TWO)*3|12",
        "7/2|3",
        "7/2.0|3.50000",
        "TWO-HALF|1.50000",
        "TWO*HALF|1.00000",
        "1.0/TWO-1|-0.500000",
      })
  void evaluates(String text, String printed) throws KrlErrorException {
    assertThat(ConstantExpressions.evaluate(parse(text), scope).print()).isEqualTo(printed);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '\0',
      value = {
        "VARIABLE|7|found the variable VARIABLE",
        "$SYSTEM|7|found the variable $SYSTEM",
        "SIG|7|found the variable SIG",
        "NOWHERE|7|no variable NOWHERE is declared",
        "EMPTY|7|EMPTY has no value yet",
        "LIST[3]|7|an index is 1 to 2, was given [3]",
        "LIST[1.5]|12|an index is an INT, expected one, found 1.5",
        "SIN(1)|7|found a call of a function",
        "1+TRUE|9|+ - * / take numbers, expected INT or REAL, found TRUE",
        "-#A|8|+ - * / take numbers",
        "NOT TRUE|7|found NOT",
        "B_NOT 1|7|found B_NOT",
        "1==1|8|found EQUAL",
        "1.0<2|10|found LESS",
        "1 B_AND 3|9|found B_AND",
        "1/0|8|a divisor must not be 0",
        "1.0/0|10|a divisor must not be 0",
        "2147483647+1|17|an INT has 32 bits, the result would be 2147483648",
        "-'H80000000'|7|an INT has 32 bits, the result would be 2147483648",
        "{X 1,X 2}|7|field X is there twice",
        "{X[] 5}|8|must hold an array",
      })
  void refusesWhatIsNotConstant(String text, int column, String message) {
    KrlErrorException e =
        catchThrowableOfType(
            KrlErrorException.class, () -> ConstantExpressions.evaluate(parse(text), scope));
    assertThat(e).isNotNull();
    assertThat(e.error().message()).contains(message);
    assertThat(e.error().position()).isEqualTo(new Position("x", 2, column));
    assertThat(e).hasMessage("x:2:" + column + ": " + e.error().message());
  }

  @Test
  void findsConstantsInTheScopeAround() throws KrlErrorException {
    assertThat(ConstantExpressions.evaluate(parse("TWO"), new Scope(scope)))
        .isEqualTo(new KrlInt(2));
  }
}
