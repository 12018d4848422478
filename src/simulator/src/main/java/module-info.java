/** A simulated KR C4 without a network: variables, programs, a robot that moves, and files. */
@SuppressWarnings("module") // the mock server is compiled later
module no.hials.crosscom.simulator {
  requires transitive no.hials.crosscom.kinematics;
  requires transitive no.hials.crosscom.lang;
  requires transitive no.hials.crosscom.protocol;
  requires org.slf4j;
  requires static org.jspecify;

  exports no.hials.crosscom.simulator;
  exports no.hials.crosscom.simulator.internal to
      no.hials.crosscom.mock;
  exports no.hials.crosscom.simulator.internal.files to
      no.hials.crosscom.mock;
}
