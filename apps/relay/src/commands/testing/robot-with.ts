/** A robot in memory, for tests of the state machine. */
import type { CommandState, Ending } from "@corridor/protocol";
import {
  commandIn,
  type CommandRow,
  overtakingOf,
  RobotCommands,
  type OnChange,
} from "../robot-commands.ts";
import type { NewCommand, PageState } from "../robot-step.ts";

export const NOW = 5_000;
export const EPOCH = 1;
export const DRIVER = "driver-hash";
export const LEFT = '{"action":"left 90"}';
export const STOP = '{"action":"stop"}';

export function rowOf(change: Partial<CommandRow> = {}): CommandRow {
  const { text = LEFT, replace = false } = change;
  const known = commandIn(text);
  return {
    seq: 1,
    driver: DRIVER,
    script: null,
    key: null,
    ...known,
    acceptedAt: NOW,
    ttl: 10_000,
    deadline: NOW + 10_000,
    replace,
    lease: null,
    overtakes: overtakingOf(known.command, replace),
    state: "accepted",
    reason: null,
    recalled: null,
    pose: null,
    distance: null,
    epoch: EPOCH,
    ...change,
  };
}

/** @param rows commands in any state, in order */
export function robotWith(
  rows: readonly CommandRow[],
  onChange: OnChange = () => undefined,
): RobotCommands {
  const admissionState = {
    epoch: EPOCH,
    lastSeq: 0,
    isPaused: false,
    mayReset: true,
    keys: new Set([DRIVER]),
    blocked: new Set<string>(),
  };
  const robot = new RobotCommands(admissionState, [], onChange);
  for (const row of rows) robot.restore(row);
  return robot;
}

export function newCommand(change: Partial<NewCommand> = {}): NewCommand {
  return {
    driver: DRIVER,
    script: null,
    key: null,
    command: { action: "left 90" },
    acceptedAt: NOW,
    ttl: 10_000,
    deadline: NOW + 10_000,
    replace: false,
    lease: null,
    resetFrom: 0,
    maxWaiting: 64,
    keep: 100,
    ...change,
  };
}

/** The report of a page that knows what the page before it has started. */
export function pageWith(change: Partial<PageState> = {}): PageState {
  return {
    lastApplied: 0,
    fresh: false,
    endings: [],
    pose: null,
    knownEpoch: Number.MAX_SAFE_INTEGER,
    left: "reloaded",
    ...change,
  };
}

export function endingOf(seq: number, state: Ending["state"] = "completed"): Ending {
  return { seq, state, reason: null, pose: { x: 250, y: 150, heading: 90 }, distance: 100 };
}

export function statesOf(robot: RobotCommands): [seq: number, state: CommandState][] {
  return robot.rows().map(({ seq, state }) => [seq, state]);
}
