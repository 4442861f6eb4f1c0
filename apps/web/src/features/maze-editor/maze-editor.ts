/**
 * Applies intents of the pointer and the keyboard to the workspace. One stroke is one step of undo,
 * however many cells it paints. Each reason for a refusal is reported once, at the end of the
 * stroke. A press that becomes a pinch therefore reports nothing.
 */
import { isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { Intent } from "../../stage/page/pointer-input.ts";
import type { ScreenStore } from "../../model/screen/screen-store.ts";
import {
  beginStroke,
  setMaze,
  type WorkspaceStore,
} from "../../model/workspace/workspace-store.ts";
import { paintBlock, pressTool, type ToolEdit, type ToolRefusal } from "./tool-edit.ts";

interface Stroke {
  /** the new state of every cell of a Blocks stroke; null for tools that act once per press */
  filled: boolean | null;
  before: MazeDocument;
  refusals: Set<ToolRefusal>;
  endInHistory: () => void;
}

export interface MazeEditorPort {
  workspace: WorkspaceStore;
  screen: ScreenStore;
  /** the current pose of the robot; null before the first frame */
  pose: () => Pose | null;
  /** whether an open challenge fixes its maze */
  isFixed: () => boolean;
  /** reports why nothing changed */
  refuse: (code: ToolRefusal) => void;
  /** reports the number of goals that a finished stroke of blocks has removed */
  goalsRemoved: (count: number) => void;
}

export class MazeEditor {
  readonly #port: MazeEditorPort;
  #stroke: Stroke | null = null;

  constructor(port: MazeEditorPort) {
    this.#port = port;
  }

  /** Applies an intent of the pointer; "hover" changes nothing. */
  follow(intent: Intent): void {
    switch (intent.type) {
      case "hover":
        return;
      case "begin":
        this.#begin(intent.cell);
        return;
      case "paint":
        this.#paint(intent.cells);
        return;
      case "end":
        this.#end();
        return;
      case "cancel":
        this.#cancel();
        return;
    }
  }

  /** One press of the tool, by keyboard. */
  press(cell: Cell): void {
    this.follow({ type: "begin", cell });
    this.follow({ type: "end" });
  }

  #begin(cell: Cell): void {
    const { workspace, screen, pose, isFixed } = this.#port;
    const { maze } = workspace.getState();
    if (isFixed()) {
      const refusals = new Set<ToolRefusal>(["maze-fixed"]);
      this.#stroke = { filled: null, before: maze, refusals, endInHistory: () => undefined };
      return;
    }
    const { tool } = screen.getState();
    // The Measure tool never changes the maze.
    if (tool === "measure") return;
    this.#stroke = {
      filled: tool === "blocks" ? !isBlock(maze, cell.column, cell.row) : null,
      before: maze,
      refusals: new Set(),
      endInHistory: beginStroke(workspace),
    };
    this.#apply(pressTool(maze, tool, cell, pose()));
  }

  #paint(cells: readonly Cell[]): void {
    const filled = this.#stroke?.filled ?? null;
    if (filled === null) return;
    const { workspace, pose } = this.#port;
    for (const cell of cells) {
      this.#apply(paintBlock(workspace.getState().maze, cell, filled, pose()));
    }
  }

  #apply(edit: ToolEdit): void {
    const { workspace } = this.#port;
    if (!edit.ok) this.#stroke?.refusals.add(edit.code);
    else if (edit.maze !== workspace.getState().maze) setMaze(workspace, edit.maze);
  }

  #end(): void {
    const stroke = this.#stroke;
    if (stroke === null) return;
    this.#stroke = null;
    stroke.endInHistory();
    for (const code of stroke.refusals) this.#port.refuse(code);
    if (stroke.filled === null) return;
    const { workspace, goalsRemoved } = this.#port;
    const removed = stroke.before.goals.length - workspace.getState().maze.goals.length;
    if (removed > 0) goalsRemoved(removed);
  }

  #cancel(): void {
    const stroke = this.#stroke;
    if (stroke === null) return;
    if (this.#port.workspace.getState().maze !== stroke.before) {
      setMaze(this.#port.workspace, stroke.before);
    }
    stroke.endInHistory();
    this.#stroke = null;
  }
}
