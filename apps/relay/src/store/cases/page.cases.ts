/** Requirements for every store: a page that acquires a robot. */
import { describe, expect, it } from "vitest";
import { abandonStep, acquireStep } from "../../commands/page-transitions.ts";
import { endStep, startStep } from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import {
  because,
  ID,
  LEFT,
  STOP,
  EPOCH,
  nothingDone,
  type OpenStore,
  pageState,
  robotIn,
} from "./robot-in-store.ts";

export function pageCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: a page acquires the robot`, () => {
    it("raises the epoch, requeues commands that never arrived, and retains the started ones", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(8);
      const taken = await store.commit(
        ID,
        acquireStep(
          pageState({
            lastApplied: 2,
            fresh: false,
            endings: [completed(1)],
          }),
        ),
      );
      expect(taken?.epoch).toBe(EPOCH + 1);
      expect(await states()).toEqual(["1 completed", "2 started", "3 accepted", "4 accepted"]);
      expect((await store.commit(ID, acquireStep(nothingDone)))?.epoch).toBe(EPOCH + 2);
    });

    it("rejects the messages of the previous page", async () => {
      const { add, store, deliver, states } = await withRobot();
      await add(LEFT);
      await deliver(8);
      await store.commit(ID, acquireStep(pageState({ lastApplied: 1, fresh: false, endings: [] })));
      expect(await store.commit(ID, startStep(EPOCH, 1))).toBeNull();
      expect(await store.commit(ID, endStep(EPOCH, completed(1)))).toMatchObject({
        outcome: "over",
      });
      expect(await deliver(8, EPOCH)).toEqual([]);
      expect(await states()).toEqual(["1 started"]);
    });

    it("lists the endings that come too late, and accepts repeated ones", async () => {
      const { add, store, deliver } = await withRobot();
      await add(LEFT);
      await add(LEFT);
      await deliver(8);
      await store.commit(ID, endStep(EPOCH, completed(1)));
      await store.commit(ID, abandonStep(EPOCH));
      const endings = [completed(1), completed(2)];
      const taken = await store.commit(
        ID,
        acquireStep(pageState({ lastApplied: 2, fresh: false, endings })),
      );
      expect(taken).toMatchObject({ changed: [], refused: [{ seq: 2, state: "cancelled" }] });
    });

    it("ends the commands that a reloaded page had started, and those that a waiting stop had overtaken", async () => {
      const { add, store, states, deliver } = await withRobot();
      for (let n = 0; n < 3; n++) await add(LEFT);
      await deliver(8);
      await add(STOP);
      await store.commit(ID, acquireStep(pageState({ lastApplied: 1, fresh: true, endings: [] })));
      expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 cancelled", "4 accepted"]);
      expect(await store.command(ID, 1)).toMatchObject({ reason: because("reloaded") });
    });

    it("records the position of the restored robot in each command that a reload has cancelled", async () => {
      const pose = { x: 50.25, y: 150, heading: 90.5 };
      for (const knownEpoch of [Number.MAX_SAFE_INTEGER, null]) {
        const { add, store, deliver } = await withRobot();
        for (let n = 0; n < 3; n++) await add(LEFT);
        await deliver(2);
        await store.commit(ID, startStep(EPOCH, 1));
        const page = pageState({ lastApplied: 2, fresh: true, pose, knownEpoch });
        const { changed = [] } = (await store.commit(ID, acquireStep(page))) ?? {};
        expect(changed.map(({ seq, state }) => [seq, state])).toEqual([
          [1, "cancelled"],
          [2, "cancelled"],
        ]);
        for (const record of changed) expect(record).toMatchObject({ pose, distance: 0 });
        expect(await store.command(ID, 2)).toMatchObject({ pose, distance: 0 });
      }
    });

    it("ends the commands that the previous page may have started, and requeues none", async () => {
      for (const knownEpoch of [null, EPOCH - 1]) {
        const { add, store, states, deliver } = await withRobot();
        for (let n = 0; n < 4; n++) await add(LEFT);
        await deliver(3);
        await store.commit(ID, startStep(EPOCH, 1));
        const state = pageState({ lastApplied: 1, knownEpoch, left: "taken-over" });
        const taken = await store.commit(ID, acquireStep(state));
        expect(taken?.changed.map(({ seq, reason }) => [seq, reason])).toEqual([
          [1, because("taken-over")],
          [2, because("taken-over-unsure")],
          [3, because("taken-over-unsure")],
        ]);
        expect(await states()).toEqual(["1 cancelled", "2 cancelled", "3 cancelled", "4 accepted"]);
      }
    });

    it("ends them because of the reload if the previous page is disconnected", async () => {
      const { add, store, deliver } = await withRobot();
      for (let n = 0; n < 2; n++) await add(LEFT);
      await deliver(2);
      await store.commit(ID, startStep(EPOCH, 1));
      const state = pageState({ fresh: true, knownEpoch: null, left: "reloaded" });
      const { changed = [] } = (await store.commit(ID, acquireStep(state))) ?? {};
      expect(changed.map(({ seq, reason }) => [seq, reason])).toEqual([
        [1, because("reloaded")],
        [2, because("reloaded-unsure")],
      ]);
    });

    it("lists the open commands in order", async () => {
      const { add, store, deliver } = await withRobot();
      for (let n = 0; n < 4; n++) await add(LEFT);
      await deliver(3);
      await store.commit(ID, startStep(EPOCH, 1));
      await store.commit(
        ID,
        endStep(EPOCH, {
          seq: 2,
          state: "completed",
          reason: null,
          pose: null,
          distance: 0,
        }),
      );
      const open = await store.openCommands(ID);
      expect(open.map(({ seq, state }) => `${seq} ${state}`)).toEqual([
        "1 started",
        "3 delivered",
        "4 accepted",
      ]);
      expect(await store.openCommands("BBBBBBBBBBBBBBBBBBBBBB")).toEqual([]);
    });

    it("never reuses a number that the page has seen", async () => {
      const { add, store } = await withRobot();
      await store.commit(
        ID,
        acquireStep(pageState({ lastApplied: 41, fresh: false, endings: [] })),
      );
      expect(await add(LEFT)).toMatchObject({ record: { seq: 42 } });
    });
  });
}
