/**
 * Which ready-made mazes were solved on this device, by hand or by a program. A maze counts as it was
 * given: with a block taken out or the start moved it is another one.
 */
import { mazePresets, type MazeDocument, type MazePresetId } from "@corridor/maze";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { KeyValueStorage } from "../../app/works.ts";
import type { RunStore } from "../../stores/run-store.ts";
import type { WorkspaceStore } from "../../stores/workspace-store.ts";

export type SolvedStore = StoreApi<{ ids: readonly MazePresetId[] }>;

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
  run.subscribe(({ moment }, before) => {
    if (moment === before.moment || moment?.kind !== "goal" || moment.driver === "remote") return;
    const { maze } = workspace.getState();
    const preset = mazePresets.find((each) => isSame(each.maze, maze));
    if (preset === undefined || solved.getState().ids.includes(preset.id)) return;
    // Another tab may have added one since.
    const ids = [...new Set([...solved.getState().ids, ...read(device), preset.id])];
    solved.setState({ ids });
    try {
      device.setItem(KEY, JSON.stringify(ids));
    } catch {
      // A full or forbidden storage is told by the autosave; the mark lasts as long as the page.
    }
  });
  return solved;
}

/** A name that this Corridor does not know is of no use here, and is not worth a message. */
function read(device: KeyValueStorage): MazePresetId[] {
  let stored: unknown;
  try {
    stored = JSON.parse(device.getItem(KEY) ?? "[]");
  } catch {
    return [];
  }
  const names: unknown[] = Array.isArray(stored) ? stored : [];
  return mazePresets.map(({ id }) => id).filter((id) => names.includes(id));
}

/** Names may be in another language. */
function isSame(preset: MazeDocument, maze: MazeDocument): boolean {
  return (
    preset.blocks.join() === maze.blocks.join() &&
    preset.start.column === maze.start.column &&
    preset.start.row === maze.start.row &&
    JSON.stringify(preset.goals) === JSON.stringify(maze.goals)
  );
}
