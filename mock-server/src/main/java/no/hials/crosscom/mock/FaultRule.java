package no.hials.crosscom.mock;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import no.hials.crosscom.mock.internal.FaultRuleParser;

/**
 * A fault and a condition: the number of the request, the name of the variable, a probability, or
 * several of these, which must all hold. {@link MockServer#faults} takes it:
 *
 * <pre>{@code
 * server.faults(FaultRule.of(Fault.drop()).onRequest(3));
 * server.faults(FaultRule.of(Fault.closeAfter()).onVariable("$OV_PRO").withProbability(0.01, 1));
 * server.faults(FaultRule.parse("delay:200ms@$POS_ACT%0.5", 1));
 * }</pre>
 *
 * <p>The text form, also for the command line and {@code @KukaController}, is {@code
 * FAULT[:ARGUMENT][@NUMBERS][@NAME][%PROBABILITY]}, without blanks around the signs:
 *
 * <table>
 * <caption>Requests</caption>
 * <tr><th>text</th><th>meaning</th></tr>
 * <tr><td>{@code @3}</td><td>the third request, counted from 1 over all clients</td></tr>
 * <tr><td>{@code @5-10}</td><td>the fifth to the tenth</td></tr>
 * <tr><td>{@code @5-}</td><td>the fifth and all after it</td></tr>
 * <tr><td>{@code @$OV_PRO}</td><td>the requests for a variable, see {@link #onVariable}</td></tr>
 * <tr><td>{@code %0.01}</td><td>one of a hundred of these, at random</td></tr>
 * </table>
 *
 * <table>
 * <caption>Faults; names in any case</caption>
 * <tr><th>text</th><th>fault</th></tr>
 * <tr><td>{@code none}</td><td>{@link Fault#none}, which exempts requests from later rules</td></tr>
 * <tr><td>{@code raw:HEX[,HEX...]}</td><td>{@link Fault#raw}</td></tr>
 * <tr><td>{@code answer:VALUE}</td><td>{@link Fault#answer} with the tail of success; put a
 * backslash before {@code @}, {@code %} and a backslash in the value</td></tr>
 * <tr><td>{@code failure[:VALUE]}</td><td>{@link Fault#answer} with the tail of failure; without
 * VALUE the value is empty</td></tr>
 * <tr><td>{@code emptyAnswer}</td><td>{@link Fault#emptyAnswer}</td></tr>
 * <tr><td>{@code drop}</td><td>{@link Fault#drop}</td></tr>
 * <tr><td>{@code dropAnswer}</td><td>{@link Fault#dropAnswer}</td></tr>
 * <tr><td>{@code closeBefore}</td><td>{@link Fault#closeBefore}</td></tr>
 * <tr><td>{@code resetBefore}</td><td>{@link Fault#resetBefore}</td></tr>
 * <tr><td>{@code closeDuring:BYTES}</td><td>{@link Fault#closeDuring}</td></tr>
 * <tr><td>{@code closeAfter}</td><td>{@link Fault#closeAfter}</td></tr>
 * <tr><td>{@code delay:TIME}</td><td>{@link Fault#delay}; a time up to an hour is {@code 200us},
 * {@code 1.5ms}, {@code 2s}, {@code 1m} or {@code 5}, in ms without a unit</td></tr>
 * <tr><td>{@code split:SIZE[,SIZE...][,PAUSE]}</td><td>{@link Fault#split}; the pause between two
 * pieces is a time with its unit</td></tr>
 * <tr><td>{@code oneByteAtATime[:PAUSE]}</td><td>{@link Fault#oneByteAtATime()}</td></tr>
 * <tr><td>{@code answerTwice}</td><td>{@link Fault#answerTwice}</td></tr>
 * <tr><td>{@code glueToNext}</td><td>{@link Fault#glueToNext}</td></tr>
 * <tr><td>{@code wrongId[:DIFFERENCE]}</td><td>{@link Fault#wrongId}; by 1 if it is omitted</td></tr>
 * <tr><td>{@code wrongFunction:FUNCTION}</td><td>{@link Fault#wrongFunction}</td></tr>
 * <tr><td>{@code wrongLength:DIFFERENCE}</td><td>{@link Fault#wrongLength}</td></tr>
 * <tr><td>{@code truncate:BYTES}</td><td>{@link Fault#truncate}</td></tr>
 * <tr><td>{@code garbage:LENGTH}</td><td>{@link Fault#garbage} of the rule's seed</td></tr>
 * </table>
 *
 * <p>{@link Fault#hold} has no text, because only a test can release it. A rule is immutable and
 * keeps no state: the random choice depends only on the seed and the request's number, so it is the
 * same in every run and for every server that uses the rule.
 *
 * @param fault the fault
 * @param first the number of the first request, from 1
 * @param last the number of the last request
 * @param variable the name of the variable in upper case, empty for all requests
 * @param probability the share of these requests that get the fault, 0 to 1
 * @param seed the same seed chooses the same requests
 */
public record FaultRule(
    Fault fault, long first, long last, String variable, double probability, long seed)
    implements Function<RecordedRequest, Optional<Fault>> {

  public FaultRule {
    Objects.requireNonNull(fault, "fault");
    if (first < 1 || last < first) {
      throw new IllegalArgumentException(
          "requests must be first to last from 1, are " + first + " to " + last);
    }
    variable = variable.strip().toUpperCase(Locale.ROOT);
    // this form also refuses NaN
    if (!(probability >= 0 && probability <= 1)) {
      throw new IllegalArgumentException("probability must be 0 to 1, is " + probability);
    }
  }

  /** Returns a rule for every request. */
  public static FaultRule of(Fault fault) {
    return new FaultRule(fault, 1, Long.MAX_VALUE, "", 1, 0);
  }

  /**
   * Parses the text form.
   *
   * @param text such as {@code drop@3}, see above
   * @param seed the seed of probability and garbage; rules with different texts and the same seed
   *     choose independently
   * @throws IllegalArgumentException if the text is not a rule; the message names the column, the
   *     expected and the actual text
   */
  public static FaultRule parse(String text, long seed) {
    return new FaultRuleParser(text, seed).parse();
  }

  /**
   * Restricts the rule to one request.
   *
   * @param number its number, from 1, as in {@link RecordedRequest#number}
   */
  public FaultRule onRequest(long number) {
    return onRequests(number, number);
  }

  /**
   * Restricts the rule to consecutive requests.
   *
   * @param newFirst the number of the first, from 1, as in {@link RecordedRequest#number}
   * @param newLast the number of the last
   */
  public FaultRule onRequests(long newFirst, long newLast) {
    return new FaultRule(fault, newFirst, newLast, variable, probability, seed);
  }

  /**
   * Restricts the rule to the requests for a variable, alone or with others.
   *
   * @param name the name in any case: {@code $POS_ACT} for the variable and its components and
   *     elements; {@code $POS_ACT.X} or {@code LOAD_DATA[1]} for this part and its parts
   */
  public FaultRule onVariable(String name) {
    if (name.isBlank()) {
      throw new IllegalArgumentException("a variable's name must not be blank");
    }
    return new FaultRule(fault, first, last, name, probability, seed);
  }

  /**
   * Restricts the rule to a random part of its requests.
   *
   * @param newProbability the share, 0 for none to 1 for all
   * @param newSeed the same seed chooses the same requests
   */
  public FaultRule withProbability(double newProbability, long newSeed) {
    return new FaultRule(fault, first, last, variable, newProbability, newSeed);
  }

  /** Returns the fault of a request, empty if the rule does not apply to it. */
  @Override
  public Optional<Fault> apply(RecordedRequest request) {
    long number = request.number();
    boolean hit =
        number >= first && number <= last && isFor(request.names()) && draw(number) < probability;
    return hit ? Optional.of(fault) : Optional.empty();
  }

  private boolean isFor(List<String> names) {
    return variable.isEmpty() || names.stream().anyMatch(this::isFor);
  }

  private boolean isFor(String name) {
    String asked = name.strip().toUpperCase(Locale.ROOT);
    return asked.startsWith(variable)
        && (asked.length() == variable.length()
            || ".[".indexOf(asked.charAt(variable.length())) >= 0);
  }

  /** Returns 0 to below 1. The two steps make the numbers of neighbouring seeds independent. */
  private double draw(long number) {
    long start = new SplittableRandom(seed).nextLong();
    return new SplittableRandom(start + number).nextDouble();
  }
}
