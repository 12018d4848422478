package no.hials.crosscom.cell;

import java.util.List;
import java.util.stream.IntStream;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.KrlVisitor;

/**
 * Compares the answer to a write with the value that was sent. A server repeats the value
 * (docs/reference/wire-format.md#answers); another value means that the write was not done as
 * intended.
 */
public final class WriteAnswer {
  private WriteAnswer() {}

  /**
   * Checks that an answer has the value that was sent. Numbers are compared as 32-bit floats,
   * unless both are INT; of an aggregate only the fields sent are compared.
   *
   * @param answer the text of the answer; empty if it has no value to compare
   */
  public static void check(String name, String sent, String answer) throws OtherValueException {
    if (!answer.isEmpty() && !answer.equals(sent) && !isEqual(sent, answer)) {
      throw new OtherValueException(
          name
              + ": "
              + sent
              + " was sent, but the answer to the write is "
              + answer
              + "; read the variable to see its value");
    }
  }

  private static boolean isEqual(String sent, String answer) {
    try {
      return isEqual(KrlValue.parse(sent), KrlValue.parse(answer));
    } catch (KrlSyntaxException e) {
      return false;
    }
  }

  private static boolean isEqual(KrlValue sent, KrlValue answer) {
    return sent.accept(new Comparison(answer));
  }

  /** Compares a value sent with its counterpart in the answer. */
  private record Comparison(KrlValue answer) implements KrlVisitor<Boolean> {
    @Override
    public Boolean visit(KrlInt number) {
      return answer instanceof KrlInt ? number.equals(answer) : isFloat(number.value());
    }

    @Override
    public Boolean visit(KrlReal number) {
      return isFloat(number.value());
    }

    private boolean isFloat(float sent) {
      return answer instanceof KrlReal real
          ? real.value() == sent
          : answer instanceof KrlInt number && number.value() == sent;
    }

    @Override
    public Boolean visit(KrlBool bool) {
      return bool.equals(answer);
    }

    @Override
    public Boolean visit(KrlString string) {
      return string.equals(answer);
    }

    @Override
    public Boolean visit(KrlEnum constant) {
      return answer instanceof KrlEnum other && constant.name().equalsIgnoreCase(other.name());
    }

    @Override
    public Boolean visit(KrlStruct struct) {
      return answer instanceof KrlStruct other
          && struct.fields().stream()
              .allMatch(
                  field ->
                      other
                          .get(field.name())
                          .filter(value -> isEqual(field.value(), value))
                          .isPresent());
    }

    @Override
    public Boolean visit(KrlArray array) {
      List<KrlValue> others = answer instanceof KrlArray other ? other.elements() : List.of();
      return array.elements().size() == others.size()
          && IntStream.range(0, others.size())
              .allMatch(i -> isEqual(array.elements().get(i), others.get(i)));
    }
  }
}
