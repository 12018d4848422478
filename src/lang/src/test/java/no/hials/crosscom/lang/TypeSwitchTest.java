package no.hials.crosscom.lang;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

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
    TypeSwitch<Shape, RuntimeException> shapes =
        TypeSwitch.create(
            Shape.class,
            cases ->
                cases
                    .on(Square.class, square -> handled.add("square " + square.side()))
                    .on(Circle.class, circle -> handled.add("circle " + circle.radius()))
                    .on(Ellipse.class, ellipse -> handled.add("ellipse " + ellipse.height())));
    shapes.handle(new Ellipse(1, 2));
    shapes.handle(new Square(3));
    shapes.handle(new Circle(4));
    assertThat(handled).containsExactly("ellipse 2", "square 3", "circle 4");
  }

  @Test
  void runsTheCaseOfASealedInterfaceForEachClassOfIt() {
    TypeSwitch<Shape, RuntimeException> shapes =
        TypeSwitch.create(
            Shape.class,
            cases ->
                cases
                    .on(Round.class, round -> handled.add("round"))
                    .on(Square.class, square -> handled.add("square")));
    shapes.handle(new Circle(1));
    shapes.handle(new Ellipse(1, 2));
    assertThat(handled).containsExactly("round", "round");
  }

  @Test
  void refusesASwitchWithoutACaseForEachClass() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                TypeSwitch.<Shape, RuntimeException>create(
                    Shape.class,
                    cases -> cases.on(Circle.class, c -> {}).on(Square.class, s -> {})))
        .withMessage("no case for " + Ellipse.class.getName());
  }

  @Test
  void refusesTwoCasesForAClass() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                TypeSwitch.<Shape, RuntimeException>create(
                    Shape.class, cases -> cases.on(Round.class, r -> {}).on(Circle.class, c -> {})))
        .withMessage("two cases for " + Circle.class.getName());
  }
}
