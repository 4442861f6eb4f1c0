/**
 * Runs of the kit against the physical robot example in the pen, unchanged or with injected faults.
 * Each run has a robot of its own and one section: a few checks in a row.
 */
import type { CheckGroup } from "../../../packages/conformance/src/check.ts";
import { connections } from "../../../packages/conformance/src/checks/connections.ts";
import { limits } from "../../../packages/conformance/src/checks/limits.ts";
import { Host } from "../../../packages/conformance/src/host.ts";
import { passes } from "../../../packages/conformance/src/report.ts";
import { groups, runChecks, type Result } from "../../../packages/conformance/src/run-checks.ts";
import type { InjectedFault } from "./injected-fault.ts";
import { injectedFaults } from "./injected-faults.ts";
import { PEN, startPhysicalRobot, type RunningRobot } from "./physical-robot.ts";
import { editedFiles, type EditedFiles } from "./source-edits.ts";
import { startBridge } from "./websocket-bridge.ts";

/** Maximum number of checks in a section. */
const SECTION = 6;
/** Maximum number of faults in one copy of the example. */
const BATCH = 30;
/**
 * Number of commands before a section, as if earlier sections had run. The limits need the log of a
 * whole run.
 */
const EARLIER_COMMANDS = { limits: 120, others: 1 };

/** All checks in their order, in sections. The checks of limits need the commands before them. */
export const sections: readonly CheckGroup[] = groups.flatMap((group) =>
  group === limits ? [group] : sectionsOf(group),
);

/** The checks that only a host with a WebSocket passes. The bridge affects no other check. */
export const webSocketSection: CheckGroup = {
  title: "WebSocket",
  checks: connections.checks.filter(({ needs }) => needs?.includes("websocket")),
};

function sectionsOf({ title, checks }: CheckGroup): CheckGroup[] {
  return Array.from({ length: Math.ceil(checks.length / SECTION) }, (_, n) => ({
    title: `${title} ${n + 1}`,
    checks: checks.slice(n * SECTION, (n + 1) * SECTION),
  }));
}

const running = new Set<RunningRobot>();

export function stopRobots(): void {
  for (const robot of running) robot.stop();
}

interface SectionRun {
  section: CheckGroup;
  isTracked?: boolean;
  faults?: readonly InjectedFault[];
  /** the last check to run; default: all */
  lastPromise?: string;
}

/** Runs a section until a check fails. */
export async function runSection(run: SectionRun): Promise<Result[]> {
  const { section, isTracked = true, faults = [], lastPromise } = run;
  const edits = faults.flatMap((fault) => fault.edits);
  const robot = await startPhysicalRobot({ room: PEN, speedup: 8, isTracked, edits });
  running.add(robot);
  const hasBridge = section === webSocketSection;
  const bridge = hasBridge ? await startBridge(robot.address, faults[0]?.bridge) : null;
  try {
    await sendStops(robot.address, EARLIER_COMMANDS[section === limits ? "limits" : "others"]);
    const last = section.checks.findIndex(({ promise }) => promise === lastPromise);
    const checks = last < 0 ? section.checks : section.checks.slice(0, last + 1);
    const { address } = bridge ?? robot;
    return await runChecks(address, { groups: [{ ...section, checks }], stopsAtFailure: true });
  } finally {
    bridge?.stop();
    robot.stop();
    running.delete(robot);
  }
}

async function sendStops(address: string, count: number): Promise<void> {
  const host = new Host(address);
  for (let n = 0; n < count; n++) await host.sendAndWait({ action: "stop" });
}

/** Runs the section that must catch the fault, up to the check that must fail. */
export async function firstFailure(fault: InjectedFault): Promise<Result | undefined> {
  const lastPromise = fault.caughtBy;
  const results = await runSection({ section: sectionOf(fault), faults: [fault], lastPromise });
  return results.find(({ outcome }) => outcome.kind === "failed");
}

export interface EarlyFailure {
  fault: string;
  result: Result;
}

/**
 * Runs a section against a robot with several faults that only later sections must catch.
 * If a check fails, the faults are divided until the fault that causes it is found.
 */
export async function earlyFailures(
  section: CheckGroup,
  faults: readonly InjectedFault[],
): Promise<EarlyFailure[]> {
  const results = await runSection({ section, faults });
  const result = results.find((each) => !passes([each]));
  const [first, second] = faults;
  if (result === undefined || first === undefined) return [];
  if (second === undefined) return [{ fault: first.fault, result }];
  const half = Math.ceil(faults.length / 2);
  return [
    ...(await earlyFailures(section, faults.slice(0, half))),
    ...(await earlyFailures(section, faults.slice(half))),
  ];
}

interface Batch {
  faults: InjectedFault[];
  files: EditedFiles;
}

/** The faults that later sections must catch, in batches with compatible edits. */
export function batchesOfLaterFaults(section: CheckGroup): InjectedFault[][] {
  const position = sections.indexOf(section);
  const later = injectedFaults.filter(
    (fault) => fault.bridge === undefined && sections.indexOf(sectionOf(fault)) > position,
  );
  const count = Math.ceil(later.length / BATCH);
  const newBatch = (): Batch => ({ faults: [], files: new Map() });
  const batches = Array.from({ length: count }, newBatch);
  for (const [index, fault] of later.entries()) {
    // Faults of one check are neighbours, and go into different batches.
    const from = index % count;
    const inOrder = [...batches.slice(from), ...batches.slice(0, from)];
    if (!inOrder.some((batch) => adds(batch, fault))) {
      const batch = newBatch();
      adds(batch, fault);
      batches.push(batch);
    }
  }
  return batches.map(({ faults }) => faults);
}

/** Adds a fault unless its edits conflict with those of the batch. */
function adds(batch: Batch, fault: InjectedFault): boolean {
  try {
    batch.files = editedFiles(fault.edits, batch.files);
  } catch {
    return false;
  }
  batch.faults.push(fault);
  return true;
}

export function sectionOf({ bridge, caughtBy }: InjectedFault): CheckGroup {
  if (bridge !== undefined) return webSocketSection;
  const section = sections.find(({ checks }) => checks.some((each) => each.promise === caughtBy));
  if (section === undefined) throw new Error(`There is no check of the promise ${caughtBy}.`);
  return section;
}
