/**
 * Checks the last argument of a command. TypeScript rejects anything but options; JavaScript would
 * ignore it, and `forward(100)` would drive without end.
 */
import { ClientError } from "./client-error.ts";

interface Usage {
  /** what the command does not take */
  none: string;
  /** the call that is meant by a number */
  instead: (given: number) => string;
}

const usages = {
  forward: { none: "distance", instead: (given) => `move(${given})` },
  reverse: { none: "distance", instead: (given) => `move(${-given})` },
  left90: { none: "angle", instead: (given) => `turn(${-given})` },
  right90: { none: "angle", instead: (given) => `turn(${given})` },
  turn180: { none: "angle", instead: (given) => `turn(${given})` },
  delayedLeft90: { none: "number", instead: () => "delayedLeft90()" },
  delayedRight90: { none: "number", instead: () => "delayedRight90()" },
  stop: { none: "number", instead: () => "stop()" },
  reset: { none: "number", instead: () => "reset()" },
  move: { none: "second number", instead: () => "move(100)" },
  turn: { none: "second number", instead: () => "turn(90)" },
  drive: { none: "fourth number", instead: () => "drive(0.5, 0.5, 1000)" },
} as const satisfies Record<string, Usage>;

/** A method of `RobotClient` that sends a command. */
export type CommandName = keyof typeof usages;

/** The error for a last argument that is not an object; null if there is none. */
export function wrongOptions(name: CommandName, options: unknown): ClientError | null {
  if (typeof options === "object" && options !== null) return null;
  const { none, instead }: Usage = usages[name];
  if (typeof options === "number") {
    return new ClientError("bad-command", `${name}() takes no ${none}`, `Use ${instead(options)}.`);
  }
  const found = options === null ? "null" : `a ${typeof options}`;
  const what = `${name}() does not accept ${found} as options`;
  return new ClientError("bad-command", what, "Pass an object, such as { ttl: 2000 }, or nothing.");
}
