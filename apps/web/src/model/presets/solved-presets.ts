/**
 * Which presets were solved on this device, by hand or by a program. With a block removed or the
 * start moved, a maze is no longer the preset.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import type { RunStore } from "../run/run-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";

/** stored ids; those of a later version of Corridor are retained */
export type SolvedStore = StoreApi<{ ids: readonly string[] }>;

const KEY = "corridor.solved";

export interface SolvedPorts {
  run: RunStore;
  workspace: WorkspaceStore;
  /** localStorage */
  device: KeyValueStorage;
}

/**
 * Reads the stored ids, and adds a preset when Me or a program reaches its goal. Also stores the
 * best runs in daily mazes.
 */
export function createSolvedStore({ run, workspace, device }: SolvedPorts): SolvedStore {
  const solved: SolvedStore = createStore(() => ({ ids: read(device) }));
  run.subscribe(({ event }, before) => {
    if (event === before.event || event?.kind !== "goal" || event.driver === "remote") return;
    const { maze } = workspace.getState();
    const { tick, bumps } = event;
    void import("./daily-best.ts").then(
      ({ noteDaily, utcDay }) =>
        noteDaily(device, maze, { ticks: tick, bumps }, utcDay(new Date())),
      () => undefined,
    );
    // The presets are not part of the first screen.
    void import("./preset-of.ts").then(
      ({ presetOf }) => {
        const id = presetOf(maze);
        if (id !== null) add(id);
      },
      () => undefined,
    );
  });

  function add(id: string): void {
    if (solved.getState().ids.includes(id)) return;
    // Another tab may have added an id since.
    const ids = [...new Set([...solved.getState().ids, ...read(device), id])];
    solved.setState({ ids });
    try {
      device.setItem(KEY, JSON.stringify(ids));
    } catch {
      // The autosave reports a full or forbidden storage. The mark lasts as long as the page.
    }
  }
  return solved;
}

/** An entry that cannot be read counts as none. */
function read(device: KeyValueStorage): string[] {
  let stored: unknown;
  try {
    stored = JSON.parse(device.getItem(KEY) ?? "[]");
  } catch {
    return [];
  }
  const names: unknown[] = Array.isArray(stored) ? stored : [];
  return names.filter((name) => typeof name === "string");
}
