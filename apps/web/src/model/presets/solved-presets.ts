/**
 * Which presets were solved on this device, by hand or by a program. With a block removed or the
 * start moved, a maze is no longer the preset.
 */
import { createStore } from "zustand/vanilla";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import type { RunStore } from "../run/run-store.ts";
import type { noteGoal } from "./note-goal.ts";
import { readSolved, type SolvedStore } from "./solved-storage.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";

const LOADED_FROM_TICK = 120;

export interface SolvedPorts {
  run: RunStore;
  workspace: WorkspaceStore;
  /** localStorage */
  device: KeyValueStorage;
}

/**
 * Reads the stored ids, and adds a preset when Me or a program reaches its goal. See `note-goal.ts`.
 */
export function createSolvedStore({ run, workspace, device }: SolvedPorts): SolvedStore {
  const solved: SolvedStore = createStore(() => ({ ids: readSolved(device) }));
  let loading: Promise<{ noteGoal: typeof noteGoal } | null> | null = null;
  run.subscribe(({ event, nowTick }, before) => {
    const isGoal = event !== before.event && event?.kind === "goal" && event.driver !== "remote";
    // Before the goal, where the user may close the page, but after the first screen.
    if (isGoal || nowTick > LOADED_FROM_TICK) {
      loading ??= import("./note-goal.ts").catch(() => null);
    }
    if (!isGoal) return;
    const { maze } = workspace.getState();
    const { tick, bumps } = event;
    void loading?.then((loaded) => loaded?.noteGoal(device, solved, maze, { ticks: tick, bumps }));
  });
  return solved;
}
