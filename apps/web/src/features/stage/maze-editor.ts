/**
 * Carries the pointer's and the keyboard's intents into the workspace. One stroke, however many
 * cells it paints, is one step of undo; each reason for a refusal is told once, when the stroke ends,
 * so that a press that becomes a pinch says nothing.
 */
import { isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { Intent } from "../../canvas/pointer-input.ts";
import type { ScreenStore } from "../../stores/screen-store.ts";
import { beginStroke, setMaze, type WorkspaceStore } from "../../stores/workspace-store.ts";
import { paintBlock, pressTool, type ToolEdit, type ToolRefusal } from "./tool-edit.ts";

interface Stroke {
  /** what every cell of a Blocks stroke becomes; null for tools that act once a press */
  filled: boolean | null;
  before: MazeDocument;
  refusals: Set<ToolRefusal>;
  endInHistory: () => void;
}

export interface MazeEditorPort {
  workspace: WorkspaceStore;
  screen: ScreenStore;
  /** where the robot is now; null before the first frame */
  pose: () => Pose | null;
  /** whether an open challenge keeps its maze as it is */
  isFixed: () => boolean;
  /** says in words why nothing happened */
  refuse: (code: ToolRefusal) => void;
  /** says that a stroke of blocks has buried so many goals, once it is over */
  goalsRemoved: (count: number) => void;
}

export class MazeEditor {
  readonly #port: MazeEditorPort;
  #stroke: Stroke | null = null;

  constructor(port: MazeEditorPort) {
    this.#port = port;
  }

  /** Follows the pointer; "hover" changes nothing here. */
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

  /** One press of the tool, from the keyboard. */
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
    // It never changes the maze, whoever presses.
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
