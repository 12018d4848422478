package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** One mistake is one error, and the rest of the file is parsed. */
class RecoveryTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        // a missing end
        "IF A THEN;B=1                         | 4:1 expected ENDIF of the IF in line 2, found END",
        "LOOP;IF A THEN;ENDLOOP;B=1            | 4:1 expected ENDIF of the IF in line 3, found ENDLOOP",
        "IF A THEN;WHILE B;ELSE;B=1;ENDIF      | 4:1 expected ENDWHILE of the WHILE in line 3, found ELSE",
        "SWITCH A;CASE 1;FOR I=1 TO 2;CASE 2;ENDSWITCH | 5:1 expected ENDFOR of the FOR in line 4, found CASE",
        "REPEAT;LOOP;UNTIL A                   | 4:1 expected ENDLOOP of the LOOP in line 3, found UNTIL",
        "LOOP;LOOP;LOOP                        | 5:1 expected ENDLOOP of the LOOP in line 4, found END",
        // a wrong end
        "IF A THEN;ENDWHILE                    | 3:1 expected ENDIF of the IF in line 2, found ENDWHILE",
        "IF A THEN;ENDWHILE;ENDIF              | 3:1 expected ENDIF of the IF in line 2, found ENDWHILE",
        "WHILE A;ENDLOOP;B=1                   | 3:1 expected ENDWHILE of the WHILE in line 2, found ENDLOOP",
        // a superfluous end
        "IF A THEN;ENDIF;ENDIF                 | 4:1 ENDIF without IF",
        "ENDSWITCH                             | 2:1 ENDSWITCH without SWITCH",
        "ENDFOR                                | 2:1 ENDFOR without FOR",
        "ENDWHILE                              | 2:1 ENDWHILE without WHILE",
        "ENDLOOP                               | 2:1 ENDLOOP without LOOP",
        "UNTIL A                               | 2:1 UNTIL without REPEAT",
        "ELSE                                  | 2:1 ELSE without IF",
        "CASE 1                                | 2:1 CASE without SWITCH",
        "DEFAULT                               | 2:1 DEFAULT without SWITCH",
        // branches
        "IF A THEN;ELSE;ELSE;ENDIF             | 4:1 expected ENDIF, found ELSE",
        "SWITCH A;CASE 1;DEFAULT;CASE 2;ENDSWITCH | 5:1 expected ENDSWITCH, found CASE",
        "SWITCH A;CASE 1;DEFAULT;DEFAULT;ENDSWITCH | 5:1 expected ENDSWITCH, found DEFAULT",
        "SWITCH A;B=1;B=2;CASE 1;ENDSWITCH     | 3:1 expected CASE, found B",
        "SWITCH A;LOOP;ENDLOOP;CASE 1;ENDSWITCH | 3:1 expected CASE, found LOOP",
        "SWITCH A;ENDSWITCH                    | 3:1 expected CASE, found ENDSWITCH",
        "SWITCH A;DEFAULT;ENDSWITCH            | 3:1 expected CASE, found DEFAULT",
        // an error in the first line
        "IF A == THEN;B=1;ELSE;B=2;ENDIF       | 2:9 expected a value, found THEN",
        "IF A THEN B=1;C=1                     | 2:11 expected the end of the line, found B",
        "FOR I;B=1;EXIT;ENDFOR                 | 2:6 expected =, found the end of the line",
        "WHILE;EXIT;ENDWHILE                   | 2:6 expected a value, found the end of the line",
        "SWITCH;CASE 1;B=1;DEFAULT;ENDSWITCH   | 2:7 expected a value, found the end of the line",
        "LOOP X;EXIT;ENDLOOP                   | 2:6 expected the end of the line, found X",
        "REPEAT X;EXIT;UNTIL B                 | 2:8 expected the end of the line, found X",
        // an error in the last line
        "IF A THEN;ENDIF X;B=1                 | 3:7 expected the end of the line, found X",
        "IF A THEN;ELSE X;ENDIF                | 3:6 expected the end of the line, found X",
        "REPEAT;UNTIL;B=1                      | 3:6 expected a value, found the end of the line",
        // mistyped words
        "IFF A THEN;B=1;ELSE;B=2;ENDIF         | 2:1 unknown statement IFF; a type needs DECL before it",
        "LOP;EXIT;ENDLOOP                      | 2:1 unknown statement LOP: expected = or ( after it, found the end of the line",
        "IF A THEN;ENDFI                       | 3:1 unknown statement ENDFI: expected = or ( after it, found the end of the line",
        "IF A THEN;IFF B THEN;ELSE;ENDIF;ELSE;ENDIF | 3:1 unknown statement IFF; a type needs DECL before it",
        // errors in labels and declarations
        "GOTO L;L: B=1                         | 3:4 expected the end of the line, found B",
        "INT I;INT J J;INT K                   | 3:7 expected =, a comma or the end of the line, found J",
      })
  void reportsOneMistakeOnce(String lines, String error) {
    assertThat(errors(routine(lines.replace(';', '\n')))).containsExactly(error);
  }

  @Test
  void takesAMistypedEndForTheEnd() {
    assertThat(errors(KrlParser.parse(Snippets.FILE, "DEF A()\nEDN\nDEF B()\nC=)\nEND")))
        .containsExactly(
            "2:1 unknown statement EDN: expected = or ( after it, found the end of the line",
            "4:3 expected a value, found )");
  }

  @Test
  void checksTheRestOfTheFile() {
    ParseResult result =
        KrlParser.parse(
            Snippets.FILE,
            """
            DEF A(
            B=)
            END
            DEF C()
            IF D=1 THEN
            E=§
            ENDIF
            END
            GLOBAL DEFFCT INT F(G:IN)
            INT G
            RETURN G+
            ENDFCT
            """);

    assertThat(errors(result))
        .containsExactly(
            "1:7 expected a name or ), found the end of the line",
            "2:3 expected a value, found )",
            "5:5 expected THEN, found =",
            "6:3 expected a value, found the character §",
            "11:10 expected a value, found the end of the line");
    assertThat(show(result.file().orElseThrow()))
        .isEqualTo(
            "SourceFile([Routine(false, -, [], C, [], [],"
                + " [Invalid(expected THEN, found =)]), Routine(true, INT, [], F,"
                + " [Parameter(G, 0, false)], [Variables(false, false, INT,"
                + " [Declarator(G, [], -)], )],"
                + " [Invalid(expected a value, found the end of the line)])])");
  }

  @Test
  void keepsABlockAroundLinesWithErrors() {
    ParseResult result =
        routine(
            """
            WHILE A
            B=)
            SWITCH C
            CASE
            D=1
            CASE 2
            E=1
            ENDSWITCH
            ENDWHILE""");

    assertThat(result.errors()).hasSize(2);
    assertThat(show(result.file().orElseThrow()))
        .isEqualTo(
            "SourceFile([Routine(false, -, [], T, [], [], [While(A,"
                + " [Invalid(expected a value, found )),"
                + " Invalid(expected a value, found the end of the line)])])])");
  }

  @Test
  void givesTheErrorsInTheOrderOfTheFile() {
    assertThat(errors(routine("GOTO X\nA=)\nB=)\nGOTO Y")))
        .containsExactly(
            "2:1 unknown label X",
            "3:3 expected a value, found )",
            "4:3 expected a value, found )",
            "5:1 unknown label Y");
  }
}
