import { conditionKinds, programPresets, type ProgramDocument } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { createWorkspaceStore, redo, setMaze, undo } from "./workspace-store.ts";
import {
  addLine,
  chooseCondition,
  deleteLine,
  loadProgram,
  moveLine,
  type RememberedNumbers,
} from "./program-actions.ts";

const three: ProgramDocument = {
  ...firstProgram,
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 70 }, do: "left 90" },
    { when: null, do: "reverse" },
  ],
};
const setUp = (program = three) => createWorkspaceStore(firstMaze, program);
const kind = (sensor: string, than: string) =>
  conditionKinds.find((each) => each.sensor === sensor && each.than === than) ?? null;

describe("lines of the program", () => {
  it("start as [Do nothing], forward, at the end, with an id of their own", () => {
    const workspace = setUp();
    const id = addLine(workspace);
    const { program, lineIds } = workspace.getState();
    expect(program.rules.at(-1)).toEqual({ when: null, do: "forward" });
    expect(lineIds.at(-1)).toBe(id);
    expect(new Set(lineIds).size).toBe(4);
  });

  it("are not added to a full program", () => {
    const rules = Array.from({ length: 200 }, () => ({ when: null, do: "forward" as const }));
    const workspace = setUp({ ...three, rules });
    expect(addLine(workspace)).toBeNull();
    expect(workspace.getState().program.rules).toHaveLength(200);
  });

  it("take their id along when they move, so that the focus can follow", () => {
    const workspace = setUp();
    const [first, second, third] = workspace.getState().lineIds;
    moveLine(workspace, 0, 1);
    expect(workspace.getState().lineIds).toEqual([second, first, third]);
    expect(workspace.getState().program.rules[1]).toBe(three.rules[0]);
  });

  it("stay where they are at the ends, without a step in the history", () => {
    const workspace = setUp();
    moveLine(workspace, 0, -1);
    moveLine(workspace, 2, 1);
    expect(workspace.getState().program).toBe(three);
    expect(workspace.temporal.getState().pastStates).toHaveLength(0);
  });
});

describe("deleting a line", () => {
  it("returns by undo if nothing else was edited", () => {
    const workspace = setUp();
    const bringBack = deleteLine(workspace, 1);
    expect(workspace.getState().program.rules).toHaveLength(2);
    bringBack();
    expect(workspace.getState().program).toBe(three);
    redo(workspace);
    expect(workspace.getState().program.rules).toHaveLength(2);
  });

  it("returns into a program that was edited since, without a loss of that edit", () => {
    const workspace = setUp();
    const ids = workspace.getState().lineIds;
    const bringBack = deleteLine(workspace, 1);
    addLine(workspace);
    bringBack();
    expect(workspace.getState().program.rules.slice(0, 3)).toEqual(three.rules);
    expect(workspace.getState().program.rules).toHaveLength(4);
    expect(workspace.getState().lineIds.slice(0, 3)).toEqual(ids);
  });

  it("does not change a later edit of the maze", () => {
    const workspace = setUp();
    const bringBack = deleteLine(workspace, 0);
    setMaze(workspace, { ...firstMaze, name: "Other" });
    bringBack();
    expect(workspace.getState().maze.name).toBe("Other");
    expect(workspace.getState().program.rules).toEqual(three.rules);
  });

  it("does not return beyond the limit of a task, and reports that", () => {
    const workspace = setUp();
    const bringBack = deleteLine(workspace, 1);
    addLine(workspace);
    expect(bringBack(3)).toBe(false);
    expect(workspace.getState().program.rules).toHaveLength(3);
    expect(bringBack(4)).toBe(true);
    expect(workspace.getState().program.rules).toHaveLength(4);
    expect(bringBack(4)).toBe(true);
  });

  it("does not return twice", () => {
    const workspace = setUp();
    const bringBack = deleteLine(workspace, 1);
    bringBack();
    bringBack();
    expect(workspace.getState().program.rules).toHaveLength(3);
  });
});

describe("choosing a condition", () => {
  it("starts with 50 on a line that did nothing", () => {
    const workspace = setUp();
    chooseCondition(workspace, 2, kind("front", "number"), new Map());
    expect(workspace.getState().program.rules[2]?.when).toMatchObject({ than: 50 });
  });

  it("remembers the number of a line that was switched off, in one step of the history", () => {
    const workspace = setUp();
    const remembered: RememberedNumbers = new Map();
    chooseCondition(workspace, 1, null, remembered);
    chooseCondition(workspace, 1, kind("left", "number"), remembered);
    expect(workspace.getState().program.rules[1]?.when).toMatchObject({ sensor: "left", than: 70 });
    undo(workspace);
    expect(workspace.getState().program.rules[1]?.when).toBeNull();
  });

  it("remembers by line, wherever the line has moved", () => {
    const workspace = setUp();
    const remembered: RememberedNumbers = new Map();
    chooseCondition(workspace, 1, null, remembered);
    moveLine(workspace, 1, -1);
    chooseCondition(workspace, 0, kind("left", "number"), remembered);
    expect(workspace.getState().program.rules[0]?.when).toMatchObject({ than: 70 });
  });

  it("falls back to 50 where the remembered number is not allowed", () => {
    const workspace = setUp();
    const remembered: RememberedNumbers = new Map([[workspace.getState().lineIds[2] ?? 0, -5]]);
    chooseCondition(workspace, 2, kind("front", "number"), remembered);
    expect(workspace.getState().program.rules[2]?.when).toMatchObject({ than: 50 });
  });
});

describe("undo", () => {
  it("gives back the identical program after any edits, with an id for every line all along", () => {
    const edit = fc.record({
      what: fc.constantFrom("add", "up", "down", "delete", "choose", "load"),
      index: fc.nat(4),
      choice: fc.nat(conditionKinds.length),
    });
    fc.assert(
      fc.property(fc.array(edit, { maxLength: 20 }), (edits) => {
        const workspace = setUp();
        const remembered: RememberedNumbers = new Map();
        for (const { what, index, choice } of edits) {
          if (what === "add") addLine(workspace);
          if (what === "up") moveLine(workspace, index, -1);
          if (what === "down") moveLine(workspace, index, 1);
          if (what === "delete") deleteLine(workspace, index);
          if (what === "choose") {
            chooseCondition(workspace, index, conditionKinds[choice] ?? null, remembered);
          }
          if (what === "load") {
            const preset = programPresets[choice % programPresets.length];
            if (preset !== undefined) loadProgram(workspace, preset.program);
          }
          const { program, lineIds } = workspace.getState();
          expect(new Set(lineIds).size).toBe(program.rules.length);
        }
        while (workspace.temporal.getState().pastStates.length > 0) undo(workspace);
        expect(workspace.getState().program).toBe(three);
      }),
    );
  });
});
