/** `conformance`: checks the host of a robot, and prints each result as soon as it is available. */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import {
  gatewayGroups,
  groups,
  linesOf,
  passes,
  readAddress,
  runChecks,
  verdict,
  type Result,
} from "@corridor/conformance";
import { gatewayNames, type GatewayName } from "@corridor/protocol";
import { exitCodes, type Command, type Context } from "./command.ts";
import { InputError } from "./input-error.ts";

const help = `Usage: corridor conformance "http://HOST/r/ID#KEY" [--gateways [LIST]]

Checks that a robot host, simulated or physical, keeps every promise that scripts rely on. A run
takes two to three minutes. Put the address in quotes, because shells treat # as a comment.

The robot moves up to 4.5 m straight ahead. Do not control it by other means during the run. It
needs a pen: an empty rectangle with straight walls, 2 m wide and 5 m long.
  1. Put the robot into the near right corner, with its centre 50 cm from both walls.
  2. Let it face along the right wall.
  3. If the robot has a goal, put the goal into the far right corner.

Options:
  --gateways [LIST]  also check gateways: endpoints for programs of other protocols. LIST contains
                     ${gatewayNames.join(", ")}, separated by commas; default: all of them
  --help             print this text

Results of a check:
  ok                 the host keeps the promise
  FAILED             the host breaks the promise
  not offered        the host lists the feature as unsupported, or its operator has switched the
                     gateway off; this is not a failure
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
  const { address, robot, gateways } = readArguments(args);
  if (!("WebSocket" in globalThis) && !process.execArgv.includes(WEBSOCKET_FLAG)) {
    return runWithWebSocket(entry, args);
  }
  const chosen = [...groups, ...gateways.map((name) => gatewayGroups[name])];
  const count = chosen.reduce((sum, { checks }) => sum + checks.length, 0);
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
  const results = await runChecks(address, { onResult, groups: chosen });
  print(["", verdict(results, new Date().toISOString().slice(0, 10))]);
  return passes(results) ? 0 : 1;
}

/** Runs the command in a process of its own. @returns its exit code */
function runWithWebSocket(entry: URL, args: readonly string[]): number {
  const flags = [...process.execArgv, WEBSOCKET_FLAG, "--no-warnings"];
  const words = [...flags, fileURLToPath(entry), "conformance", ...args];
  return spawnSync(process.execPath, words, { stdio: "inherit" }).status ?? 1;
}

interface Arguments {
  address: string;
  /** as the report names it */
  robot: string;
  gateways: readonly GatewayName[];
}

/**
 * Error messages do not contain the arguments, because an address contains a key.
 * @throws InputError
 */
function readArguments(args: readonly string[]): Arguments {
  const { values, positionals } = parse(args);
  const [address = ""] = positionals;
  const parts = readAddress(address);
  if (positionals.length !== 1 || parts === null) {
    const { length } = positionals;
    const found = { 0: "nothing", 1: "another text" }[length] ?? `${length} arguments`;
    throw new InputError([
      `address: found ${found}, expected the address of a robot in quotes, "http://HOST/r/ID#KEY"`,
    ]);
  }
  const gateways = values.gateways === undefined ? [] : readGateways(values.gateways);
  return { address, robot: `${parts.origin}/r/${parts.id}`, gateways };
}

function parse(args: readonly string[]) {
  // The list may be omitted: then an option, the address or nothing follows.
  const words = args.map((word, index) => {
    const next = args[index + 1] ?? "--";
    const hasNoList = word === "--gateways" && (next.startsWith("--") || next.includes("/"));
    return hasNoList ? `--gateways=${gatewayNames.join(",")}` : word;
  });
  const options = { gateways: { type: "string" } } as const;
  try {
    return parseArgs({ args: words, options, allowPositionals: true, strict: true });
  } catch {
    throw new InputError(["Unknown option. The options are --gateways, --help."]);
  }
}

/** The gateways of a list, each once. @throws InputError */
function readGateways(list: string): GatewayName[] {
  const names = list.split(",");
  const known: readonly string[] = gatewayNames;
  if (!names.every((name) => known.includes(name))) {
    const expected = `a list of ${gatewayNames.join(", ")}, separated by commas`;
    throw new InputError([`--gateways: found another text, expected ${expected}`]);
  }
  return gatewayNames.filter((name) => names.includes(name));
}
