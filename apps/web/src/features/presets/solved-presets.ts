/**
 * Which ready-made mazes were solved on this device, by hand or by a program. A maze counts as it was
 * given: with a block taken out or the start moved it is another one.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import type { KeyValueStorage } from "../../app/project-storage.ts";
import type { RunStore } from "../../stores/run-store.ts";
import type { WorkspaceStore } from "../../stores/workspace-store.ts";

/** ids as they are stored; those of a later Corridor are kept as they are */
export type SolvedStore = StoreApi<{ ids: readonly string[] }>;

const KEY = "corridor.solved";

export interface SolvedPorts {
  run: RunStore;
  workspace: WorkspaceStore;
  /** localStorage */
  device: KeyValueStorage;
}

/** Reads what the device remembers, and adds to it whenever the goal is reached. */
export function createSolvedStore({ run, workspace, device }: SolvedPorts): SolvedStore {
  const solved: SolvedStore = createStore(() => ({ ids: read(device) }));
  run.subscribe(({ event }, before) => {
    if (event === before.event || event?.kind !== "goal" || event.driver === "remote") return;
    const { maze } = workspace.getState();
    const { tick, bumps } = event;
    void import("../daily/daily-best.ts").then(
      ({ noteDaily, utcDay }) =>
        noteDaily(device, maze, { ticks: tick, bumps }, utcDay(new Date())),
      () => undefined,
    );
    // The ready-made mazes are no part of the first screen.
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
    // Another tab may have added one since.
    const ids = [...new Set([...solved.getState().ids, ...read(device), id])];
    solved.setState({ ids });
    try {
      device.setItem(KEY, JSON.stringify(ids));
    } catch {
      // A full or forbidden storage is told by the autosave; the mark lasts as long as the page.
    }
  }
  return solved;
}

/** What cannot be read is of no use here, and is not worth a message. */
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
