import { Recording } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "./first-project.ts";
import { MemoryWorldStore } from "./testing/memory-world-store.ts";
import { WorldKeeper } from "./world-keeper.ts";
import type { WorldStore } from "./world-store.ts";

/** A keeper whose patience is over as soon as nothing else is to be done. */
function newKeeper(store: WorldStore, noteKey = (_key: string | null) => Promise.resolve(true)) {
  const recording = new Recording(firstMaze, firstProgram);
  const keys: (string | null)[] = [];
  const keeper = new WorldKeeper({
    openStore: async () => store,
    recording: () => recording,
    journal: () => null,
    noteKey: (key) => {
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

describe("a world that is stored", () => {
  it("waits for a page that comes long after its robot, and is stored then", async () => {
    const store = new MemoryWorldStore();
    const late = () => new Promise<boolean>((resolve) => setTimeout(() => resolve(true), 30));
    const { keeper, keys } = newKeeper(store, late);
    await keeper.save();
    expect(keys).toEqual(["id"]);
    expect(store.worlds.size).toBe(1);
  });

  it("is given up where the store does not answer: endings are not held up for ever", async () => {
    const store = new MemoryWorldStore();
    store.write = () => new Promise(() => undefined);
    const { keeper, keys } = newKeeper(store);
    await keeper.save();
    expect(keys).toEqual(["id", null]);
    await keeper.save();
    expect(keys).toHaveLength(2);
  });

  it("is written whole again where the device has forgotten it", async () => {
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

  it("adds what is new, and begins anew where inputs were taken back", async () => {
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
