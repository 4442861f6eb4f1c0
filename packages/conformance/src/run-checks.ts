/** Runs every check in order. Each check starts with a robot that stands. */
import type { HostFeature, GatewayName } from "@corridor/protocol";
import { access } from "./checks/access.ts";
import { invalidInput } from "./checks/invalid-input.ts";
import { connections } from "./checks/connections.ts";
import { directions } from "./checks/directions.ts";
import { events } from "./checks/events.ts";
import { guardedMotion } from "./checks/guarded-motion.ts";
import { leases } from "./checks/leases.ts";
import { life } from "./checks/life-cycle.ts";
import { limits } from "./checks/limits.ts";
import { pose } from "./checks/pose.ts";
import { reading } from "./checks/reading.ts";
import { reset } from "./checks/reset.ts";
import { retries } from "./checks/retries.ts";
import { stops } from "./checks/stops.ts";
import { mcp } from "./checks/gateways/mcp.ts";
import { ros } from "./checks/gateways/ros.ts";
import { soap } from "./checks/gateways/soap.ts";
import type { Check, CheckGroup } from "./check.ts";
import { Host } from "./host.ts";
import { describeError, Mismatch, NeverTestable, NoAccess, NotTestable } from "./mismatch.ts";

/** Units and directions come first, while the robot is at its initial position. */
export const groups: readonly CheckGroup[] = [
  access,
  directions,
  pose,
  stops,
  retries,
  events,
  life,
  reading,
  invalidInput,
  leases,
  guardedMotion,
  reset,
  limits,
  connections,
];

/** Checks of the gateways that a host may offer. */
export const gatewayGroups: Readonly<Record<GatewayName, CheckGroup>> = { ros, mcp, soap };

export type Outcome =
  | { kind: "passed" }
  /** `isLast`: no other check can be tested, so the run ends */
  | { kind: "failed"; expected: string; found: string; isLast?: boolean }
  /** the host reports that it does not offer the feature, which is not a failure */
  | { kind: "not offered"; feature: HostFeature | GatewayName; why: string }
  /** not tested; `isNever`: no run can test it, so that it does not count against the host */
  | { kind: "not testable"; why: string; isNever: boolean };

export interface Result {
  group: string;
  promise: string;
  check: string;
  outcome: Outcome;
}

export interface RunOptions {
  /** receives each result as soon as it is available */
  onResult?: (result: Result) => void;
  /** default: all */
  groups?: readonly CheckGroup[];
  /** ends the run at the first failed check */
  stopsAtFailure?: boolean;
}

/** @param address of the robot, which moves during the run */
export async function runChecks(address: string, options: RunOptions = {}): Promise<Result[]> {
  const host = new Host(address);
  const missing = await missingFeatures(host);
  const results: Result[] = [];
  const add = (result: Result): void => {
    results.push(result);
    options.onResult?.(result);
  };
  for (const { title, checks, gateway } of options.groups ?? groups) {
    if (gateway !== undefined && (await isDisabled(host, gateway))) {
      const why = "The operator of the host has switched this gateway off.";
      const outcome: Outcome = { kind: "not offered", feature: gateway, why };
      for (const { promise, name } of checks) add({ group: title, promise, check: name, outcome });
      continue;
    }
    const early = new Map<Check, Promise<Outcome>>();
    for (const check of checks) {
      if (check.onlyListens === true) early.set(check, outcomeOf(check, host, missing));
    }
    for (const check of checks) {
      const outcome = await (early.get(check) ?? outcomeOf(check, host, missing));
      add({ group: title, promise: check.promise, check: check.name, outcome });
      if (outcome.kind !== "failed") continue;
      if (options.stopsAtFailure === true || outcome.isLast === true) return results;
      // Commands of a failed check must not affect the next one.
      await host.sendAndWait({ action: "stop" }).catch(() => undefined);
    }
  }
  return results;
}

/**
 * The features that the host does not offer. An invalid list counts as empty; a check reports it.
 */
async function missingFeatures(host: Host): Promise<ReadonlyMap<HostFeature, string>> {
  try {
    const { notOffered } = await host.features();
    return new Map(notOffered.map(({ feature, reason }) => [feature, reason]));
  } catch {
    return new Map();
  }
}

/** A gateway without this answer, or without any, must pass its checks. */
async function isDisabled(host: Host, gateway: GatewayName): Promise<boolean> {
  try {
    const { status, text } = await host.requestUrl(host.gatewayUrl(gateway));
    return status === 404 && text.includes("/problems/gateway-disabled");
  } catch {
    return false;
  }
}

async function outcomeOf(
  check: Check,
  host: Host,
  missing: ReadonlyMap<HostFeature, string>,
): Promise<Outcome> {
  for (const feature of check.needs ?? []) {
    const why = missing.get(feature);
    if (why !== undefined) return { kind: "not offered", feature, why };
  }
  try {
    await check.run(host);
    return { kind: "passed" };
  } catch (error) {
    if (error instanceof NotTestable || error instanceof NeverTestable) {
      const isNever = error instanceof NeverTestable;
      return { kind: "not testable", why: error.message, isNever };
    }
    if (error instanceof Mismatch) {
      const { expected, found } = error;
      return {
        kind: "failed",
        expected,
        found,
        ...(error instanceof NoAccess && { isLast: true }),
      };
    }
    return { kind: "failed", expected: "a response", found: describeError(error) };
  }
}
