import type { EditKind } from "@corridor/challenge";
import type { Fix } from "@corridor/coach";
import { conditionKinds, menuActions } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { allowsFix } from "./fix-rights.ts";

const all = {
  maxLines: 3,
  conditions: conditionKinds,
  actions: menuActions,
  edits: new Set<EditKind>(["condition", "number", "action", "otherwise", "order", "lines"]),
};
const front = { sensor: "front", is: "<", than: 50 } as const;
const fixes: Record<Fix["kind"], Fix> = {
  action: { kind: "action", line: 0, action: "left 90" },
  number: { kind: "number", line: 0, number: 50 },
  condition: { kind: "condition", line: 0, when: front },
  move: { kind: "move", line: 1, to: 0 },
  delete: { kind: "delete", line: 0 },
  insert: { kind: "insert", at: 0, rule: { when: front, do: "left 90" } },
};
const kinds = Object.values(fixes);

describe("a fix", () => {
  it.each(kinds)(
    "that is a $kind is offered where there is no challenge, or all is allowed",
    (fix) => {
      expect(allowsFix(fix, 1, null)).toBe(true);
      expect(allowsFix(fix, 1, all)).toBe(true);
    },
  );

  it.each([
    ["action", "action"],
    ["number", "number"],
    ["condition", "condition"],
    ["condition", "number"],
    ["move", "order"],
    ["delete", "lines"],
    ["insert", "lines"],
  ] as const)("that is a %s is not offered where the challenge keeps the %s", (kind, edit) => {
    const edits = new Set(all.edits);
    edits.delete(edit);
    expect(allowsFix(fixes[kind], 1, { ...all, edits })).toBe(false);
  });

  it.each(["action", "insert"] as const)("that is a %s does only what is allowed", (kind) => {
    expect(allowsFix(fixes[kind], 1, { ...all, actions: ["forward"] })).toBe(false);
  });

  it.each(["condition", "insert"] as const)("that is a %s asks only what is allowed", (kind) => {
    expect(allowsFix(fixes[kind], 1, { ...all, conditions: [] })).toBe(false);
  });

  it("adds no line to a program that has as many as are allowed", () => {
    expect(allowsFix(fixes.insert, 3, all)).toBe(false);
  });
});
