import type { CellMark } from "@corridor/protocol";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { MarkedCells } from "./marked-cells.ts";

function cell(column: number, change: Partial<CellMark> = {}): CellMark {
  return { column, row: 1, text: "", color: null, walls: "", ...change };
}

function marked(fresh: boolean, ...cells: CellMark[]) {
  return { fresh, pitch: 1 as const, cells };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("marks of scripts", () => {
  it("are removed 5 s after the last message, because the end of their script may be missed", () => {
    const changed = vi.fn<() => void>();
    const marks = new MarkedCells(changed);
    marks.add(marked(true, cell(1, { text: "1" })));
    vi.advanceTimersByTime(4_900);
    marks.add(marked(false, cell(1, { text: "1" })));
    vi.advanceTimersByTime(4_900);
    expect(marks.shown).toHaveLength(1);
    changed.mockClear();
    vi.advanceTimersByTime(100);
    expect(marks.shown).toEqual([]);
    expect(changed).toHaveBeenCalledOnce();
  });

  it("replace those of the same cell, and an empty mark removes them", () => {
    const marks = new MarkedCells(() => undefined);
    marks.add(marked(true, cell(1, { text: "1" }), cell(2, { color: "red" })));
    const before = marks.shown;
    marks.add(marked(false, cell(1, { walls: "n" }), cell(2)));
    expect(marks.shown).toEqual([cell(1, { walls: "n" })]);
    // The stage draws another list.
    expect(marks.shown).not.toBe(before);
  });

  it("end with a fresh message", () => {
    const marks = new MarkedCells(() => undefined);
    marks.add(marked(true, cell(1, { text: "1" })));
    marks.add(marked(true));
    expect(marks.shown).toEqual([]);
  });

  it("are hidden by the switch, and shown again with what has changed", () => {
    const marks = new MarkedCells(() => undefined);
    marks.hide(true);
    marks.add(marked(true, cell(1, { text: "1" })));
    expect(marks.shown).toEqual([]);
    marks.hide(false);
    expect(marks.shown).toHaveLength(1);
  });
});
