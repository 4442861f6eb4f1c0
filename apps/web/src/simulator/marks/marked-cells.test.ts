import type { CellMark } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { MarkedCells } from "./marked-cells.ts";

function cell(column: number, change: Partial<CellMark> = {}): CellMark {
  return { column, row: 1, text: "", color: null, walls: "", ...change };
}

function marked(fresh: boolean, ...cells: CellMark[]) {
  return { fresh, pitch: 1 as const, cells };
}

describe("marks of scripts", () => {
  it("replace those of the same cell, and an empty mark removes them", () => {
    const marks = new MarkedCells();
    marks.add(marked(true, cell(1, { text: "1" }), cell(2, { color: "red" })));
    const before = marks.shown;
    marks.add(marked(false, cell(1, { walls: "n" }), cell(2)));
    expect(marks.shown).toEqual([cell(1, { walls: "n" })]);
    // The stage draws another list.
    expect(marks.shown).not.toBe(before);
  });

  it("end with a fresh message", () => {
    const marks = new MarkedCells();
    marks.add(marked(true, cell(1, { text: "1" })));
    marks.add(marked(true));
    expect(marks.shown).toEqual([]);
  });

  it("are hidden by the switch, and shown again with what has changed", () => {
    const marks = new MarkedCells();
    marks.hide(true);
    marks.add(marked(true, cell(1, { text: "1" })));
    expect(marks.shown).toEqual([]);
    marks.hide(false);
    expect(marks.shown).toHaveLength(1);
  });
});
