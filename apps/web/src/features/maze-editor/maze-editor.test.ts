import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { firstProgram } from "../../simulator/protocol/first-project.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore, redo, undo } from "../../model/workspace/workspace-store.ts";
import { MazeEditor } from "./maze-editor.ts";
import type { ToolRefusal } from "./tool-edit.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["....", "...."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};
const at = (column: number, row: number) => ({ column, row });

function newEditor({ isFixed = false } = {}) {
  const workspace = createWorkspaceStore(maze, firstProgram);
  const screen = createScreenStore();
  const refusals: ToolRefusal[] = [];
  const goalsRemoved: number[] = [];
  const editor = new MazeEditor({
    workspace,
    screen,
    pose: () => ({ x: 50, y: 150, heading: 0 }),
    isFixed: () => isFixed,
    refuse: (code) => refusals.push(code),
    goalsRemoved: (count) => goalsRemoved.push(count),
  });
  const blocks = () => workspace.getState().maze.blocks;
  return { workspace, screen, refusals, goalsRemoved, editor, blocks };
}

it("of an unchanged maze reports so once per press, and changes nothing", () => {
  const { workspace, editor, refusals } = newEditor({ isFixed: true });
  editor.follow({ type: "begin", cell: at(2, 0) });
  editor.follow({ type: "paint", cells: [at(3, 0)] });
  editor.follow({ type: "end" });
  expect(refusals).toEqual(["maze-fixed"]);
  expect(workspace.getState().maze).toBe(maze);
  expect(workspace.temporal.getState().pastStates).toEqual([]);
});

it.each([
  { name: "in a maze that stays as it is", isFixed: true, cell: at(2, 0) },
  { name: "on the square of the robot", isFixed: false, cell: at(0, 1) },
])("reports nothing about a press that becomes a pinch, $name", ({ isFixed, cell }) => {
  const { editor, refusals } = newEditor({ isFixed });
  editor.follow({ type: "begin", cell });
  editor.follow({ type: "cancel" });
  expect(refusals).toEqual([]);
  editor.press(cell);
  expect(refusals).toHaveLength(1);
});

describe("a stroke of blocks", () => {
  it("is one step of undo and of redo, however many squares it fills", () => {
    const { workspace, editor, blocks } = newEditor();
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "paint", cells: [at(2, 0), at(3, 0)] });
    editor.follow({ type: "paint", cells: [at(3, 1)] });
    editor.follow({ type: "end" });
    expect(blocks()).toEqual([".###", "...#"]);
    undo(workspace);
    expect(workspace.getState().maze).toBe(maze);
    redo(workspace);
    expect(blocks()).toEqual([".###", "...#"]);
  });

  it("does the same to every square: one that began with a block only opens", () => {
    const { editor, blocks } = newEditor();
    editor.press(at(1, 1));
    editor.follow({ type: "begin", cell: at(1, 1) });
    editor.follow({ type: "paint", cells: [at(2, 1), at(3, 1)] });
    editor.follow({ type: "end" });
    expect(blocks()).toEqual(["....", "...."]);
  });

  it("reports once why squares are omitted, and fills the others", () => {
    const { editor, blocks, refusals } = newEditor();
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "paint", cells: [at(0, 1), at(0, 0), at(0, 1), at(1, 1)] });
    editor.follow({ type: "end" });
    expect(blocks()).toEqual([".#..", ".#.."]);
    expect(refusals).toEqual(["robot-here", "start-here"]);
  });

  it("that is cancelled leaves neither blocks nor an undo step", () => {
    const { workspace, editor } = newEditor();
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "paint", cells: [at(2, 0)] });
    editor.follow({ type: "cancel" });
    expect(workspace.getState().maze).toBe(maze);
    expect(workspace.temporal.getState().pastStates).toHaveLength(0);
  });

  it("reports once, at its end, how many goals it has removed", () => {
    const { workspace, editor, goalsRemoved } = newEditor();
    workspace.setState({ maze: { ...maze, goals: [at(1, 0), at(2, 0), at(3, 0)] } });
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "paint", cells: [at(2, 0)] });
    expect(goalsRemoved).toEqual([]);
    editor.follow({ type: "end" });
    expect(goalsRemoved).toEqual([2]);
  });

  it("does not report goals that the Goal tool removes or restores", () => {
    const { workspace, screen, editor, goalsRemoved } = newEditor();
    workspace.setState({ maze: { ...maze, goals: [at(1, 0), at(2, 0)] } });
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "cancel" });
    screen.setState({ tool: "goal" });
    editor.press(at(2, 0));
    expect(workspace.getState().maze.goals).toEqual([at(1, 0)]);
    expect(goalsRemoved).toEqual([]);
  });

  it("that changes nothing is no step of undo", () => {
    const { workspace, editor } = newEditor();
    editor.press(at(0, 1));
    expect(workspace.temporal.getState().pastStates).toHaveLength(0);
  });
});

describe("start and goal", () => {
  it("act on the pressed square only, not on those that the pointer drags over", () => {
    const { workspace, screen, editor } = newEditor();
    screen.setState({ tool: "goal" });
    editor.follow({ type: "begin", cell: at(1, 0) });
    editor.follow({ type: "paint", cells: [at(2, 0), at(3, 0)] });
    editor.follow({ type: "end" });
    expect(workspace.getState().maze.goals).toEqual([at(1, 0)]);
  });

  it("turns the start by a press on it", () => {
    const { workspace, screen, editor } = newEditor();
    screen.setState({ tool: "start" });
    editor.press(at(0, 0));
    expect(workspace.getState().maze.start.heading).toBe("south");
  });
});
