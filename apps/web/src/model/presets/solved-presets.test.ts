import { mazePresets, setBlock, setStart, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { createRunStore } from "../run/run-store.ts";
import { createWorkspaceStore, setMaze } from "../workspace/workspace-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { createSolvedStore } from "./solved-presets.ts";

// cspell:ignore Spirale

const KEY = "corridor.solved";
const spiral = mazePresets.find(({ id }) => id === "spiral")?.maze;
const program = programPresets[0]?.program;
if (spiral === undefined || program === undefined) throw new Error("a preset is gone");
const solvedSpiral: MazeDocument = { ...spiral, name: "Spirale" };

function open(device = new MemoryStorage()) {
  const run = createRunStore();
  const workspace = createWorkspaceStore(solvedSpiral, program as NonNullable<typeof program>);
  const solved = createSolvedStore({ run, workspace, device });
  const report = async (
    kind: "goal" | "bump",
    driver: RunEvent["driver"] = "program",
  ): Promise<void> => {
    const event = { kind, driver, tick: 1, bumps: 0, line: null } as Partial<RunEvent> as RunEvent;
    run.setState({ nowTick: 150 });
    // The presets are a separate chunk.
    await import("./note-goal.ts");
    await new Promise((resolve) => setTimeout(resolve, 0));
    run.setState({ event });
    // A page that is closed now runs no later task.
    await Promise.resolve();
  };
  return { device, workspace, solved, report, ids: () => solved.getState().ids };
}

describe("solved presets", () => {
  it.each(["me", "program"] as const)("are marked when %s reaches the goal", async (driver) => {
    const { report, ids, device } = open();
    await report("goal", driver);
    expect(ids()).toEqual(["spiral"]);
    expect(open(device).ids()).toEqual(["spiral"]);
  });

  it("are not marked by a bump, nor by a script", async () => {
    const { report, ids } = open();
    await report("bump");
    await report("goal", "remote");
    expect(ids()).toEqual([]);
  });

  it("are marked when the robot starts in another direction", async () => {
    const { workspace, report, ids } = open();
    const { start } = solvedSpiral;
    const heading = start.heading === "south" ? "north" : "south";
    setMaze(workspace, { ...solvedSpiral, start: { ...start, heading } });
    await report("goal");
    expect(ids()).toEqual(["spiral"]);
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
  ])("are not marked with $change", async ({ edit }) => {
    const { workspace, report, ids } = open();
    const result = edit();
    if (!result.ok) throw new Error(result.code);
    setMaze(workspace, result.maze);
    await report("goal");
    expect(ids()).toEqual([]);
  });

  it("retains what another tab has marked since", async () => {
    const { report, ids, device } = open();
    device.setItem(KEY, '["tree"]');
    await report("goal");
    expect(ids().toSorted()).toEqual(["spiral", "tree"]);
    expect(JSON.parse(device.getItem(KEY) ?? "")).toEqual(ids());
  });

  it.each([
    { stored: "", known: [] },
    { stored: "no list", known: [] },
    { stored: '{"tree":1}', known: [] },
    { stored: '["tree", 5, "a maze of tomorrow"]', known: ["tree", "a maze of tomorrow"] },
  ])("reads the names in $stored", ({ stored, known }) => {
    const device = new MemoryStorage();
    device.setItem(KEY, stored);
    expect(open(device).ids()).toEqual(known);
  });

  it("marks for this visit if the device stores nothing", async () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const { report, ids } = open(device);
    await report("goal");
    expect(ids()).toEqual(["spiral"]);
  });
});
