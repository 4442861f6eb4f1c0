import { join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { LocalClassBus } from "../bus/local-class-bus.ts";
import { SqliteFile } from "../store/sqlite/file/sqlite-file.ts";
import { SqliteClassStore } from "../store/sqlite/sqlite-class-store.ts";
import { testFolder } from "../testing/test-relay.ts";
import { lockStep } from "./teacher-steps.ts";
import { classAtTwoRelays, twoRelaysCases } from "./two-relays.cases.ts";

function openStore(): SqliteClassStore {
  const file = new SqliteFile(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => file.close());
  return new SqliteClassStore(file);
}

twoRelaysCases("LocalClassBus", async () => {
  const relay = { store: openStore(), bus: new LocalClassBus() };
  return [relay, relay];
});

it("decides on the stored state, even if the message of another relay is lost", async () => {
  const store = openStore();
  const relays = [new LocalClassBus(), new LocalClassBus()].map((bus) => ({ store, bus }));
  const [first, second] = relays;
  if (first === undefined || second === undefined) throw new Error("there are two relays");
  const { a, b, at, join: joinAt } = await classAtTwoRelays([first, second]);
  await joinAt(b);
  expect(await joinAt(a)).toMatchObject({ student: 2 });
  await (await at(a)).run(lockStep(true));
  await expect(joinAt(b)).rejects.toMatchObject({ kind: "class-locked" });
});
