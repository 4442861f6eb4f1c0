import { describe, expect, it } from "vitest";
import { parseProgram, type ProgramDocument } from "./program-document.ts";
import { programPresets, type ProgramPresetId } from "./presets.ts";
import { paperPrograms } from "./testing/paper-programs.ts";

function presetOf(id: ProgramPresetId): ProgramDocument | undefined {
  return programPresets.find((preset) => preset.id === id)?.program;
}

describe("program presets", () => {
  it("have unique ids and names", () => {
    const ids = programPresets.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    expect(new Set(programPresets.map(({ program }) => program.name)).size).toBe(ids.length);
  });

  it.each(programPresets)("$id is a valid program", ({ program }) => {
    expect(parseProgram(program)).toEqual({ ok: true, value: program });
  });

  it.each([
    [19, "back-and-forth"],
    [22, "right-wall"],
    [23, "farthest-distance"],
  ] as const)("Figure %i is %s", (figure, id) => {
    const paper = paperPrograms.find((each) => each.figure === figure)?.program;
    expect(presetOf(id)?.rules).toEqual(paper?.rules);
    expect(presetOf(id)?.default).toBe(paper?.default);
  });

  it("left wall is the mirror image of right wall", () => {
    const text = JSON.stringify(presetOf("right-wall")?.rules);
    const mirrored = text.replaceAll(/left|right/g, (side) => (side === "left" ? "right" : "left"));
    expect(JSON.stringify(presetOf("left-wall")?.rules)).toBe(mirrored);
  });
});
