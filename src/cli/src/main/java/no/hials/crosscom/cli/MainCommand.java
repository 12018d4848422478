package no.hials.crosscom.cli;

import picocli.CommandLine.Command;

/** The program without a command, which only has help. */
@Command(
    name = "jopenshowvar",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    synopsisSubcommandLabel = "COMMAND",
    description = {
      "Reads and writes the variables of a KUKA robot controller on which KUKAVARPROXY runs.",
      "A write can move a machine."
    },
    footer = {
      "",
      "Examples:",
      "  jopenshowvar read '$POS_ACT' '$OV_PRO' --host 172.31.1.147",
      "  jopenshowvar write '$OV_PRO' 50 --host 172.31.1.147",
      "  jopenshowvar read '$POS_ACT' --mock",
      "",
      "'jopenshowvar COMMAND --help' tells more, and the exit codes."
    })
final class MainCommand {}
