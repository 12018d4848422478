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
 * <p>A static field holds one server for all tests of its class, and of the classes nested in it;
 * an instance field is given a new one for each test. A parameter of a test, {@code @BeforeEach} or
 * {@code @AfterEach} method or of the constructor is a new one for each test; of a
 * {@code @BeforeAll} method, and of the constructor when one instance serves all tests, one for the
 * class. Each annotated field or parameter is a server of its own. All are closed when that test or
 * class has ended, and listen on free ports of the loopback address.
 *
 * <p>Tests may run in parallel, as far as a field is not shared: two tests at a time need a server
 * each, so parameters or, with an instance for each test, instance fields.
 *
 * <p>Without {@link #programs}, {@link #start}, {@link #submit} and {@link #mode} the variables
 * stand still until the test asks for {@link MockServer#controller}.
 *
 * <p>The annotation can be put on an annotation of your own, too, to name a set of attributes.
 */
@Target({ElementType.FIELD, ElementType.PARAMETER, ElementType.ANNOTATION_TYPE})
@Retention(RetentionPolicy.RUNTIME)
@Documented
@ExtendWith(MockServerExtension.class)
public @interface KukaController {

  /**
   * Gives which server it is.
   *
   * @return the server; KUKAVARPROXY by default
   */
  ServerType server() default ServerType.KUKAVARPROXY;

  /**
   * Says whether the server keeps all rules of a real controller, see {@link
   * MockServerConfig.Builder#asOnTheController}. The other attributes come on top.
   *
   * @return true for a strict server
   */
  boolean asOnTheController() default false;

  /**
   * Gives the time that the controller takes for a request, see {@link Latency#parse}.
   *
   * @return {@code none}, a time such as {@code 5ms}, {@code krc4} or {@code krc4-2014}; empty, the
   *     default, for none or as {@link #asOnTheController} says
   */
  String latency() default "";

  /**
   * Gives what goes wrong, see {@link FaultRule}.
   *
   * @return rules as text, such as {@code drop@3}; for each request the first that hits it counts
   */
  String[] faults() default {};

  /**
   * Gives the seed of latency and faults.
   *
   * @return the same seed gives the same times and faults
   */
  long seed() default 1;

  /**
   * Gives the number of clients that are served at a time.
   *
   * @return 0 for no limit; {@link Integer#MIN_VALUE}, the default, for as many as {@link #server}
   *     serves
   */
  int maxClients() default Integer.MIN_VALUE;

  /**
   * Gives the data lists to load, before the programs.
   *
   * @return paths of files such as {@code krl/config.dat}, or {@code classpath:} and the name of a
   *     resource such as {@code classpath:/cell/config.dat}
   */
  String[] dataLists() default {};

  /**
   * Gives the programs to load; the data list of the same name beside a file comes with it, that of
   * a resource is named in {@link #dataLists}.
   *
   * @return paths of {@code .src} and {@code .sub} files, or {@code classpath:} and the name of a
   *     resource
   */
  String[] programs() default {};

  /**
   * Gives the robot's program to select and start.
   *
   * @return the name of a module; empty for none
   */
  String start() default "";

  /**
   * Gives the submit program to select and start.
   *
   * @return the name of a module; empty for none
   */
  String submit() default "";

  /**
   * Gives the operating mode.
   *
   * @return the mode
   */
  OperatingMode mode() default OperatingMode.T1;

  /**
   * Gives how the time of programs and robot passes, see {@link SimulationClock#parse}.
   *
   * @return {@code stepped} for a test that lets it pass by {@link Controller#step}; {@code real},
   *     {@code max}, or a factor
   */
  String clock() default "real";
}
