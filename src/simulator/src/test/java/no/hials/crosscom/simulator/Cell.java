package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;

/** A controller in mode AUT whose time a test lets pass; A5 is not at 0, where it is singular. */
final class Cell implements AutoCloseable {
  static final Axis START = Axis.of(0, -90, 90, 0, 45, 0);
  private static final Duration LIMIT = Duration.ofMinutes(5);

  final Controller controller;

  Cell() {
    controller = stepped(VariableTable.krc4());
    controller.setMode(OperatingMode.AUT);
    controller.place(START);
  }

  /** Creates a cell of another controller, in mode AUT and without BCO runs. */
  Cell(Controller controller) {
    this.controller = controller;
    controller.simulateBco(false);
    controller.setMode(OperatingMode.AUT);
  }

  /** Waits for something that must come; the build's time limit ends it otherwise. */
  static void await(BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      Thread.onSpinWait();
    }
  }

  /** Creates a controller whose time passes in steps. */
  static Controller stepped(VariableTable variables) {
    return with(variables, SimulationClock.stepped());
  }

  /** Creates a controller without BCO runs, which have a test of their own. */
  static Controller with(VariableTable variables, SimulationClock clock) {
    Controller controller =
        new Controller(variables, clock, RobotModel.kr6r900sixx(), "simulator-test-clock");
    controller.simulateBco(false);
    return controller;
  }

  /** Creates a module of statements; they begin in line 2. */
  static String module(String name, String body) {
    return "DEF " + name + "()\n" + body + "\nEND\n";
  }

  Cell load(String text) throws KrlFileException {
    controller.load("test.src", text);
    return this;
  }

  /** Loads, selects and starts a program of the robot. */
  Cell start(String body) throws KrlFileException {
    startModule("TEST", module("TEST", body));
    return this;
  }

  void startModule(String name, String text) throws KrlFileException {
    load(text);
    controller.robot().select(name);
    controller.robot().start();
  }

  /** Executes statements to their end. */
  Cell run(String body) throws KrlFileException {
    start(body);
    runToTheEnd();
    return this;
  }

  void runToTheEnd() {
    until(() -> controller.robot().state() != ProgramState.ACTIVE);
    assertThat(controller.messages()).isEmpty();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  void submit(String body) throws KrlFileException {
    controller.load("sps.sub", module("SPS", body));
    controller.submit().select("SPS");
    controller.submit().start();
  }

  void cycles(int count) {
    controller.step(Duration.ofMillis(12L * count));
  }

  void seconds(int count) {
    controller.step(Duration.ofSeconds(count));
  }

  void until(BooleanSupplier condition) {
    assertThat(controller.stepUntil(condition, LIMIT)).isTrue();
  }

  void untilStanding() {
    until(controller::standing);
  }

  /** Returns number and text of the only message. */
  String message() {
    assertThat(controller.messages()).hasSize(1);
    return controller.messages().get(0).toString();
  }

  String get(String name) {
    return controller.variables().get(name);
  }

  void set(String name, String value) {
    controller.variables().set(name, value);
  }

  double real(String name) {
    return ((KrlReal) controller.variables().value(name)).value();
  }

  double component(String name, String field) {
    KrlStruct struct = (KrlStruct) controller.variables().value(name);
    return ((KrlReal) struct.get(field).orElseThrow()).value();
  }

  @Override
  public void close() {
    controller.close();
  }
}
