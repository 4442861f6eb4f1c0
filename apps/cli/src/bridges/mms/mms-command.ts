/** `mms`: starts a micromouse program, which drives the robot. */
import { exitCodes, type Command } from "../../command.ts";
import { InputError } from "../../input-error.ts";
import { bridgeArguments } from "../bridge-arguments.ts";
import { runBridge } from "../run-bridge.ts";
import { driveMouse } from "./drive-mouse.ts";
import { splitProgram } from "./split-program.ts";

const help = `Usage: corridor mms "http://HOST/r/ID#KEY" -- PROGRAM [ARGUMENTS]

Starts a program for the micromouse simulator mms, without a change: it writes commands such as
"moveForward" to its standard output, and reads the responses from its standard input. What it prints
to standard error appears here. The robot is put at its start first. Press Ctrl+C to stop both.

Without an argument before --, the address is read from the variable CORRIDOR_ROBOT.

Options:
  --help  print this text

Example:
  corridor mms "http://HOST/r/ID#KEY" -- python3 Main.py

${exitCodes("the program has ended, or was stopped with Ctrl+C", "the program failed, or the robot cannot be used")}`;

export const command: Command = {
  help,
  run: (args) => {
    const { own, program } = splitProgram(args);
    if (program === null) {
      throw new InputError([
        "program: found nothing, expected -- and a program, such as -- ./mouse",
      ]);
    }
    const { address } = bridgeArguments(own, {});
    return runBridge({
      protocol: "mms",
      address,
      start: async (robot) => driveMouse(robot, program),
    });
  },
};
