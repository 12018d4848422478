package no.hials.crosscom.mock.internal.program;

/** One instruction of the machine: takes its operands from the stack and puts its result there. */
@FunctionalInterface
interface Operation {
  void execute(Machine machine) throws ProgramFault;
}
