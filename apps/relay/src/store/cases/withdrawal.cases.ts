/** Requirements for every store: commands that replace others or are cancelled. */
import { describe, expect, it } from "vitest";
import { acquireStep } from "../../commands/page-transitions.ts";
import {
  cancelStep,
  deliverStep,
  endStep,
  expireStep,
  recalledStep,
} from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import {
  because,
  ID,
  LEFT,
  STOP,
  NOW,
  EPOCH,
  sent,
  type OpenStore,
  pageState,
  robotIn,
} from "./robot-in-store.ts";

export function withdrawalCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: replacing and cancelling`, () => {
    it("supersedes accepted commands, and delivers the replacing one even if the window is full", async () => {
      const { add, deliver, states, store } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(2);
      expect(await add(LEFT, null, { replace: true, maxWaiting: 1 })).toMatchObject({
        outcome: "stored",
        ended: [
          { record: { seq: 3, state: "superseded", reason: "Command 4 replaced this command." } },
        ],
      });
      expect(await store.commit(ID, deliverStep(EPOCH, 2, NOW))).toMatchObject([
        { record: { seq: 4 }, replace: true },
      ]);
      expect(await states()).toEqual(["1 delivered", "2 delivered", "3 superseded", "4 delivered"]);
    });

    it("supersedes or cancels an overtaken command that was delivered and never arrived", async () => {
      const { add, deliver, states, store } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(8);
      await add(LEFT, null, { replace: true });
      await add(LEFT);
      await store.commit(ID, acquireStep(pageState({ lastApplied: 1, fresh: false, endings: [] })));
      expect(await states()).toEqual([
        "1 started",
        "2 superseded",
        "3 superseded",
        "4 accepted",
        "5 accepted",
      ]);
      await deliver(8, EPOCH + 1);
      await add(STOP);
      await store.commit(ID, expireStep(NOW + 60_000));
      await store.commit(ID, acquireStep(pageState({ lastApplied: 1, fresh: false, endings: [] })));
      expect((await states()).slice(3)).toEqual(["4 cancelled", "5 cancelled", "6 expired"]);
    });

    it("withdraws waiting commands for their sender only, and leaves delivered ones to the robot", async () => {
      const { add, deliver, store } = await withRobot();
      const by = sent.driver;
      await add(LEFT);
      await deliver(8);
      await add(LEFT);
      expect(await store.commit(ID, cancelStep(2, "e"))).toEqual({ outcome: "not-yours" });
      expect(await store.commit(ID, cancelStep(2, by))).toMatchObject({
        outcome: "cancelled",
        termed: { record: { state: "cancelled", reason: because("sender") } },
      });
      expect(await store.commit(ID, cancelStep(2, by))).toMatchObject({ outcome: "over" });
      expect(await store.commit(ID, cancelStep(1, by))).toMatchObject({
        outcome: "delivered",
        record: { state: "delivered" },
      });
      expect(await store.commit(ID, cancelStep(3, by))).toEqual({ outcome: "no-command" });
    });

    it("stores the request to cancel a delivered command, and ends one that never arrived", async () => {
      const { add, deliver, store, states } = await withRobot();
      const by = sent.driver;
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(3);
      expect(await store.commit(ID, recalledStep())).toEqual([]);
      for (const seq of [1, 2, 4]) await store.commit(ID, cancelStep(seq, by));
      await store.commit(ID, cancelStep(2, by));
      expect(await store.commit(ID, recalledStep())).toEqual([
        { seq: 1, cause: "sender" },
        { seq: 2, cause: "sender" },
      ]);
      await store.commit(ID, acquireStep(pageState({ lastApplied: 1, fresh: false, endings: [] })));
      expect(await states()).toEqual(["1 started", "2 cancelled", "3 accepted", "4 cancelled"]);
      expect(await store.command(ID, 1)).toMatchObject({ reason: null });
      expect(await store.command(ID, 2)).toMatchObject({ reason: because("sender") });
      expect(await store.commit(ID, recalledStep())).toEqual([{ seq: 1, cause: "sender" }]);
      await store.commit(ID, endStep(EPOCH + 1, completed(1)));
      expect(await store.commit(ID, recalledStep())).toEqual([]);
    });
  });
}
