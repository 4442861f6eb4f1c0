import { parseMaze, type Cell, type MazeDocument } from "@corridor/maze";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { tools } from "../../model/screen/screen-store.ts";
import { previewOf, isRobotOver, pressTool } from "./tool-edit.ts";

const editTools = tools.filter((tool) => tool !== "measure");

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["....", ".##.", "...."],
  start: { column: 0, row: 0, heading: "west" },
  goals: [{ column: 3, row: 2 }],
};
const away = { x: 350, y: 50, heading: 0 };
const at = (column: number, row: number): Cell => ({ column, row });

describe("isRobotOver", () => {
  it.each([
    { name: "its own square", pose: { x: 150, y: 150 }, cell: at(1, 1), isOver: true },
    { name: "a wall that it touches", pose: { x: 125, y: 150 }, cell: at(0, 1), isOver: false },
    { name: "a square that it leans into", pose: { x: 124, y: 150 }, cell: at(0, 1), isOver: true },
    { name: "a corner that it passes by", pose: { x: 118, y: 118 }, cell: at(0, 0), isOver: false },
    { name: "a corner that it covers", pose: { x: 117, y: 117 }, cell: at(0, 0), isOver: true },
  ])("sees the robot on $name: $isOver", ({ pose, cell, isOver }) => {
    expect(isRobotOver({ ...pose, heading: 0 }, cell)).toBe(isOver);
  });
});

describe("a press", () => {
  it("of Blocks fills an open square and opens a filled one", () => {
    const filled = pressTool(maze, "blocks", at(2, 0), away);
    expect(filled).toMatchObject({ ok: true, maze: { blocks: ["..#.", ".##.", "...."] } });
    const opened = pressTool(maze, "blocks", at(1, 1), away);
    expect(opened).toMatchObject({ ok: true, maze: { blocks: ["....", "..#.", "...."] } });
  });

  it("of Blocks does not bury the robot, but frees a square under it", () => {
    const here = { x: 150, y: 150, heading: 0 };
    expect(pressTool(maze, "blocks", at(1, 0), { ...here, y: 120 })).toEqual({
      ok: false,
      code: "robot-here",
    });
    expect(pressTool(maze, "blocks", at(1, 1), here).ok).toBe(true);
  });

  it("of Blocks on the start names the start, though the robot stands there too", () => {
    const edit = pressTool(maze, "blocks", at(0, 0), { x: 50, y: 50, heading: 0 });
    expect(edit).toEqual({ ok: false, code: "start-here" });
  });

  it("of Start moves it with its heading, and turns it right where it is already", () => {
    expect(pressTool(maze, "start", at(1, 0), null)).toMatchObject({
      maze: { start: { column: 1, row: 0, heading: "west" } },
    });
    expect(pressTool(maze, "start", at(0, 0), null)).toMatchObject({
      maze: { start: { column: 0, row: 0, heading: "north" } },
    });
  });

  it("of Goal adds a goal and takes it away", () => {
    const added = pressTool(maze, "goal", at(1, 0), null);
    expect(added).toMatchObject({ maze: { goals: [at(3, 2), at(1, 0)] } });
    expect(pressTool(maze, "goal", at(3, 2), null)).toMatchObject({ maze: { goals: [] } });
  });

  it("leaves a legal maze or refuses, whatever is pressed", () => {
    const cells = fc.record({ column: fc.nat(4), row: fc.nat(3) });
    const presses = fc.array(fc.record({ tool: fc.constantFrom(...editTools), cell: cells }));
    fc.assert(
      fc.property(presses, (all) => {
        let document = maze;
        for (const { tool, cell } of all) {
          const edit = pressTool(document, tool, cell, away);
          if (edit.ok) document = edit.maze;
        }
        expect(parseMaze(document).ok).toBe(true);
      }),
    );
  });
});

describe("the preview", () => {
  it.each([
    { tool: "blocks", cell: at(2, 0), kind: "block" },
    { tool: "blocks", cell: at(1, 1), kind: "open" },
    { tool: "blocks", cell: at(0, 0), kind: "refused" },
    { tool: "blocks", cell: at(3, 0), kind: "refused" },
    { tool: "start", cell: at(2, 0), kind: "start" },
    { tool: "start", cell: at(1, 1), kind: "refused" },
    { tool: "goal", cell: at(2, 0), kind: "goal" },
    { tool: "goal", cell: at(3, 2), kind: "no-goal" },
  ] as const)("of $tool on $cell.column, $cell.row is $kind", ({ tool, cell, kind }) => {
    expect(previewOf(maze, tool, cell, away).kind).toBe(kind);
  });
});
