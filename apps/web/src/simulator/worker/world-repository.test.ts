import { Recording } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { MemoryWorldStore } from "./testing/memory-world-store.ts";
import { WorldRepository } from "./world-repository.ts";
import type { WorldStore } from "./world-store.ts";

/** A repository whose timeout ends as soon as nothing else is pending. */
function newKeeper(store: WorldStore, noteKey = (_key: string | null) => Promise.resolve(true)) {
  const recording = new Recording(firstMaze, firstProgram);
  const keys: (string | null)[] = [];
  const keeper = new WorldRepository({
    openStore: async () => store,
    recording: () => recording,
    startedAt: () => 0,
    journal: () => null,
    storeKey: (key) => {
      keys.push(key);
      return noteKey(key);
    },
    onClaimed: () => undefined,
    newId: () => "id",
    now: () => 0,
    after: (_milliseconds, call) => {
      const timer = setTimeout(call);
      return () => clearTimeout(timer);
    },
  });
  return { keeper, recording, keys };
}

describe("a stored world", () => {
  it("waits for a page that loads long after its robot, and is stored then", async () => {
    const store = new MemoryWorldStore();
    const late = () => new Promise<boolean>((resolve) => setTimeout(() => resolve(true), 30));
    const { keeper, keys } = newKeeper(store, late);
    await keeper.save();
    expect(keys).toEqual(["id"]);
    expect(store.worlds.size).toBe(1);
  });

  it("is given up if the store does not respond: endings are not delayed for ever", async () => {
    const store = new MemoryWorldStore();
    store.write = () => new Promise(() => undefined);
    const { keeper, keys } = newKeeper(store);
    await keeper.save();
    expect(keys).toEqual(["id", null]);
    await keeper.save();
    expect(keys).toHaveLength(2);
  });

  it("is written completely again if the device has deleted it", async () => {
    const store = new MemoryWorldStore();
    const { keeper, recording } = newKeeper(store);
    recording.addInput({ do: "driver", driver: "me" });
    await keeper.save();
    store.worlds.clear();
    recording.step();
    await keeper.save();
    expect((await store.claim("id", "another"))?.run).toMatchObject({
      maze: firstMaze,
      ticks: 1,
      inputs: [{ tick: 0, do: "driver", driver: "me" }],
    });
  });

  it("appends changes, and starts again if inputs were discarded", async () => {
    const store = new MemoryWorldStore();
    const { keeper, recording } = newKeeper(store);
    const kinds = async () => {
      await keeper.save();
      return store.worlds.get("id")?.inputs.map((input) => Reflect.get(input, "do"));
    };
    recording.addInput({ do: "driver", driver: "me" });
    expect(await kinds()).toEqual(["driver"]);
    recording.step();
    recording.addInput({ do: "command", command: { action: "forward" } });
    expect(await kinds()).toEqual(["driver", "command"]);
    recording.truncate(0);
    expect(await kinds()).toEqual(["driver"]);
  });
});
