/** What stores rely on: each step declares what it changes, and whether a full disk may refuse it. */
import { hasEnded } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { abandonStep, acquireStep, newestOvertaking } from "./page-transitions.ts";
import { changeBlockedStep, changeKeysStep } from "./permissions.ts";
import type { RobotCommands } from "./robot-commands.ts";
import type { RobotState, RobotStep, KeyChange } from "./robot-step.ts";
import {
  addStep,
  cancelStep,
  deliverStep,
  endStep,
  expireStep,
  pauseStep,
  recalledStep,
  startStep,
} from "./state-machine.ts";
import {
  DRIVER,
  endingOf,
  EPOCH,
  newCommand,
  NOW,
  pageWith,
  robotWith,
  rowOf,
} from "./testing/robot-with.ts";

const SCRIPT = { id: "s", driver: DRIVER, name: "a", client: "Python" };
const keyChange = (change: Partial<KeyChange>): KeyChange => ({
  add: [],
  remove: [],
  removeKind: null,
  most: 2,
  now: NOW,
  ...change,
});

/** A robot with a waiting, a delivered and a started command, and what a step changes of it. */
function robot({ isHeldElsewhere = false } = {}) {
  const commands = robotWith([
    rowOf({ seq: 1, state: "started", script: "s" }),
    rowOf({ seq: 2, state: "delivered", script: "s" }),
    rowOf({ seq: 3, script: "s" }),
  ]);
  const changed: string[] = [];
  const state: RobotState = {
    commands,
    permissions: { keys: [{ kind: "drive", hash: DRIVER }], blocked: [{ ...SCRIPT, id: "t" }] },
    isHeldElsewhere,
    row: (seq) => commands.row(seq),
    withKey: (driver, key) => commands.withKey(driver, key),
    newest: (what, after) => newestOvertaking(commands.rows(), what, after),
    ended: ({ after, upTo }) =>
      commands.rows().filter(({ seq, state: now }) => seq > after && seq <= upTo && hasEnded(now)),
    setKeys: ({ keys, revoked }) =>
      void changed.push(`keys ${keys.length}, revoked ${revoked.length}`),
    setBlocked: (blocked) => void changed.push(`blocked ${blocked.map(({ id }) => id).join()}`),
    setPage: (name) => void changed.push(`page ${name}`),
  };
  const before = { ...commands.admissionState };
  /** Applies a step. @returns what it has changed besides commands */
  const apply = (step: RobotStep<unknown>): string[] => {
    step.apply(state);
    const { epoch, isPaused } = commands.admissionState;
    if (epoch !== before.epoch) changed.push(`epoch ${epoch}`);
    if (isPaused !== before.isPaused) changed.push(isPaused ? "paused" : "resumed");
    return changed;
  };
  return { commands, apply };
}

const key = { driver: DRIVER, key: "key-0001" };

const steps: {
  name: string;
  step: RobotStep<unknown>;
  /** what it changes besides commands */
  changes?: string[];
  needsSpace?: boolean;
  lookup?: unknown;
}[] = [
  { name: "stores a command", step: addStep(newCommand(key)), needsSpace: true, lookup: { key } },
  { name: "stores a command without a key", step: addStep(newCommand()), needsSpace: true },
  { name: "stops", step: addStep(newCommand({ command: { action: "stop" } })) },
  { name: "delivers", step: deliverStep(EPOCH, 8, NOW) },
  { name: "expires", step: expireStep(NOW + 20_000) },
  { name: "cancels", step: cancelStep(3, DRIVER), lookup: { seqs: [3] } },
  { name: "starts", step: startStep(EPOCH, 2) },
  { name: "ends", step: endStep(EPOCH, endingOf(2)), lookup: { seqs: [2] } },
  { name: "lists recalled commands", step: recalledStep() },
  { name: "pauses", step: pauseStep(true), changes: ["paused"] },
  { name: "resumes", step: pauseStep(false) },
  {
    name: "creates a key",
    step: changeKeysStep(keyChange({ add: [{ kind: "watch", hash: "w" }] })),
    changes: ["keys 2, revoked 0"],
    needsSpace: true,
  },
  {
    name: "revokes a key, whose scripts are blocked no longer",
    step: changeKeysStep(keyChange({ remove: [DRIVER] })),
    changes: ["keys 0, revoked 1", "blocked "],
  },
  {
    name: "creates too many keys",
    step: changeKeysStep(keyChange({ add: [{ kind: "watch", hash: "w" }], most: 1 })),
    needsSpace: true,
  },
  {
    name: "blocks a script",
    step: changeBlockedStep({ add: SCRIPT, remove: null, most: 2 }),
    changes: ["blocked t,s"],
  },
  { name: "blocks too many", step: changeBlockedStep({ add: SCRIPT, remove: null, most: 1 }) },
  {
    name: "gives up a page",
    step: abandonStep(EPOCH),
    changes: ["epoch 2"],
    lookup: { holder: true },
  },
  { name: "gives up an earlier page", step: abandonStep(EPOCH - 1), lookup: { holder: false } },
  {
    name: "makes a page the owner",
    step: acquireStep(pageWith({ page: "p", endings: [endingOf(2)], lastApplied: 2 })),
    changes: ["page p", "epoch 2"],
    lookup: { seqs: [2], after: 2 },
  },
];

describe("a step that", () => {
  it.each(steps)(
    "$name declares its effect",
    ({ step, changes = [], needsSpace = false, lookup }) => {
      const { commands, apply } = robot();
      const found = Object.entries(step.lookup?.(commands) ?? {}).filter(
        ([, what]) => what !== null,
      );
      expect(Object.fromEntries(found)).toEqual(lookup ?? {});
      expect(apply(step)).toEqual(changes);
      expect(changes.length === 0 || step.changesRobot === true).toBe(true);
      expect(step.needsSpace ?? false).toBe(needsSpace);
    },
  );
});

it("ends nothing of a page that is connected to another running relay", () => {
  const { commands, apply } = robot({ isHeldElsewhere: true });
  const states = (of: RobotCommands) => of.rows().map(({ state }) => state);
  expect(apply(abandonStep(EPOCH))).toEqual([]);
  expect(states(commands)).toEqual(["started", "delivered", "accepted"]);
});

it("looks up no later commands for a page if no command waits", () => {
  const commands = robotWith([rowOf({ seq: 1, state: "started" })]);
  expect(acquireStep(pageWith()).lookup?.(commands)).toEqual({ seqs: [], after: null });
});
