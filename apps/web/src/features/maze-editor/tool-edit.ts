/**
 * The edits of a tool and their previews, based on the edits of packages/maze. Pure. A square under
 * the robot cannot be filled.
 */
import {
  CELL,
  headingNames,
  isBlock,
  setBlock,
  setStart,
  toggleGoal,
  type Cell,
  type HeadingName,
  type MazeDocument,
  type MazeRefusal,
} from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { EditPreview } from "../../stage/layers/edit-preview.ts";
import { ROBOT_RADIUS } from "@corridor/simulation";
import type { EditTool } from "../../model/screen/screen-store.ts";

export type ToolRefusal =
  | MazeRefusal
  | "robot-here"
  /** an open challenge fixes its maze */
  | "maze-fixed";

export type ToolEdit = { ok: true; maze: MazeDocument } | { ok: false; code: ToolRefusal };

/**
 * Depth in units by which the robot's disc can overlap a wall that it touches, which does not count
 * as standing in the cell.
 */
const CONTACT = 0.01;

/** Whether the robot's disc overlaps a cell. */
export function isRobotOver(pose: Pose | null, cell: Cell): boolean {
  if (pose === null) return false;
  const nearest = (at: number, index: number): number =>
    Math.min(Math.max(at, index * CELL), (index + 1) * CELL);
  const dx = pose.x - nearest(pose.x, cell.column);
  const dy = pose.y - nearest(pose.y, cell.row);
  return dx * dx + dy * dy < (ROBOT_RADIUS - CONTACT) ** 2;
}

/**
 * Fills or opens a cell, unless the robot stands there. On the start, the start is the reported
 * reason.
 */
export function paintBlock(
  maze: MazeDocument,
  cell: Cell,
  filled: boolean,
  pose: Pose | null,
): ToolEdit {
  const edit = setBlock(maze, cell, filled);
  if (edit.ok && filled && isRobotOver(pose, cell)) return { ok: false, code: "robot-here" };
  return edit;
}

/**
 * One press of a tool: adds or removes a block, places or turns the start, adds or removes a goal.
 */
export function pressTool(
  maze: MazeDocument,
  tool: EditTool,
  cell: Cell,
  pose: Pose | null,
): ToolEdit {
  switch (tool) {
    case "blocks":
      return paintBlock(maze, cell, !isBlock(maze, cell.column, cell.row), pose);
    case "start":
      return setStart(maze, cell, headingAfterPress(maze, cell));
    case "goal":
      return toggleGoal(maze, cell);
  }
}

/** A press on the start turns it right. A start that moves retains its heading. */
function headingAfterPress({ start }: MazeDocument, cell: Cell): HeadingName {
  if (start.column !== cell.column || start.row !== cell.row) return start.heading;
  const next = (headingNames.indexOf(start.heading) + 1) % headingNames.length;
  return headingNames[next] ?? "north";
}

/** The result of a press, as a preview. */
export function previewOf(
  maze: MazeDocument,
  tool: EditTool,
  cell: Cell,
  pose: Pose | null,
): EditPreview {
  const edit = pressTool(maze, tool, cell, pose);
  if (!edit.ok) return { kind: "refused", cell };
  switch (tool) {
    case "blocks":
      return { kind: isBlock(maze, cell.column, cell.row) ? "open" : "block", cell };
    case "start":
      return { kind: "start", start: edit.maze.start };
    case "goal":
      return { kind: edit.maze.goals.length > maze.goals.length ? "goal" : "no-goal", cell };
  }
}
