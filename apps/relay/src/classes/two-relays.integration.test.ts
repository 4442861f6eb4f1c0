/** Two relays that share a store and a bus. */
import { join } from "node:path";
import { pino } from "pino";
import { expect, it, onTestFinished } from "vitest";
import { LocalClassBus } from "../bus/local-class-bus.ts";
import type { ClassBus } from "../bus/class-bus.ts";
import { settled } from "../platform/testing/fake-clock.ts";
import { systemClock } from "../platform/time/clock.ts";
import { SqliteFile } from "../store/sqlite/file/sqlite-file.ts";
import { SqliteClassStore } from "../store/sqlite/sqlite-class-store.ts";
import { testFolder } from "../testing/test-relay.ts";
import { ClassRegistry } from "./registry.ts";
import { lockStep } from "./teacher-steps.ts";

/** @param second the bus of the second relay */
async function twoRelays(second: (first: ClassBus) => ClassBus = (first) => first) {
  const file = new SqliteFile(join(testFolder(), "corridor.sqlite"));
  const first = new LocalClassBus();
  const [a, b] = [first, second(first)].map((bus) => {
    const parts = { store: new SqliteClassStore(file), bus, clock: systemClock };
    return new ClassRegistry({ ...parts, log: pino({ level: "silent" }) });
  });
  if (a === undefined || b === undefined) throw new Error("there are two relays");
  onTestFinished(async () => {
    await a.close();
    await b.close();
    await file.close();
  });
  const request = { names: null, expected: null, lesson: "{}" };
  const created = await a.create(request, "1", "http://localhost");
  const at = async (relay: ClassRegistry) =>
    (await relay.authorise(created.id, created.teacherKey, "inspect")).found;
  return { a, b, created, at };
}

it("admits every student once, whichever relay the student uses", async () => {
  const { a, b, created, at } = await twoRelays();
  const joins = Array.from({ length: 40 }, (_, n) => (n % 2 === 0 ? a : b).join(created.code, "1"));
  const joined = await Promise.all(joins);
  expect(new Set(joined.map(({ student }) => student)).size).toBe(40);
  expect(new Set(joined.map(({ name }) => name.word)).size).toBe(40);
  for (const relay of [a, b]) {
    expect((await (await at(relay)).view()).students).toHaveLength(40);
  }
});

it("applies what the teacher sets to students of another relay", async () => {
  const { a, b, created, at } = await twoRelays();
  await b.join(created.code, "1");
  await (await at(a)).run(lockStep(true));
  await settled();
  await expect(b.join(created.code, "1")).rejects.toMatchObject({ kind: "class-locked" });
});

it("decides on the stored state, even if the message of another relay is lost", async () => {
  const { a, b, created, at } = await twoRelays(() => new LocalClassBus());
  await b.join(created.code, "1");
  const { student } = await a.join(created.code, "1");
  expect(student).toBe(2);
  await (await at(a)).run(lockStep(true));
  await expect(b.join(created.code, "1")).rejects.toMatchObject({ kind: "class-locked" });
});

it("ends at all relays", async () => {
  const { a, b, at } = await twoRelays();
  await at(b);
  await a.remove(await at(a));
  await settled();
  await expect(at(b)).rejects.toMatchObject({ kind: "no-class" });
});
