/**
 * A simulated KR C4 with KUKAVARPROXY or C3 Bridge, to test and try clients without a robot.
 *
 * <p>{@link no.hials.crosscom.mock.MockServer} speaks the protocol over real TCP, {@link
 * no.hials.crosscom.simulator.VariableTable} holds the variables of a KR 6 R900 sixx, with types,
 * access rights and the controller's way of printing, and {@link
 * no.hials.crosscom.simulator.Controller} runs KRL programs on them and moves the robot. The server
 * records its requests ({@link no.hials.crosscom.mock.RecordedRequest}), can be as slow as a
 * controller ({@link no.hials.crosscom.mock.Latency}), and can inject faults ({@link
 * no.hials.crosscom.mock.Fault}, for some requests by {@link no.hials.crosscom.mock.FaultRule}).
 * {@link no.hials.crosscom.mock.junit.KukaController} starts one in a test with JUnit.
 *
 * <pre>{@code
 * try (MockServer server = MockServer.start()) {
 *   server.variables().declare("MYSPEED", "REAL", "0.5");
 *   // a client connects to server.host(), server.port()
 *   server.enqueue(Fault.oneByteAtATime());
 *   // its next answer comes in pieces
 *   assertThat(server.requests()).hasSize(1);
 * }
 * }</pre>
 *
 * <p>The server follows docs/reference/kukavarproxy.md, its values docs/reference/krl-values.md;
 * where these leave a question open, a comment in the code states the assumption. This package
 * needs no test framework.
 */
@NullMarked
package no.hials.crosscom.mock;

import org.jspecify.annotations.NullMarked;
