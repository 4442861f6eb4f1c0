import type { PlainAction } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ProgramDocument, Rule } from "../program-document.ts";
import { paperPrograms } from "../testing/paper-programs.ts";
import { scriptLines } from "./script-lines.ts";

function programOf(rules: Rule[], otherwise: PlainAction = "forward"): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: otherwise, rules };
}

function untilOf(program: ProgramDocument, line: number | "default") {
  const script = scriptLines(program);
  return script.ok && script.lines.find((each) => each.line === line)?.until;
}

const NEAR = { sensor: "front", is: "<", than: 50 } as const;
const OPEN = { sensor: "right", is: ">", than: 60 } as const;
const WIDER = { sensor: "left", is: ">", than: "right", plus: 1 } as const;

describe("scriptLines", () => {
  it("ends the forward of Figure 22 where a line above decides", () => {
    const figure22 = paperPrograms.find(({ figure }) => figure === 22)?.program ?? programOf([]);
    const script = scriptLines(figure22);
    expect(script.ok && script.lines.map(({ line, action }) => [line, action])).toEqual([
      [0, "delayed right 90"],
      [1, "left 90"],
      ["default", "forward"],
    ]);
    expect(untilOf(figure22, "default")).toEqual(figure22.rules.map(({ when }) => when));
  });

  it("ends the motion of a line also where its own condition is no longer true", () => {
    const program = programOf([
      { when: NEAR, do: "forward" },
      { when: OPEN, do: "reverse" },
      { when: WIDER, do: "forward" },
    ]);
    // At the limit itself the line is not true.
    expect(untilOf(program, 0)).toEqual([{ ...NEAR, is: ">=" }]);
    expect(untilOf(program, 1)).toEqual([NEAR, { ...OPEN, is: "<=" }]);
    expect(untilOf(program, 2)).toEqual([OPEN, { ...WIDER, is: "<=" }]);
  });

  it("continues a motion through lines above with the same action", () => {
    const program = programOf([
      { when: NEAR, do: "forward" },
      { when: OPEN, do: "left 90" },
    ]);
    expect(untilOf(program, "default")).toEqual([OPEN]);
  });

  it("lets manoeuvres end by themselves", () => {
    const program = programOf([{ when: NEAR, do: "delayed left 90" }], "turn 180");
    expect(untilOf(program, 0)).toBeNull();
    expect(untilOf(program, "default")).toBeNull();
  });

  it("skips lines without a condition, and retains the numbers of the others", () => {
    const script = scriptLines(
      programOf([
        { when: null, do: "stop" },
        { when: NEAR, do: "left 90" },
      ]),
    );
    expect(script.ok && script.lines.map(({ line }) => line)).toEqual([1, "default"]);
  });

  it("refuses a program of which a motion needs more than 200 conditions", () => {
    const rule: Rule = { when: NEAR, do: "left 90" };
    expect(untilOf(programOf(Array(199).fill(rule)), "default")).toHaveLength(199);
    expect(scriptLines(programOf(Array(200).fill(rule)))).toEqual({
      ok: false,
      line: "default",
      conditions: 201,
    });
    // A manoeuvre needs none.
    expect(scriptLines(programOf(Array(200).fill(rule), "right 90")).ok).toBe(true);
  });
});
