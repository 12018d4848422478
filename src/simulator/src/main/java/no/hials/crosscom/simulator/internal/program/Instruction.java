package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.KrlExecutionException;

/** An instruction of the machine: takes its operands from the stack and leaves its result there. */
@FunctionalInterface
interface Instruction {
  void execute(KrlVirtualMachine machine) throws KrlExecutionException;
}
