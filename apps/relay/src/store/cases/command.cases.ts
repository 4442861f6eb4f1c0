/** Requirements for every store: commands from storage to delivery. */
import type { RemoteCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { abandonStep, acquireStep } from "../../commands/page-transitions.ts";
import { changeKeysStep } from "../../commands/permissions.ts";
import { addStep, deliverStep, endStep, startStep } from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import {
  because,
  ID,
  LEFT,
  STOP,
  NOW,
  EPOCH,
  sent,
  keyChange,
  nothingDone,
  type OpenStore,
  robotIn,
} from "./robot-in-store.ts";

export function commandCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: commands`, () => {
    it("numbers commands 1, 2, 3 and stores the whole request", async () => {
      const { add, store } = await withRobot();
      await add(LEFT);
      await add({ action: "drive", left: 0.2, right: -0.2, milliseconds: 602 }, "key-0001");
      expect(await store.command(ID, 2)).toEqual({
        seq: 2,
        key: "key-0001",
        action: "drive",
        command: { action: "drive", left: 0.2, right: -0.2, milliseconds: 602 },
        state: "accepted",
        reason: null,
        acceptedAt: "1970-01-01T00:00:05.000Z",
        pose: null,
        distance: null,
        duplicate: false,
      });
    });

    it("returns the first record to a retry, and rejects the key for another command", async () => {
      const { add, states } = await withRobot();
      await add(LEFT, "key-0001");
      expect(await add(LEFT, "key-0001")).toMatchObject({
        outcome: "duplicate",
        record: { seq: 1 },
      });
      expect(await add(STOP, "key-0001")).toMatchObject({ outcome: "conflict" });
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("stores the conditions of a guarded motion, which are part of its command", async () => {
      const { add, store, deliver } = await withRobot();
      const forward = (than: number): RemoteCommand => ({
        action: "forward",
        until: [{ sensor: "front", is: "<=", than }, { goal: true }],
      });
      await add(forward(60), "key-0001");
      expect(await store.command(ID, 1)).toMatchObject({ command: forward(60) });
      expect(await add(forward(60), "key-0001")).toMatchObject({ outcome: "duplicate" });
      expect(await add(forward(61), "key-0001")).toMatchObject({ outcome: "conflict" });
      expect(await add({ action: "forward" }, "key-0001")).toMatchObject({ outcome: "conflict" });
      const [delivered] = await store.commit(ID, deliverStep(EPOCH, 3, NOW));
      expect(delivered).toMatchObject({ record: { command: forward(60) } });
      await deliver(3);
    });

    it("shows the conditions of open commands and of the newest 200 ended ones", async () => {
      const { add, store, reopen } = await withRobot();
      const keep = 1_000;
      const until = [{ sensor: "front" as const, is: "<=" as const, than: 60 }];
      const next = (seq: number, command: RemoteCommand = { action: "forward", until }) =>
        add(command, `key-${String(seq).padStart(4, "0")}`, { keep });
      const end = async (seq: number) => {
        await store.commit(ID, deliverStep(EPOCH, 8, NOW));
        await store.commit(ID, endStep(EPOCH, completed(seq)));
      };
      // The first one never ends.
      await next(1);
      for (let seq = 2; seq <= 321; seq++) {
        await next(seq);
        await end(seq);
      }
      const shown = async (seq: number, from = store) =>
        (await from.command(ID, seq))?.command.until !== undefined;
      expect(await Promise.all([1, 121, 122, 321].map((seq) => shown(seq)))).toEqual([
        true,
        false,
        true,
        true,
      ]);
      const log = await store.commandsAfter(ID, 0, 1_000);
      expect(log.filter(({ command }) => command.until !== undefined)).toHaveLength(201);
      expect(log[100]).toMatchObject({ state: "completed", command: { action: "forward" } });
      // The key still belongs to the whole command.
      expect(await next(60)).toMatchObject({
        outcome: "duplicate",
        record: { seq: 60, command: { action: "forward" } },
      });
      const other = [{ sensor: "front" as const, is: "<=" as const, than: 61 }];
      expect(await next(60, { action: "forward", until: other })).toMatchObject({
        outcome: "conflict",
      });
      expect(await next(60, { action: "forward" })).toMatchObject({ outcome: "conflict" });
      const reopened = await reopen();
      expect(await shown(121, reopened)).toBe(false);
      expect(await shown(122, reopened)).toBe(true);
    });

    it("lets another driver use the same key", async () => {
      const { add, store } = await withRobot();
      await add(LEFT, "key-0001");
      await store.commit(ID, changeKeysStep(keyChange({ add: [{ kind: "drive", hash: "e" }] })));
      const other = { ...sent, driver: "e", key: "key-0001", command: STOP };
      expect(await store.commit(ID, addStep(other))).toMatchObject({ outcome: "stored" });
    });

    it("rejects a command above the limit without using its key, but never a stop", async () => {
      const { add, deliver } = await withRobot();
      const maxWaiting = 2;
      await add(LEFT, null, { maxWaiting });
      await add(LEFT, null, { maxWaiting });
      expect(await add(LEFT, "key-0001", { maxWaiting })).toEqual({ outcome: "full" });
      await deliver(1);
      expect(await add(LEFT, "key-0001", { maxWaiting })).toMatchObject({
        outcome: "stored",
        record: { seq: 3 },
      });
      expect(await add(STOP, null, { maxWaiting })).toMatchObject({ outcome: "stored" });
    });

    it("deletes old ended commands with their keys, and never an open one", async () => {
      const { add, store, states, deliver } = await withRobot();
      const keep = 2;
      await add(LEFT, "key-0001", { keep });
      await add(LEFT, "key-0002", { keep });
      await deliver(8);
      await store.commit(ID, endStep(EPOCH, completed(2)));
      await add(LEFT, "key-0003", { keep });
      expect(await states()).toEqual(["1 delivered", "2 completed", "3 accepted"]);
      await add(LEFT, "key-0004", { keep });
      expect(await states()).toEqual(["1 delivered", "3 accepted", "4 accepted"]);
      expect(await store.command(ID, 2)).toBeNull();
      expect(await add(LEFT, "key-0003", { keep })).toMatchObject({ outcome: "duplicate" });
      expect(await add(LEFT, "key-0002", { keep })).toMatchObject({
        outcome: "stored",
        record: { seq: 5 },
      });
      await store.commit(ID, endStep(EPOCH, completed(1)));
      await add(STOP, null, { keep });
      expect(await states()).toEqual(["5 cancelled", "6 accepted"]);
    });

    it("deletes only commands of the robot that received a new one", async () => {
      const { add, store, states, deliver } = await withRobot();
      await add(LEFT);
      await deliver(8);
      await store.commit(ID, endStep(EPOCH, completed(1)));
      const other = "BBBBBBBBBBBBBBBBBBBBBB";
      const keys = [{ kind: "drive" as const, hash: sent.driver }];
      await store.create({ id: other, createdAt: 1_000, keys });
      for (let n = 0; n < 3; n++) await store.commit(other, addStep({ ...sent, keep: 1 }));
      expect(await states()).toEqual(["1 completed"]);
    });

    it("stores nothing for an unknown robot", async () => {
      const { store } = await open();
      expect(await store.commit(ID, addStep(sent))).toEqual({ outcome: "no-robot" });
      expect(await store.commit(ID, acquireStep(nothingDone))).toBeNull();
    });

    it("delivers in order, at most a window", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      const first = await store.commit(ID, deliverStep(EPOCH, 3, NOW));
      expect(first.map(({ record }) => [record.seq, record.state])).toEqual([
        [1, "delivered"],
        [2, "delivered"],
        [3, "delivered"],
      ]);
      expect(await deliver(3)).toEqual([]);
      await store.commit(ID, startStep(EPOCH, 1));
      expect(await deliver(3)).toEqual([4]);
      expect(await states()).toEqual(["1 started", "2 delivered", "3 delivered", "4 delivered"]);
    });

    it("lets a stop overtake: cancels waiting commands, and leaves delivered ones for the robot to end", async () => {
      const { add, states, deliver } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      const stop = await add(STOP);
      expect(stop).toMatchObject({
        ended: [{ record: { seq: 3, reason: "Command 4 stopped this command." } }],
      });
      expect(await deliver(2)).toEqual([4]);
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 cancelled", "4 delivered"]);
    });

    it("never changes the first ending", async () => {
      const { add, store, deliver } = await withRobot();
      await add(LEFT);
      expect(await store.commit(ID, endStep(EPOCH, completed(1)))).toMatchObject({
        outcome: "over",
        record: { state: "accepted" },
      });
      await deliver(8);
      expect(await store.commit(ID, startStep(EPOCH, 1))).toMatchObject({ state: "started" });
      expect(await store.commit(ID, startStep(EPOCH, 1))).toBeNull();
      expect(await store.commit(ID, endStep(EPOCH, completed(1)))).toMatchObject({
        outcome: "ended",
        record: { state: "completed", distance: 100 },
      });
      expect(
        await store.commit(ID, endStep(EPOCH, { ...completed(1), state: "collided" })),
      ).toMatchObject({
        outcome: "over",
        record: { state: "completed" },
      });
      expect(await store.commit(ID, endStep(EPOCH, completed(9)))).toEqual({
        outcome: "over",
        record: null,
      });
      expect(await store.commit(ID, abandonStep(EPOCH))).toEqual([]);
      expect(await store.command(ID, 1)).toMatchObject({ state: "completed", pose: { x: 250 } });
    });

    it("ends running commands of a lost page, leaves waiting ones, and ignores that page's later reports", async () => {
      const { add, store, deliver, states } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      await store.commit(ID, startStep(EPOCH, 1));
      await store.commit(ID, abandonStep(EPOCH));
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 accepted"]);
      expect(await store.commit(ID, endStep(EPOCH, completed(1)))).toMatchObject({
        outcome: "over",
        record: { state: "cancelled", reason: because("disconnected") },
      });
      expect(await deliver(8)).toEqual([]);
      expect((await store.commit(ID, acquireStep(nothingDone)))?.epoch).toBe(EPOCH + 2);
    });
  });
}
