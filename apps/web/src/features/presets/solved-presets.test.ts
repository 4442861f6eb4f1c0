import { mazePresets, setBlock, setStart, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../app/testing/memory-storage.ts";
import { createRunStore } from "../../stores/run-store.ts";
import { createWorkspaceStore, setMaze } from "../../stores/workspace-store.ts";
import type { Moment } from "../../worker/worker-messages.ts";
import { createSolvedStore } from "./solved-presets.ts";

const KEY = "corridor.solved";
const spiral = mazePresets.find(({ id }) => id === "spiral")?.maze;
const program = programPresets[0]?.program;
if (spiral === undefined || program === undefined) throw new Error("a preset is gone");
const solvedSpiral: MazeDocument = { ...spiral, name: "Spirale" };

function open(device = new MemoryStorage()) {
  const run = createRunStore();
  const workspace = createWorkspaceStore(solvedSpiral, program as NonNullable<typeof program>);
  const solved = createSolvedStore({ run, workspace, device });
  const tell = (kind: "goal" | "bump", driver: Moment["driver"] = "program"): void => {
    const moment = { kind, driver, tick: 1, bumps: 0, line: null } as Partial<Moment> as Moment;
    run.setState({ moment });
  };
  return { device, workspace, solved, tell, ids: () => solved.getState().ids };
}

describe("solved presets", () => {
  it.each(["me", "program"] as const)("are marked when %s reaches the goal", (driver) => {
    const { tell, ids, device } = open();
    tell("goal", driver);
    expect(ids()).toEqual(["spiral"]);
    expect(open(device).ids()).toEqual(["spiral"]);
  });

  it("are not marked by a bump, nor by a script", () => {
    const { tell, ids } = open();
    tell("bump");
    tell("goal", "remote");
    expect(ids()).toEqual([]);
  });

  it.each([
    {
      change: "a block taken out",
      edit: () => setBlock(solvedSpiral, { column: 2, row: 2 }, false),
    },
    {
      change: "the start put elsewhere",
      edit: () => setStart(solvedSpiral, { column: 5, row: 3 }, "south"),
    },
  ])("are not marked with $change", ({ edit }) => {
    const { workspace, tell, ids } = open();
    const result = edit();
    if (!result.ok) throw new Error(result.code);
    setMaze(workspace, result.maze);
    tell("goal");
    expect(ids()).toEqual([]);
  });

  it("keeps what another tab has marked since", () => {
    const { tell, ids, device } = open();
    device.setItem(KEY, '["tree"]');
    tell("goal");
    expect(ids().toSorted()).toEqual(["spiral", "tree"]);
    expect(JSON.parse(device.getItem(KEY) ?? "")).toEqual(ids());
  });

  it.each(["", "no list", '{"tree":1}', '["tree", 5, "a maze of tomorrow"]'])(
    "reads what it knows from %s",
    (stored) => {
      const device = new MemoryStorage();
      device.setItem(KEY, stored);
      expect(open(device).ids()).toEqual(stored.includes("[") ? ["tree"] : []);
    },
  );

  it("marks for this visit where the device keeps nothing", () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const { tell, ids } = open(device);
    tell("goal");
    expect(ids()).toEqual(["spiral"]);
  });
});
