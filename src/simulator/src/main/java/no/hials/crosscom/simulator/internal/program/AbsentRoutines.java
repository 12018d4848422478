package no.hials.crosscom.simulator.internal.program;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.simulator.KrlExecutionException;
import org.jspecify.annotations.Nullable;

/**
 * Routines of KSS and of its technology packages that programs call and that are not simulated
 * (docs/reference/krl-language.md#routines-of-kss). A loaded module can have them.
 */
final class AbsentRoutines {
  /** The hooks of inline forms, which do nothing unless a user fills them. */
  private static final Set<String> HOOKS =
      Set.of(
          "USERSPOT",
          "USER_GRP",
          "H50",
          "A10",
          "A20",
          "GL_MAIN",
          "BASISTECH_PLC_INIT",
          "BASISTECH_PLC_LOOP",
          "SUBMIT_CYCLE");

  private static final String HOOKS_OF_TOUCH = "TM_";
  private static final Set<String> CHANNELS =
      Set.of("COPEN", "CREAD", "CWRITE", "CCLOSE", "CIOCTL");

  /** The packages by the prefixes of their routines. */
  private static final Map<String, String> PACKAGES = new LinkedHashMap<>();

  static {
    PACKAGES.put("RSI_", "RSI");
    PACKAGES.put("ST_", "RSI");
    PACKAGES.put("EKI_", "EKI");
  }

  /** Others, of which only the names are known. */
  private static final Set<String> OTHERS =
      Set.of(
          "EK",
          "LK",
          "EB",
          "SYNC",
          "GETSYSSTATE",
          "ISMESSAGESET",
          "MBX_REC",
          "TEST_BRAKE",
          "CAST_TO",
          "CAST_FROM",
          "MD_CMD",
          "STRTOINT",
          "STRTOREAL",
          "FRAND",
          "VARTYPE",
          "TIMER_LIMIT",
          "ROB_STOP",
          "WSPACEGIVE",
          "TOOL_ADJ",
          "DELETE_BACKWARD_BUFFER");

  private AbsentRoutines() {}

  /** Returns whether a call does nothing; the name is in upper case. */
  static boolean isHook(String key) {
    return HOOKS.contains(key) || key.startsWith(HOOKS_OF_TOUCH);
  }

  /** Returns the message of a program that reaches the call; null if the name is unknown. */
  static @Nullable KrlExecutionException reached(String key) {
    if (CHANNELS.contains(key)) {
      return new KrlExecutionException(
          KrlExecutionException.CHANNEL, key + ": channels are not simulated");
    }
    for (Map.Entry<String, String> entry : PACKAGES.entrySet()) {
      if (key.startsWith(entry.getKey())) {
        return new KrlExecutionException(
            KrlExecutionException.NOT_ALLOWED, key + ": " + entry.getValue() + " is not simulated");
      }
    }
    return OTHERS.contains(key)
        ? new KrlExecutionException(
            KrlExecutionException.NOT_ALLOWED, key + ": this routine of KSS is not simulated")
        : null;
  }
}
