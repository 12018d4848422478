package no.hials.crosscom.simulator.internal.core;

import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlBool;

/**
 * The signals of a higher-level controller in mode EXT
 * (docs/reference/krl-language.md#automatic-external). Machine data wire them to inputs; without
 * them the drives stay on, and only Java code starts programs.
 */
final class AutomaticExternal {
  private static final String ACTIVE = "$I_O_ACTCONF";

  /** Called when a signal changes. */
  interface Actions {
    void confirm();

    void start();

    void stop();
  }

  private final SystemVariableAccess access;
  private final Actions actions;
  private boolean drives = true;
  private boolean lastOn;
  private boolean lastConfirm;
  private boolean lastStart;

  AutomaticExternal(SystemVariableAccess access, Actions actions) {
    this.access = access;
    this.actions = actions;
  }

  /** Returns whether the drives are on, as far as the signals decide it. */
  boolean drives() {
    return drives;
  }

  void cycle(OperatingMode mode) {
    boolean active = mode == OperatingMode.EXT && access.bool("$I_O_ACT", true);
    if (access.bool(ACTIVE, active) != active) {
      access.write(ACTIVE, new KrlBool(active));
    }
    boolean on = access.bool("$DRIVES_ON", false);
    boolean confirm = access.bool("$CONF_MESS", false);
    boolean start = access.bool("$EXT_START", false);
    if (active) {
      boolean enabled = access.bool("$MOVE_ENABLE", true) && access.bool("$DRIVES_OFF", true);
      if (!enabled) {
        if (drives) {
          actions.stop();
        }
        drives = false;
      } else if (on && !lastOn) {
        drives = true;
      }
      if (confirm && !lastConfirm) {
        actions.confirm();
      }
      if (start && !lastStart) {
        actions.start();
      }
    } else {
      drives = true;
    }
    lastOn = on;
    lastConfirm = confirm;
    lastStart = start;
  }
}
