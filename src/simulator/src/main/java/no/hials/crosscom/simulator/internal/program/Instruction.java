package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.KrlExecutionException;

/** One instruction of the machine: takes its operands from the stack and puts its result there. */
@FunctionalInterface
interface Instruction {
  void execute(KrlVirtualMachine machine) throws KrlExecutionException;
}
