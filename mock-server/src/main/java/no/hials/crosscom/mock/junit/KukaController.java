package no.hials.crosscom.mock.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import no.hials.crosscom.mock.FaultRule;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Starts a {@link MockServer} for a test class or a test.
 *
 * <pre>{@code
 * class WeldingTest {
 *   @KukaController MockServer robot;
 *
 *   @Test
 *   void setsTheOverride() throws IOException {
 *     try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
 *       client.writeText("$OV_PRO", "50");
 *     }
 *     assertThat(robot.variables().get("$OV_PRO")).isEqualTo("50");
 *   }
 *
 *   @Test
 *   void copesWithASlowController(@KukaController(latency = "krc4") MockServer slow) {
 *     // reads and writes take the time of a KR C4
 *   }
 * }
 * }</pre>
 *
 * <p>A static field holds one server for all tests of its class and its nested classes; an instance
 * field gets a new server for each test. A parameter of a test, {@code @BeforeEach} or
 * {@code @AfterEach} method or of the constructor gets a new server for each test; a parameter of a
 * {@code @BeforeAll} method, or of the constructor if one instance runs all tests, gets one for the
 * class. Each annotated field or parameter has a different server. The servers listen on free ports
 * of the loopback address, and are closed after the test or class.
 *
 * <p>Tests can run in parallel if each has its own server: as a parameter or, with an instance for
 * each test, as an instance field.
 *
 * <p>Without {@link #programs}, {@link #start}, {@link #submit} and {@link #mode}, the variables
 * stand still until the test calls {@link MockServer#controller}.
 *
 * <p>The annotation also works as a meta-annotation.
 */
@Target({ElementType.FIELD, ElementType.PARAMETER, ElementType.ANNOTATION_TYPE})
@Retention(RetentionPolicy.RUNTIME)
@Documented
@ExtendWith(MockServerExtension.class)
public @interface KukaController {

  /** The server to simulate, KUKAVARPROXY by default. */
  ServerType server() default ServerType.KUKAVARPROXY;

  /**
   * Whether the server has all limits of a real controller, see {@link
   * MockServerConfig.Builder#asOnTheController}. The other attributes override them.
   */
  boolean asOnTheController() default false;

  /**
   * The time that the controller takes for a request, see {@link Latency#parse}: {@code none}, a
   * time such as {@code 5ms}, {@code krc4} or {@code krc4-2014}. The default, empty, stands for
   * none or for the latency of {@link #asOnTheController}.
   */
  String latency() default "";

  /**
   * The faults, as the text of {@link FaultRule}, such as {@code drop@3}. The first rule that
   * applies to a request decides.
   */
  String[] faults() default {};

  /** The seed of latency and faults. The same seed gives the same times and faults. */
  long seed() default 1;

  /**
   * The number of clients that are served at a time, 0 for no limit. The default, {@link
   * Integer#MIN_VALUE}, stands for the limit of the {@link #server}.
   */
  int maxClients() default Integer.MIN_VALUE;

  /**
   * The archive of a controller to load before everything else: the path of a zip or a folder, see
   * {@link MockServerConfig.Builder#archive}; empty for none. Its programs can be started by {@link
   * #start}.
   */
  String archive() default "";

  /**
   * The data lists to load before the programs: paths of files such as {@code krl/config.dat}, or
   * {@code classpath:} and the name of a resource such as {@code classpath:/cell/config.dat}.
   */
  String[] dataLists() default {};

  /**
   * The programs to load: paths of {@code .src} and {@code .sub} files, or {@code classpath:} and
   * the name of a resource. A file is loaded with the data list of the same name next to it; the
   * data list of a resource must be in {@link #dataLists}.
   */
  String[] programs() default {};

  /** The module that the robot interpreter selects and starts, empty for none. */
  String start() default "";

  /** The module that the submit interpreter selects and starts, empty for none. */
  String submit() default "";

  /** The operating mode. */
  OperatingMode mode() default OperatingMode.T1;

  /**
   * The clock of programs and robot, see {@link SimulationClock#parse}: {@code stepped} for a test
   * that calls {@link Controller#step}; {@code real}, {@code max}, or a factor.
   */
  String clock() default "real";
}
