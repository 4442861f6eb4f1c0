/** Runs every check in order, each on a robot that stands, and gives what came out. */
import { access } from "./checks/access.ts";
import { badInput } from "./checks/bad-input.ts";
import { life } from "./checks/life.ts";
import { reading } from "./checks/reading.ts";
import { retries } from "./checks/retries.ts";
import { stops } from "./checks/stops.ts";
import type { CheckGroup } from "./check.ts";
import { Host } from "./host.ts";
import { Mismatch, NotSeen } from "./mismatch.ts";

export const groups: readonly CheckGroup[] = [access, life, retries, stops, reading, badInput];

export type Outcome =
  | { kind: "passed" }
  /** the robot cannot show it; no fault */
  | { kind: "not seen"; why: string }
  | { kind: "failed"; expected: string; found: string };

export interface Result {
  group: string;
  check: string;
  outcome: Outcome;
}

/**
 * @param address of the robot, which will move
 * @param told hears each result as it comes
 */
export async function runChecks(
  address: string,
  told: (result: Result) => void = () => undefined,
): Promise<Result[]> {
  const host = new Host(address);
  const results: Result[] = [];
  for (const { title, checks } of groups) {
    for (const { name, run } of checks) {
      const outcome = await outcomeOf(async () => run(host));
      const result = { group: title, check: name, outcome };
      results.push(result);
      told(result);
      // Whatever a failed check has left running must not spoil the next one.
      if (outcome.kind === "failed") await outcomeOf(async () => host.done({ action: "stop" }));
    }
  }
  return results;
}

async function outcomeOf(run: () => Promise<unknown>): Promise<Outcome> {
  try {
    await run();
    return { kind: "passed" };
  } catch (error) {
    if (error instanceof NotSeen) return { kind: "not seen", why: error.message };
    if (error instanceof Mismatch) {
      return { kind: "failed", expected: error.expected, found: error.found };
    }
    return { kind: "failed", expected: "an answer", found: said(error) };
  }
}

function said(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const cause = error.cause instanceof Error ? ` (${error.cause.message})` : "";
  return `${error.message}${cause}`;
}
