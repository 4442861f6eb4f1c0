import { applyFix, type Fix } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { createWorkspaceStore, undo } from "./workspace-store.ts";
import { setFixedProgram } from "./set-fixed-program.ts";

const three: ProgramDocument = {
  ...firstProgram,
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 70 }, do: "left 90" },
    { when: null, do: "reverse" },
  ],
};
const condition = { sensor: "left", is: ">", than: 60 } as const;

describe("an applied fix", () => {
  it.each<[Fix, (string | null)[]]>([
    [{ kind: "action", line: 1, action: "right 90" }, ["a", "b", "c"]],
    [{ kind: "number", line: 1, number: 50 }, ["a", "b", "c"]],
    [{ kind: "condition", line: 1, when: condition }, ["a", "b", "c"]],
    [{ kind: "move", line: 2, to: 0 }, ["c", "a", "b"]],
    [{ kind: "move", line: 0, to: 1 }, ["b", "a", "c"]],
    [{ kind: "delete", line: 1 }, ["a", "c"]],
    [{ kind: "insert", at: 1, rule: { when: condition, do: "stop" } }, ["a", null, "b", "c"]],
  ])("%j leaves every line its id, and one undo takes it back", (fix, order) => {
    const workspace = createWorkspaceStore(firstMaze, three);
    const [a, b, c] = workspace.getState().lineIds;
    const names = new Map([
      [a, "a"],
      [b, "b"],
      [c, "c"],
    ]);
    const fixed = applyFix(three, fix);
    setFixedProgram(workspace, fix, fixed);
    const { program, lineIds } = workspace.getState();
    expect(program).toBe(fixed);
    expect(lineIds.map((id) => names.get(id) ?? null)).toEqual(order);
    // Each id stays with its rule, except for the rule that the fix changed.
    expect(lineIds).toHaveLength(program.rules.length);
    undo(workspace);
    expect(workspace.getState().program).toBe(three);
    expect(workspace.getState().lineIds).toEqual([a, b, c]);
  });
});
