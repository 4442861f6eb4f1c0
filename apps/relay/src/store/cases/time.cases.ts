/** Requirements for every store: deadlines. */
import { expiredReason } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { deliverStep, endStep, expireStep } from "../../commands/state-machine.ts";
import { completed } from "../../platform/testing/messages.ts";
import { ID, LEFT, NOW, EPOCH, sent, type OpenStore, robotIn } from "./robot-in-store.ts";

export function timeCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: time to live`, () => {
    const short = { ttl: 400, deadline: NOW + 400 };

    it("expires commands that wait too long, and returns the next deadline", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT, null, short);
      await add(LEFT);
      expect(await store.commit(ID, expireStep(NOW + 399))).toEqual({ ended: [], next: NOW + 400 });
      const { ended, next } = await store.commit(ID, expireStep(NOW + 400));
      expect(ended).toMatchObject([
        { ttl: 400, record: { seq: 1, state: "expired", reason: expiredReason(400) } },
      ]);
      expect(next).toBe(NOW + 10_000);
      expect(await states()).toEqual(["1 expired", "2 accepted"]);
      expect(await store.commit(ID, expireStep(NOW + 10_000))).toMatchObject({ next: null });
    });

    it("leaves commands that were delivered in time to the robot, and delivers none late", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT, null, short);
      await add(LEFT, null, short);
      expect(await store.commit(ID, deliverStep(EPOCH, 1, NOW + 399))).toMatchObject([
        {
          record: { seq: 1 },
          driver: sent.driver,
          deadline: NOW + 400,
          replace: false,
          lease: null,
        },
      ]);
      expect(await store.commit(ID, deliverStep(EPOCH, 8, NOW + 400))).toEqual([]);
      await store.commit(ID, expireStep(NOW + 400));
      expect(await states()).toEqual(["1 delivered", "2 expired"]);
      expect(
        await store.commit(ID, endStep(EPOCH, { ...completed(1), state: "expired" })),
      ).toMatchObject({
        outcome: "ended",
      });
    });

    it("rejects a late command without using its key, and recognises a known key at any age", async () => {
      const { add, states } = await withRobot();
      expect(await add(LEFT, "key-0001", { deadline: NOW })).toEqual({ outcome: "late" });
      expect(await add(LEFT, "key-0001")).toMatchObject({ outcome: "stored", record: { seq: 1 } });
      expect(await add(LEFT, "key-0001", { deadline: NOW })).toMatchObject({
        outcome: "duplicate",
      });
      expect(await states()).toEqual(["1 accepted"]);
    });

    it("gives no extra time when the clock was set back", async () => {
      const { add, store, states } = await withRobot();
      await add(LEFT);
      expect(await store.commit(ID, deliverStep(EPOCH, 8, NOW - 2_001))).toEqual([]);
      expect(await store.commit(ID, expireStep(NOW - 2_000))).toMatchObject({ ended: [] });
      expect(await store.commit(ID, expireStep(NOW - 2_001))).toMatchObject({
        ended: [{ ttl: 10_000 }],
      });
      expect(await states()).toEqual(["1 expired"]);
    });

    it("restores the deadlines after a restart", async () => {
      const { add, store, reopen } = await withRobot();
      await add(LEFT, null, short);
      await store.close();
      const again = await reopen();
      expect(await again.commit(ID, expireStep(NOW))).toEqual({ ended: [], next: NOW + 400 });
    });
  });
}
