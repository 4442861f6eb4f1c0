import { resize, setBlock, setStart, toggleGoal, type MazeEdit } from "@corridor/maze";
import { addRule, moveRule, removeRule, setAction, type ProgramEdit } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import {
  beginStroke,
  createWorkspaceStore,
  openProject,
  redo,
  setMaze,
  setProgram,
  undo,
  type WorkspaceStore,
} from "./workspace-store.ts";

type Edit = (store: WorkspaceStore) => void;

const small = fc.nat({ max: 8 });
const cell = fc.record({ column: small, row: small });

function onMaze(edit: (store: WorkspaceStore) => MazeEdit): Edit {
  return (store) => {
    const result = edit(store);
    if (result.ok) setMaze(store, result.maze);
  };
}

function onProgram(edit: (store: WorkspaceStore) => ProgramEdit): Edit {
  return (store) => {
    const result = edit(store);
    if (result.ok) setProgram(store, result.program);
  };
}

const anyEdit: fc.Arbitrary<Edit> = fc.oneof(
  fc
    .tuple(cell, fc.boolean())
    .map(([at, filled]) => onMaze((store) => setBlock(store.getState().maze, at, filled))),
  cell.map((at) => onMaze((store) => setStart(store.getState().maze, at, "south"))),
  cell.map((at) => onMaze((store) => toggleGoal(store.getState().maze, at))),
  fc
    .tuple(small, small)
    .map(([c, r]) => onMaze((store) => resize(store.getState().maze, c + 1, r + 1))),
  fc.constant(onProgram((store) => addRule(store.getState().program))),
  small.map((at) => onProgram((store) => removeRule(store.getState().program, at))),
  small.map((at) => onProgram((store) => moveRule(store.getState().program, at, 1))),
  small.map((at) => onProgram((store) => setAction(store.getState().program, at, "reverse"))),
);

function documents(store: WorkspaceStore) {
  const { maze, program } = store.getState();
  return structuredClone({ maze, program });
}

describe("undo", () => {
  it("after any edits restores each document as it was, and redo each as it became", () => {
    fc.assert(
      fc.property(fc.array(anyEdit, { maxLength: 25 }), (edits) => {
        const store = createWorkspaceStore(firstMaze, firstProgram);
        const seen = [documents(store)];
        for (const edit of edits) {
          const before = store.getState();
          edit(store);
          const after = store.getState();
          if (before.maze !== after.maze || before.program !== after.program) {
            seen.push(documents(store));
          }
        }
        for (const expected of seen.slice(0, -1).toReversed()) {
          undo(store);
          expect(documents(store)).toEqual(expected);
        }
        for (const expected of seen.slice(1)) {
          redo(store);
          expect(documents(store)).toEqual(expected);
        }
        const { lineIds, program } = store.getState();
        expect(new Set(lineIds).size).toBe(program.rules.length);
      }),
    );
  });

  it("undoes a whole stroke over many cells at once", () => {
    const store = createWorkspaceStore(firstMaze, firstProgram);
    const endStroke = beginStroke(store);
    for (const column of [5, 6, 7]) {
      onMaze(() => setBlock(store.getState().maze, { column, row: 6 }, true))(store);
    }
    endStroke();
    expect(store.getState().maze).not.toEqual(firstMaze);
    undo(store);
    expect(store.getState().maze).toEqual(firstMaze);
    redo(store);
    expect(store.getState().maze.blocks[6]).not.toBe(firstMaze.blocks[6]);
  });

  // A press on the stage comes before the blur of a field, a tap of a finger is over before it.
  it.each([{ isTap: false }, { isTap: true }])(
    "undoes a stroke that began before the one before it had ended, %o",
    ({ isTap }) => {
      const store = createWorkspaceStore(firstMaze, firstProgram);
      const renamed = { ...firstProgram, name: "Renamed" };
      const draw = (column: number) =>
        onMaze(() => setBlock(store.getState().maze, { column, row: 6 }, true))(store);
      const endField = beginStroke(store);
      store.setState({ program: renamed });
      const endDrag = beginStroke(store);
      draw(5);
      if (!isTap) endField();
      draw(6);
      endDrag();
      endField();
      undo(store);
      expect(documents(store)).toEqual({ maze: firstMaze, program: renamed });
      undo(store);
      expect(documents(store)).toEqual({ maze: firstMaze, program: firstProgram });
    },
  );

  it("does not go back beyond the opening of another project", () => {
    const store = createWorkspaceStore(firstMaze, firstProgram);
    const other = { ...firstMaze, name: "Other" };
    openProject(store, other, firstProgram);
    undo(store);
    expect(store.getState().maze.name).toBe("Other");
  });

  it("nor if the other project was opened during a stroke", () => {
    const store = createWorkspaceStore(firstMaze, firstProgram);
    const endStroke = beginStroke(store);
    onMaze(() => setBlock(store.getState().maze, { column: 5, row: 6 }, true))(store);
    openProject(store, { ...firstMaze, name: "Other" }, firstProgram);
    endStroke();
    undo(store);
    expect(store.getState().maze.name).toBe("Other");
  });
});
