/** KUKAVARPROXY and C3 Bridge around the simulated controller, and a JUnit extension. */
module no.hials.crosscom.mock {
  requires transitive no.hials.crosscom.simulator;
  requires org.slf4j;
  requires static org.jspecify;
  requires static org.junit.jupiter.api;

  exports no.hials.crosscom.mock;
  exports no.hials.crosscom.mock.junit;

  // JUnit creates the extension
  opens no.hials.crosscom.mock.junit to
      org.junit.platform.commons;
}
