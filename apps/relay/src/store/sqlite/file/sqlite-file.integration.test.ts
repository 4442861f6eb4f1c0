import { join } from "node:path";
import type { Command } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { acquireStep } from "../../../commands/page-transitions.ts";
import { addStep, deliverStep, endStep, startStep } from "../../../commands/state-machine.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { withPageLimit } from "../../../platform/testing/page-limit.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import type { Ballast } from "./ballast.ts";
import { isDiskFull } from "../../../platform/errors/disk-full.ts";
import { SqliteFile, withRoom } from "./sqlite-file.ts";
import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { ID, NOW, pageState, sent } from "../../cases/robot-in-store.ts";

const LONG_REASON = "x".repeat(200);

describe("a database that a newer Corridor has to rewrite", () => {
  const full = (): never => {
    throw Object.assign(new Error("database or disk is full"), { errcode: 13 });
  };

  it("receives the space of the ballast file for that", () => {
    let isHeld = true;
    const ballast: Ballast = { hold: () => isHeld, release: () => !(isHeld = false) };
    expect(withRoom(() => (isHeld ? full() : "open"), ballast)).toBe("open");
  });

  it("reports how much space to free if that does not suffice", () => {
    const ballast: Ballast = { hold: () => true, release: () => true };
    expect(() => withRoom(full, ballast)).toThrow(/twice the size/);
    expect(() => withRoom(() => JSON.parse("{"), ballast)).toThrow(SyntaxError);
  });
});

/** A robot with accepted and started commands, on a disk that is full except for the ballast. */
async function onFillingDisk() {
  const ballast = { isHeld: true, hasRoom: false, release: () => false };
  const holder: Ballast = {
    release: () => ballast.release(),
    hold: () => ballast.isHeld || ballast.hasRoom,
  };
  const path = join(testFolder(), "corridor.sqlite");
  const { opened, fill, makeRoom } = await withPageLimit(
    () => new SqliteFile(path, { ballast: holder }),
  );
  const store = new SqliteRobotStore(opened);
  onTestFinished(() => store.close());
  await store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
  const add = (command: Command, key: string | null = null) =>
    store.commit(
      ID,
      addStep({
        driver: "d",
        script: null,
        key,
        command,
        acceptedAt: 1,
        ttl: 10_000,
        deadline: 10_001,
        replace: false,
        lease: null,
        resetFrom: 0,
        maxWaiting: 10_000,
        keep: 20_000,
      }),
    );
  await store.commit(ID, acquireStep(pageState({ knownEpoch: 1 })));
  for (let n = 0; n < 50; n++) await add({ action: "left 90" });
  await store.commit(ID, deliverStep(1, 50, 1));
  ballast.release = () => {
    const wasHeld = ballast.isHeld;
    ballast.isHeld = false;
    if (wasHeld) fill(40);
    return wasHeld;
  };
  fill();
  const freeSpace = (): void => {
    makeRoom();
    ballast.hasRoom = true;
  };
  return { store, add, freeSpace };
}

/** The same, after the first rejected command. */
async function onFullDisk() {
  const { store, add, freeSpace } = await onFillingDisk();
  let stored = 0;
  const fails = await (async () => {
    for (;;) {
      try {
        await add({ action: "left 90" }, `${"k".repeat(50)}-${stored}`);
        stored += 1;
      } catch (error) {
        return error;
      }
    }
  })();
  return { store, add, fails, freeSpace };
}

describe("a full disk", () => {
  it("delivers the first command that has space again, with the following ones in order", async () => {
    const path = join(testFolder(), "corridor.sqlite");
    const before = new SqliteRobotStore(path);
    await before.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: sent.driver }] });
    await before.commit(ID, acquireStep(pageState()));
    await before.close();
    let hasRoom = false;
    const ballast: Ballast = { hold: () => hasRoom, release: () => false };
    const store = new SqliteRobotStore(new SqliteFile(path, { ballast }));
    onTestFinished(() => store.close());
    hasRoom = true;
    const first = store.commit(ID, addStep(sent));
    const due = store.commit(ID, deliverStep(1, 8, NOW));
    const second = store.commit(ID, addStep(sent));
    expect(store.current(ID)).toBeNull();
    expect(await first).toMatchObject({ outcome: "stored", record: { seq: 1 } });
    expect(await second).toMatchObject({ outcome: "stored", record: { seq: 2 } });
    expect((await due)[0]).toMatchObject({ record: { seq: 1, state: "delivered" } });
  });

  it("rejects new data, and reports that it is full", async () => {
    const { store, add, fails } = await onFullDisk();
    expect(isDiskFull(fails)).toBe(true);
    await expect(add({ action: "left 90" })).rejects.toSatisfy(isDiskFull);
    await expect(
      store.create({ id: "B", createdAt: 1, keys: [{ kind: "drive", hash: "d" }] }),
    ).rejects.toSatisfy(isDiskFull);
    expect(await store.check()).toBe("full");
  });

  it("still lets robots start and end commands, accept stops, pages connect, and owners delete", async () => {
    const { store, add } = await onFullDisk();
    for (let seq = 1; seq <= 50; seq++) {
      expect(await store.commit(ID, startStep(1, seq))).toMatchObject({ seq, state: "started" });
      const ending = { ...completed(seq), reason: LONG_REASON };
      expect(await store.commit(ID, endStep(1, ending))).toMatchObject({ outcome: "ended" });
    }
    expect(await add({ action: "stop" })).toMatchObject({ outcome: "stored" });
    const page = pageState({ lastApplied: 50, knownEpoch: 1 });
    expect(await store.commit(ID, acquireStep(page))).toMatchObject({ epoch: 2 });
    expect(await store.remove(ID)).toBe(true);
    expect(await store.find(ID)).toBeNull();
  });

  it("completes concurrent steps by releasing the ballast file, including a stop", async () => {
    const { store, add } = await onFillingDisk();
    const endings = Array.from({ length: 50 }, (_, index) =>
      store.commit(ID, endStep(1, { ...completed(index + 1), reason: LONG_REASON })),
    );
    const stop = add({ action: "stop" });
    const outcomes = (await Promise.all(endings)).map(({ outcome }) => outcome);
    expect(new Set(outcomes)).toEqual(new Set(["ended"]));
    expect(await stop).toMatchObject({ outcome: "stored" });
  });

  it("accepts new commands again once as much space is free as it reserves", async () => {
    const { store, add, freeSpace } = await onFullDisk();
    freeSpace();
    expect(await store.check()).toBe("ok");
    expect(await add({ action: "left 90" })).toMatchObject({ outcome: "stored" });
  });
});
