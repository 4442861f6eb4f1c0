/** `conformance`: checks the host of a robot, and prints each result as soon as it is available. */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import {
  groups,
  linesOf,
  passes,
  readAddress,
  runChecks,
  verdict,
  type Result,
} from "@corridor/conformance";
import { exitCodes, type Command, type Context } from "./command.ts";
import { InputError } from "./input-error.ts";

const help = `Usage: corridor conformance "http://HOST/r/ID#KEY"

Checks that a robot host, simulated or physical, keeps every promise that scripts rely on. A run
takes two to three minutes. Put the address in quotes, because shells treat # as a comment.

The robot moves up to 4.5 m straight ahead. Do not control it by other means during the run. It
needs a pen: an empty rectangle with straight walls, 2 m wide and 5 m long.
  1. Put the robot into the near right corner, with its centre 50 cm from both walls.
  2. Let it face along the right wall.
  3. If the robot has a goal, put the goal into the far right corner.

Options:
  --help  print this text

Results of a check:
  ok                 the host keeps the promise
  FAILED             the host breaks the promise
  not offered        the host lists the feature as unsupported; this is not a failure
  not testable here  the next line contains the reason

The last line is the result of the run:
  PASSED             the host keeps every promise of its features
  FAILED             the host breaks at least one promise
  INCOMPLETE         no promise is broken, but some could not be tested

${exitCodes("PASSED", "FAILED or INCOMPLETE")}`;

export const command: Command = { help, run: conformance };

/** The flag that adds WebSocket to Node.js 20. Later versions have it without a flag. */
const WEBSOCKET_FLAG = "--experimental-websocket";

async function conformance(args: readonly string[], { print, entry }: Context): Promise<number> {
  const { address, robot } = readArguments(args);
  if (!("WebSocket" in globalThis) && !process.execArgv.includes(WEBSOCKET_FLAG)) {
    return runWithWebSocket(entry, args);
  }
  const count = groups.reduce((sum, { checks }) => sum + checks.length, 0);
  print([
    `${count} checks of ${robot}. The robot drives in its pen.`,
    "The page /docs/promises of any Corridor service describes each check by its id.",
  ]);
  let group = "";
  const onResult = (result: Result): void => {
    if (result.group !== group) print(["", result.group]);
    group = result.group;
    print(linesOf(result));
  };
  const results = await runChecks(address, { onResult });
  print(["", verdict(results, new Date().toISOString().slice(0, 10))]);
  return passes(results) ? 0 : 1;
}

/** Runs the command in a process of its own. @returns its exit code */
function runWithWebSocket(entry: URL, args: readonly string[]): number {
  const flags = [...process.execArgv, WEBSOCKET_FLAG, "--no-warnings"];
  const words = [...flags, fileURLToPath(entry), "conformance", ...args];
  return spawnSync(process.execPath, words, { stdio: "inherit" }).status ?? 1;
}

/**
 * Error messages do not contain the arguments, because an address contains a key.
 * @returns the address, and the robot as the report names it @throws InputError
 */
function readArguments(args: readonly string[]): { address: string; robot: string } {
  const [address = ""] = args;
  const parts = readAddress(address);
  if (args.length !== 1 || parts === null) {
    const found = { 0: "nothing", 1: "another text" }[args.length] ?? `${args.length} arguments`;
    throw new InputError([
      `address: found ${found}, expected the address of a robot in quotes, "http://HOST/r/ID#KEY"`,
    ]);
  }
  return { address, robot: `${parts.origin}/r/${parts.id}` };
}
