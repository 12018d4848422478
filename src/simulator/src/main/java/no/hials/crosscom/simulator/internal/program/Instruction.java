package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.ProgramFault;

/** One instruction of the machine: takes its operands from the stack and puts its result there. */
@FunctionalInterface
interface Instruction {
  void execute(KrlVirtualMachine machine) throws ProgramFault;
}
