/** A robot in an empty store, and helpers for the test cases of stores. */
import { acquireStep } from "../../commands/page-transitions.ts";
import { addStep, deliverStep } from "../../commands/state-machine.ts";
import { reasonText, type Cause } from "../../commands/reasons.ts";
import type { Command, RemoteCommand } from "@corridor/protocol";
import type { KeyChange, NewCommand, PageState } from "../../commands/robot-step.ts";
import type { RobotStore } from "../robot-store.ts";

export const ID = "AAAAAAAAAAAAAAAAAAAAAA";
export const LEFT: Command = { action: "left 90" };
export const STOP: Command = { action: "stop" };
export const NOW = 5_000;
/** epoch of the first page of each robot */
export const EPOCH = 1;
export const sent: NewCommand = {
  driver: "driver-hash-of-this-robot",
  script: null,
  key: null,
  command: LEFT,
  acceptedAt: NOW,
  ttl: 10_000,
  deadline: NOW + 10_000,
  replace: false,
  lease: null,
  resetFrom: 0,
  maxWaiting: 64,
  keep: 100,
};
export const keyChange = (change: Partial<KeyChange>): KeyChange => ({
  add: [],
  remove: [],
  removeKind: null,
  most: 12,
  now: NOW,
  ...change,
});
/** The reason in the record of a command that the relay has ended. */
export function because(cause: Cause): string {
  return reasonText({ cause, by: null }, sent.ttl);
}
/**
 * The report of a new page. The previous page has reported everything that it started, whatever its
 * epoch.
 */
export const pageState = (state: Partial<PageState> = {}): PageState => ({
  lastApplied: 0,
  fresh: false,
  endings: [],
  pose: null,
  knownEpoch: Number.MAX_SAFE_INTEGER,
  left: "reloaded",
  ...state,
});
export const nothingDone = pageState();

export interface OpenStore {
  store: RobotStore;
  /** The same data in a new store, as after a restart. Closes the previous store. */
  reopen: () => Promise<RobotStore>;
  /** Whether the text is still in the files on disk. */
  holds: (text: string) => Promise<boolean>;
}

/** A robot with an owning page, in a store of its own. */
export async function robotIn(open: () => Promise<OpenStore>) {
  const opened = await open();
  const { store } = opened;
  const keys = [{ kind: "drive" as const, hash: "driver-hash-of-this-robot" }];
  await store.create({ id: ID, createdAt: 1_000, keys });
  await store.commit(ID, acquireStep(nothingDone));
  const add = (
    command: RemoteCommand,
    key: string | null = null,
    change: Partial<NewCommand> = {},
  ) => store.commit(ID, addStep({ ...sent, command, key, ...change }));
  const deliver = async (window: number, epoch = EPOCH): Promise<number[]> =>
    (await store.commit(ID, deliverStep(epoch, window, NOW))).map(({ record }) => record.seq);
  const states = async (): Promise<string[]> =>
    (await store.commandsAfter(ID, 0, 100)).map(({ seq, state }) => `${seq} ${state}`);
  return { ...opened, add, deliver, states };
}

/** Robots in an empty store, each with a page and these drivers. */
export const ROBOTS = ["A".repeat(22), "B".repeat(22), "C".repeat(22)];
export const DRIVERS = ["d", "e"];

export async function withRobots(store: RobotStore): Promise<void> {
  const keys = DRIVERS.map((hash) => ({ kind: "drive" as const, hash }));
  for (const id of ROBOTS) {
    await store.create({ id, createdAt: 1, keys });
    await store.commit(id, acquireStep(pageState()));
  }
}
