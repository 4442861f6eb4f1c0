/** Several relays at one Redis: what a step costs, and what happens if another relay came first. */
import { describe, expect, it, onTestFinished } from "vitest";
import { acquireStep } from "../../../../apps/relay/src/commands/page-transitions.ts";
import { changeKeysStep } from "../../../../apps/relay/src/commands/permissions.ts";
import {
  addStep,
  cancelStep,
  deliverStep,
  endStep,
  expireStep,
  startStep,
} from "../../../../apps/relay/src/commands/state-machine.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { completed } from "../../../../apps/relay/src/platform/testing/messages.ts";
import {
  ID,
  keyChange,
  LEFT,
  NOW,
  nothingDone,
  sent,
  STOP,
} from "../../../../apps/relay/src/store/cases/robot-in-store.ts";
import { connectRedis, type Redis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { channelOf } from "../../../../apps/relay/src/store/redis/redis-keys.ts";
import { RedisRobotStore } from "../../../../apps/relay/src/store/redis/redis-robot-store.ts";
import { RobotQueue } from "../../../../apps/relay/src/store/redis/robot-queue.ts";
import * as machine from "../../../../apps/relay/src/commands/state-machine.ts";
import { StoreFull } from "../../../../apps/relay/src/platform/errors/disk-full.ts";
import { StoreUnavailableError } from "../../../../apps/relay/src/platform/errors/store-unavailable.ts";

async function connected(url: string): Promise<Redis> {
  const redis = await connectRedis(url, () => undefined);
  onTestFinished(() => redis.destroy());
  return redis;
}

/** A store, and the number of requests that it has sent. */
async function relayAt(url: string, name: string) {
  const redis = await connected(url);
  let requests = 0;
  const counting = new Proxy(redis, {
    get(target, property) {
      const part: unknown = Reflect.get(target, property);
      if (typeof part !== "function") return part;
      return (...values: unknown[]): unknown => {
        requests += 1;
        return Reflect.apply(part, target, values);
      };
    },
  });
  const store = new RedisRobotStore(counting, new DeletedBytes(redis), name);
  const cost = async (step: () => Promise<unknown>): Promise<number> => {
    const before = requests;
    await step();
    return requests - before;
  };
  return { redis, store, cost };
}

async function withRelays() {
  const { url } = await startTestRedis(["--appendfsync", "always"]);
  const a = await relayAt(url, "relay-a");
  const b = await relayAt(url, "relay-b");
  const subscriber = await connected(url);
  const published: unknown[] = [];
  await subscriber.subscribe(channelOf(ID), (text) => published.push(JSON.parse(text)));
  const keys = [{ kind: "drive" as const, hash: sent.driver }];
  await a.store.create({ id: ID, createdAt: 1_000, keys });
  const taken = await a.store.commit(ID, acquireStep(nothingDone));
  return { a, b, published, epoch: taken?.epoch ?? 0 };
}

describe("a step", () => {
  it("fails if other relays change the robot at each attempt, and does not delay the next step", async () => {
    let calls = 0;
    const state = ["a version", "1", "0", "0", "[]", null, null, null];
    const script = {
      call: async () => {
        calls += 1;
        return calls < 100 ? ["stale", state, []] : ["done"];
      },
    };
    const queue = new RobotQueue(ID, { script, relay: "relay-a", newVersion: () => String(calls) });
    const pause = async () =>
      queue.run({ none: null, work: ({ commands }) => machine.pause(commands, true) });
    await expect(pause()).rejects.toBeInstanceOf(StoreUnavailableError);
    expect(calls).toBeLessThan(40);
    calls = 100;
    expect(await pause()).toEqual([]);
    expect(queue.isIdle).toBe(true);
  });
});

describe("a step that another relay's change has delayed", () => {
  const robotNow = (version: string) => [[version, "1", "0", "0", "[]", null, null, null], []];

  it.each([...Array(12).keys()])(
    "precedes a step that arrives %i promises after the rejection",
    async (promises) => {
      let version = "theirs";
      const stored: string[] = [];
      const refusal = Promise.withResolvers<null>();
      const script = {
        call: async (_keys: string[], [expected = "", next = "", , ...changes]: string[]) => {
          if (expected === "*") return ["stale", ...robotNow("old")];
          if (expected === "old") await refusal.promise;
          if (expected !== version) return ["stale", ...robotNow(version)];
          version = next;
          stored.push(changes.at(-1) ?? "");
          return ["done"];
        },
      };
      let versions = 0;
      const newVersion = () => `version ${(versions += 1)}`;
      const queue = new RobotQueue(ID, { script, relay: "relay-a", newVersion });
      const keep = async (maze: string) =>
        queue.run({ none: undefined, work: (robot) => robot.set({ maze }) });
      const first = keep("first");
      await new Promise(setImmediate);
      refusal.resolve(null);
      for (let n = 0; n < promises; n++) await Promise.resolve();
      await Promise.all([first, keep("second")]);
      expect(stored).toEqual(["first", "second"]);
    },
  );
});

describe.skipIf(!hasRedis)("steps of a robot in Redis", () => {
  it("cost one request each while one relay serves the robot", async () => {
    const { a, epoch } = await withRelays();
    // The first command makes Redis load the scripts.
    await a.store.commit(ID, addStep(sent));
    const costs = [
      await a.cost(() => a.store.commit(ID, addStep({ ...sent, key: "key-0001" }))),
      await a.cost(() => a.store.commit(ID, deliverStep(epoch, 8, NOW))),
      await a.cost(() => a.store.commit(ID, startStep(epoch, 1))),
      await a.cost(() => a.store.commit(ID, endStep(epoch, completed(1)))),
      await a.cost(() => a.store.commit(ID, expireStep(NOW))),
      await a.cost(() => a.store.commit(ID, cancelStep(2, sent.driver))),
    ];
    expect(costs).toEqual([1, 1, 1, 1, 1, 1]);
  });

  it("cost two requests each if another relay has changed the robot", async () => {
    const { a, b } = await withRelays();
    await a.store.commit(ID, addStep(sent));
    await b.store.commit(ID, addStep(sent));
    expect(await a.cost(() => a.store.commit(ID, addStep(sent)))).toBe(2);
    expect(await b.cost(() => b.store.commit(ID, addStep(sent)))).toBe(2);
  });

  it("are sent without waiting for each other, and keep their order if another relay came first", async () => {
    const { a, b, epoch } = await withRelays();
    await b.store.commit(ID, addStep(sent));
    const both = () =>
      Promise.all([
        a.store.commit(ID, addStep({ ...sent, key: "key-0001" })),
        a.store.commit(ID, deliverStep(epoch, 8, NOW)),
      ]);
    const requests = await a.cost(async () => {
      const [added, due] = await both();
      expect(added).toMatchObject({ outcome: "stored", record: { seq: 2 } });
      expect(due.map(({ record }) => record.seq)).toEqual([1, 2]);
    });
    expect(requests).toBe(4);
  });

  it("of two concurrent relays lose and repeat nothing, and each is published once, in order", async () => {
    const { a, b, published, epoch } = await withRelays();
    const count = 40;
    const add = async (n: number) =>
      (n % 2 === 0 ? a : b).store.commit(ID, addStep({ ...sent, key: `key-${1_000 + n}` }));
    const twice = [...Array(count).keys()].flatMap((n) => [add(n), add(n)]);
    const results = await Promise.all(twice);
    const outcomes = results.map(({ outcome }) => outcome);
    expect(outcomes.filter((outcome) => outcome === "stored")).toHaveLength(count);
    expect(outcomes.filter((outcome) => outcome === "duplicate")).toHaveLength(count);
    await Promise.all([
      a.store.commit(ID, deliverStep(epoch, 8, NOW)),
      b.store.commit(ID, deliverStep(epoch, 8, NOW)),
    ]);
    const open = await a.store.openCommands(ID);
    expect(open.map(({ seq }) => seq)).toEqual([...Array(count).keys()].map((n) => n + 1));
    expect(open.filter(({ state }) => state === "delivered")).toHaveLength(8);
    const steps = published.filter((message) => Object(message).kind === "step");
    expect(steps.map((message) => Object(message).n)).toEqual(
      [...Array(count + 1).keys()].map((n) => n + 1),
    );
  });

  it("recognise the idempotency key of a command that ended at another relay", async () => {
    const { a, b, epoch } = await withRelays();
    const command = { ...sent, key: "key-0001" };
    await a.store.commit(ID, addStep(command));
    await a.store.commit(ID, deliverStep(epoch, 8, NOW));
    await a.store.commit(ID, endStep(epoch, completed(1)));
    for (const { store } of [a, b]) {
      expect(await store.commit(ID, addStep(command))).toMatchObject({
        outcome: "duplicate",
        record: { seq: 1, state: "completed" },
      });
      expect(await store.commit(ID, addStep({ ...command, command: STOP }))).toMatchObject({
        outcome: "conflict",
      });
    }
  });

  it("publish a page before the commands that it changes, with the data for readers and pages", async () => {
    const { a, published, epoch } = await withRelays();
    await a.store.commit(ID, addStep(sent));
    await a.store.commit(ID, deliverStep(epoch, 8, NOW));
    await a.store.commit(ID, acquireStep({ ...nothingDone, page: "page-two" }));
    await a.store.commit(ID, changeKeysStep(keyChange({ remove: [sent.driver] })));
    await a.store.remove(ID);
    expect(published).toMatchObject([
      { kind: "page", from: "relay-a", epoch: 1, name: "" },
      { kind: "step", n: 1, from: "relay-a", added: { seq: 1, state: "accepted" }, changed: [] },
      { kind: "step", n: 2, added: null, changed: [{ seq: 1, state: "delivered" }] },
      { kind: "page", epoch: 2, name: "page-two" },
      { kind: "step", n: 3, added: null, changed: [{ seq: 1, state: "accepted" }] },
      { kind: "keys", from: "relay-a" },
      {
        kind: "step",
        n: 4,
        changed: [{ seq: 1, state: "cancelled", reason: { cause: "revoked", by: null } }],
      },
      { kind: "over", from: "relay-a" },
    ]);
  });

  it("change nothing while the memory of Redis is full, and succeed again afterwards", async () => {
    const { a, published, epoch } = await withRelays();
    await a.store.commit(ID, addStep(sent));
    await a.redis.configSet("maxmemory", "100kb");
    const steps = await Promise.allSettled([
      a.store.commit(ID, addStep({ ...sent, replace: true })),
      a.store.commit(ID, deliverStep(epoch, 8, NOW)),
      a.store.commit(ID, addStep(sent)),
    ]);
    for (const step of steps)
      expect(step).toMatchObject({ status: "rejected", reason: expect.any(StoreFull) });
    expect(await a.store.openCommands(ID)).toMatchObject([{ seq: 1, state: "accepted" }]);
    expect(published).toHaveLength(2);
    await a.redis.configSet("maxmemory", "0");
    expect(await a.store.commit(ID, addStep({ ...sent, command: LEFT }))).toMatchObject({
      record: { seq: 2 },
    });
  });

  it("restore nothing of a robot that another relay has deleted", async () => {
    const { a, b } = await withRelays();
    await a.store.commit(ID, addStep(sent));
    await b.store.remove(ID);
    expect(await a.store.commit(ID, addStep(sent))).toEqual({ outcome: "no-robot" });
    await a.store.touch(ID, 9_000, [{ hash: sent.driver, at: 9_000 }]);
    expect(await a.store.storeMaze(ID, "{}")).toBe(false);
    expect(await a.redis.keys("corridor:*")).toEqual([]);
  });
});
