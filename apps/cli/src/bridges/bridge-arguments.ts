/** Arguments of bridges: the address of the robot, and where to listen. */
import { parseArgs, type ParseArgsConfig } from "node:util";
import { ClientError } from "@corridor/client";
import { parseRobotAddress } from "@corridor/client/bridge";
import { InputError } from "../input-error.ts";

/** Variable that contains the address, so that the key is in no list of processes. */
const VARIABLE = "CORRIDOR_ROBOT";
const EXPECTED = `the address of a robot in quotes, "http://HOST/r/ID#KEY", or the variable ${VARIABLE}`;

type Options = NonNullable<ParseArgsConfig["options"]>;

/**
 * Parses the arguments of a bridge. Errors do not contain the address, because it contains a key.
 * @returns the robot's address, and the values of the options
 * @throws InputError
 */
export function bridgeArguments<O extends Options>(
  args: readonly string[],
  options: O,
  environment: Readonly<Record<string, string | undefined>> = process.env,
) {
  const { values, positionals } = parse(args, options);
  if (positionals.length > 1) {
    throw new InputError([`address: found ${positionals.length} arguments, expected ${EXPECTED}`]);
  }
  const address = positionals[0] ?? environment[VARIABLE];
  if (address === undefined) {
    throw new InputError([`address: found nothing, expected ${EXPECTED}`]);
  }
  try {
    parseRobotAddress(address);
  } catch (error) {
    if (!(error instanceof ClientError)) throw error;
    throw new InputError([`address: expected ${EXPECTED}. ${error.hint}`]);
  }
  return { address, values };
}

function parse<O extends Options>(args: readonly string[], options: O) {
  try {
    return parseArgs({ args: [...args], options, allowPositionals: true, strict: true });
  } catch (error) {
    const found = error instanceof Error ? error.message : "Invalid options";
    const names = [...Object.keys(options), "help"].map((name) => `--${name}`);
    throw new InputError([`${found.replace(/\.?$/, ".")} The options are ${names.join(", ")}.`]);
  }
}

/** Where a bridge listens. */
export interface ListenAddress {
  host: string;
  /** 0: any free port */
  port: number;
}

/** Options of bridges that listen, for `bridgeArguments`. */
export const listenOptions = {
  host: { type: "string", default: "127.0.0.1" },
  port: { type: "string" },
} as const;

/** Lines of the help text for `listenOptions`. */
export function listenHelp(defaultPort: number): string {
  return `  --port PORT  port to listen on; default: ${defaultPort}
  --host HOST  address to listen on; default: 127.0.0.1, for programs on this computer only. With
               0.0.0.0, everyone in the network can drive the robot`;
}

/** @throws InputError */
export function readListenAddress(
  { host, port }: { host: string; port?: string | undefined },
  defaultPort: number,
  option = "--port",
): ListenAddress {
  const number = Number(port ?? defaultPort);
  if (port?.trim() === "" || !Number.isInteger(number) || number < 0 || number > 65_535) {
    throw new InputError([
      `${option}: found ${JSON.stringify(port)}, expected a number from 0 to 65535; 0: any free port`,
    ]);
  }
  return { host, port: number };
}
