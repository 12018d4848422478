package no.hials.crosscom.lang;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class TypeSwitchTest {
  private sealed interface Shape {}

  private sealed interface Round extends Shape {}

  private record Circle(int radius) implements Round {}

  private record Ellipse(int width, int height) implements Round {}

  private record Square(int side) implements Shape {}

  private final List<String> handled = new ArrayList<>();

  @Test
  void runsTheCaseOfTheClass() {
    TypeSwitch<List<String>, Shape, Void, RuntimeException> shapes =
        TypeSwitch.create(
            Shape.class,
            cases ->
                cases
                    .run(Square.class, (list, square) -> list.add("square " + square.side()))
                    .run(Circle.class, (list, circle) -> list.add("circle " + circle.radius()))
                    .run(Ellipse.class, (list, it) -> list.add("ellipse " + it.height())));
    shapes.run(handled, new Ellipse(1, 2));
    shapes.run(handled, new Square(3));
    shapes.run(handled, new Circle(4));
    assertThat(handled).containsExactly("ellipse 2", "square 3", "circle 4");
  }

  @Test
  void runsTheCaseOfASealedInterfaceForEachClassOfIt() {
    TypeSwitch<String, Shape, String, RuntimeException> shapes =
        TypeSwitch.create(
            Shape.class,
            cases ->
                cases
                    .on(Round.class, (prefix, round) -> prefix + "round")
                    .on(Square.class, (prefix, square) -> prefix + "square"));
    assertThat(shapes.apply("a ", new Circle(1))).isEqualTo("a round");
    assertThat(shapes.apply("an ", new Ellipse(1, 2))).isEqualTo("an round");
  }

  @Test
  void runsTheCaseOtherwiseForTheRestOfTheFamily() {
    TypeSwitch<List<String>, Shape, Void, RuntimeException> shapes =
        TypeSwitch.create(
            Shape.class,
            cases ->
                cases
                    .run(Circle.class, (list, circle) -> list.add("circle " + circle.radius()))
                    .otherwise((list, shape) -> list.add("other")));
    shapes.run(handled, new Circle(1));
    shapes.run(handled, new Square(1));
    shapes.run(handled, new Ellipse(1, 2));
    assertThat(handled).containsExactly("circle 1", "other", "other");
  }

  @Test
  void namesTheClassWithoutAResult() {
    TypeSwitch<List<String>, Shape, String, RuntimeException> shapes =
        TypeSwitch.create(Shape.class, cases -> cases.otherwise((list, shape) -> {}));
    assertThatNullPointerException()
        .isThrownBy(() -> shapes.apply(handled, new Square(1)))
        .withMessage("the case for " + Square.class.getName() + " has no result");
  }

  @Test
  void refusesASwitchWithoutACaseForEachClass() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                TypeSwitch.<String, Shape, Void, RuntimeException>create(
                    Shape.class,
                    cases -> cases.run(Circle.class, (x, c) -> {}).run(Square.class, (x, s) -> {})))
        .withMessage("no case for " + Ellipse.class.getName());
  }

  @Test
  void refusesTwoCasesForAClass() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                TypeSwitch.<String, Shape, Void, RuntimeException>create(
                    Shape.class,
                    cases -> cases.run(Round.class, (x, r) -> {}).run(Circle.class, (x, c) -> {})))
        .withMessage("two cases for " + Circle.class.getName());
  }
}
