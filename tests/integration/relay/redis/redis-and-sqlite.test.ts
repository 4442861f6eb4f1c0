/** Both stores apply the same rules: any steps have the same results, at any number of relays. */
import { join } from "node:path";
import fc from "fast-check";
import { describe, expect, it, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { testFolder } from "../../../../apps/relay/src/testing/test-relay.ts";
import { SqliteRobotStore } from "../../../../apps/relay/src/store/sqlite/sqlite-robot-store.ts";
import {
  stepsKeeping,
  contentsOf,
  type StepOfRobot,
} from "../../../../apps/relay/src/store/cases/random-steps.ts";
import { ROBOTS, withRobots } from "../../../../apps/relay/src/store/cases/robot-in-store.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisRobotStore } from "../../../../apps/relay/src/store/redis/redis-robot-store.ts";

interface Turn extends StepOfRobot {
  relay: 0 | 1;
  /** the next step is at the same relay, and does not wait for this one */
  isHurried: boolean;
}

/**
 * All commands of a run retain equally many others, as in a relay. A relay that loads a robot again
 * does not know the highest limit so far.
 */
const turnsKeeping = (keep: number) =>
  fc.array(
    fc.record<Turn>({
      step: stepsKeeping(keep),
      robot: fc.constantFrom(...ROBOTS),
      relay: fc.constantFrom(0, 1),
      isHurried: fc.boolean(),
    }),
    { minLength: 10, maxLength: 60 },
  );
const turns = fc.oneof(turnsKeeping(2), turnsKeeping(100));

describe.skipIf(!hasRedis)("a store in Redis", () => {
  it("has the same results as SQLite, though several relays share it and release robots", async () => {
    const { url } = await startTestRedis(["--appendonly", "no"]);
    const redis = await connectRedis(url, () => undefined);
    onTestFinished(() => redis.destroy());
    const folder = testFolder();
    let runs = 0;
    await fc.assert(
      fc.asyncProperty(turns, fc.constantFrom(1, 2, 8), async (all, most) => {
        await redis.flushAll();
        const relays = ["relay-a", "relay-b"].map(
          (name) => new RedisRobotStore(redis, new DeletedBytes(redis), name, most),
        );
        const sqlite = new SqliteRobotStore(join(folder, `${runs++}.sqlite`), 1_000_000);
        const [first] = relays;
        if (first === undefined) return;
        await Promise.all([withRobots(sqlite), withRobots(first)]);
        let pairs: Promise<unknown>[][] = [];
        const answered = async (): Promise<void> => {
          const results = await Promise.all(pairs.map(async (pair) => Promise.all(pair)));
          for (const [got, expected] of results) expect(got).toEqual(expected);
          pairs = [];
        };
        let at = 0;
        for (const { step, robot, relay, isHurried } of all) {
          const store = relays[at] ?? first;
          pairs.push([step(store, robot), step(sqlite, robot)]);
          if (isHurried) continue;
          await answered();
          at = relay;
        }
        await answered();
        for (const store of relays)
          expect(await contentsOf(store)).toEqual(await contentsOf(sqlite));
        await sqlite.close();
      }),
      { numRuns: 40 },
    );
  });
});
