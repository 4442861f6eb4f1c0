/** Random steps of a store, for property tests. */
import type { Command, EndingState } from "@corridor/protocol";
import fc from "fast-check";
import { abandonStep, acquireStep } from "../../commands/page-transitions.ts";
import { changeBlockedStep, changeKeysStep } from "../../commands/permissions.ts";
import {
  addStep,
  cancelStep,
  deliverStep,
  endStep,
  expireStep,
  pauseStep,
  recalledStep,
  startStep,
} from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import type { RobotStore } from "../robot-store.ts";
import { DRIVERS, keyChange, NOW, pageState, ROBOTS, sent } from "./robot-in-store.ts";

const COMMANDS: Command[] = [{ action: "left 90" }, { action: "forward" }, { action: "stop" }];

export type Step = (store: RobotStore, robot: string) => Promise<unknown>;

export interface StepOfRobot {
  step: Step;
  robot: string;
}

const seqs = fc.integer({ min: 1, max: 12 });
const epochs = fc.integer({ min: 1, max: 3 });
const times = fc.integer({ min: NOW, max: NOW + 1_200 });
const drivers = fc.constantFrom(...DRIVERS);

const added = (...keep: number[]): fc.Arbitrary<Step> =>
  fc
    .record({
      driver: drivers,
      script: fc.constantFrom(null, "s", "t"),
      key: fc.option(fc.constantFrom("key-0001", "key-0002", "key-0003")),
      command: fc.constantFrom(...COMMANDS),
      replace: fc.boolean(),
      deadline: fc.integer({ min: NOW, max: NOW + 1_000 }),
      keep: fc.constantFrom(...keep),
      maxWaiting: fc.constantFrom(2, 64),
    })
    .map(
      (command): Step =>
        (store, robot) =>
          store.commit(robot, addStep({ ...sent, ...command })),
    );
const done = fc.oneof(
  fc.tuple(epochs, fc.constantFrom(1, 8), times).map(
    ([epoch, window, now]): Step =>
      (store, id) =>
        store.commit(id, deliverStep(epoch, window, now)),
  ),
  fc.tuple(epochs, seqs).map(
    ([epoch, seq]): Step =>
      (store, id) =>
        store.commit(id, startStep(epoch, seq)),
  ),
  fc.tuple(epochs, seqs, fc.constantFrom<EndingState>("completed", "collided", "expired")).map(
    ([epoch, seq, state]): Step =>
      (store, id) =>
        store.commit(id, endStep(epoch, { ...completed(seq), state })),
  ),
);
const rare = fc.oneof(
  times.map(
    (now): Step =>
      (store, id) =>
        store.commit(id, expireStep(now)),
  ),
  fc.tuple(seqs, drivers).map(
    ([seq, driver]): Step =>
      (store, id) =>
        store.commit(id, cancelStep(seq, driver)),
  ),
  epochs.map(
    (epoch): Step =>
      (store, id) =>
        store.commit(id, abandonStep(epoch)),
  ),
  fc
    .record({
      lastApplied: fc.oneof(
        { weight: 9, arbitrary: fc.integer({ min: 0, max: 12 }) },
        fc.constant(2 ** 48),
      ),
      fresh: fc.boolean(),
      knownEpoch: fc.option(fc.integer({ min: 0, max: 5 })),
      endings: fc.array(seqs.map(completed), { maxLength: 2 }),
    })
    .map(
      (page): Step =>
        (store, id) =>
          store.commit(id, acquireStep(pageState(page))),
    ),
  fc.boolean().map(
    (isPaused): Step =>
      (store, id) =>
        store.commit(id, pauseStep(isPaused)),
  ),
  drivers.map(
    (hash): Step =>
      (store, id) =>
        Promise.all([
          store.commit(id, changeKeysStep(keyChange({ remove: [hash] }))),
          store.commit(id, changeKeysStep(keyChange({ add: [{ kind: "drive", hash }] }))),
        ]),
  ),
  fc.constantFrom("s", "t").map(
    (script): Step =>
      (store, id) =>
        store.commit(
          id,
          changeBlockedStep({
            add: { id: script, driver: "d", name: null, client: "" },
            remove: script === "s" ? "t" : "s",
            most: 4,
          }),
        ),
  ),
);

/** @param keep numbers of newest commands to retain */
export const stepsKeeping = (...keep: number[]): fc.Arbitrary<Step> =>
  fc.oneof({ weight: 4, arbitrary: added(...keep) }, { weight: 6, arbitrary: done }, rare);

/** All commands of all robots, in each form in which they can be read. */
export async function contentsOf(store: RobotStore): Promise<unknown> {
  const all = [];
  for (const id of ROBOTS) {
    const listed = await store.commandsAfter(id, 0, 100);
    const each = [];
    for (const { seq } of listed) each.push(await store.command(id, seq));
    all.push({
      listed,
      each,
      open: await store.openCommands(id),
      back: await store.commit(id, recalledStep()),
    });
  }
  return all;
}
