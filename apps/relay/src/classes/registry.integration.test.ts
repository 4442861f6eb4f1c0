import { join } from "node:path";
import { expect, it, onTestFinished, vi } from "vitest";
import { LocalClassBus } from "../bus/local-class-bus.ts";
import { SqliteFile } from "../store/sqlite/file/sqlite-file.ts";
import { SqliteClassStore } from "../store/sqlite/sqlite-class-store.ts";
import { testFolder } from "../testing/test-relay.ts";
import { classAtTwoRelays } from "./two-relays.cases.ts";

function openBackend() {
  const file = new SqliteFile(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => file.close());
  return { store: new SqliteClassStore(file), bus: new LocalClassBus() };
}

it("disconnects the students of a class whose first deletion failed", async () => {
  const backend = openBackend();
  const { a, at, join: joinAt, student } = await classAtTwoRelays([backend, backend]);
  const { closed } = await student(a, await joinAt(a));
  vi.spyOn(backend.store, "remove").mockRejectedValueOnce(new Error("the disk is full"));
  await expect(a.remove(await at(a))).rejects.toThrow("the disk is full");
  expect(closed).toEqual([]);
  await a.remove(await at(a));
  expect(closed).toEqual(["over"]);
});

it("admits students while the files still contain one who was removed", async () => {
  const backend = openBackend();
  const { a, at, join: joinAt, student } = await classAtTwoRelays([backend, backend]);
  const { closed } = await student(a, await joinAt(a));
  const { promise: erased, resolve: erase } = Promise.withResolvers<void>();
  vi.spyOn(backend.store, "erased").mockReturnValueOnce(erased);
  const isDone = vi.fn<() => void>();
  const removed = (await at(a)).removeStudent(1).then(isDone);
  await vi.waitFor(() => expect(closed).toEqual(["removed"]));
  await joinAt(a);
  expect(isDone).not.toHaveBeenCalled();
  erase();
  await removed;
});
