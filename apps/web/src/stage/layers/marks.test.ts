import type { CellMark } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import { readPalette } from "../drawing/palette.ts";
import { layOut, viewportAt } from "../drawing/viewport.ts";
import { drawMarks } from "./marks.ts";

const view = { width: 1000, height: 600 };
const padding = { top: 0, right: 0, bottom: 0, left: 0 };

/** @returns what is drawn in a maze of 40 x 40 cells, of which the first 25 x 15 are visible */
function drawn(marks: CellMark[], cellPx = 40): string[] {
  const calls: string[] = [];
  const record =
    (name: string) =>
    (...args: unknown[]): void =>
      void calls.push(`${name} ${args.join(" ")}`);
  const context = {
    save: () => undefined,
    restore: () => undefined,
    beginPath: () => undefined,
    stroke: () => undefined,
    set fillStyle(color: string) {
      record("color")(color);
    },
    fillRect: record("rect"),
    fillText: record("text"),
    moveTo: record("from"),
    lineTo: record("to"),
  };
  const layout = layOut({ columns: 40, rows: 40 }, view, padding, cellPx, cellPx);
  const viewport = viewportAt(layout, { x: 0, y: 0 });
  // oxlint-disable-next-line typescript/consistent-type-assertions -- a test cannot draw: it needs only the part of a context that marks use
  drawMarks(
    context as unknown as DrawingContext,
    viewport,
    readPalette((name) => name),
    marks,
  );
  return calls;
}

const blank = { text: "", color: null, walls: "" };

describe("a marked cell", () => {
  it("shows its colour below its text", () => {
    expect(drawn([{ ...blank, column: 2, row: 1, color: "red", text: "12" }])).toEqual([
      "color #cc0000",
      "rect 80 40 40 40",
      "color --ink",
      "text 12 100 60 36",
    ]);
  });

  it("shows its walls inside its sides", () => {
    const calls = drawn([{ ...blank, column: 0, row: 0, walls: "ne" }]);
    expect(calls.filter((call) => /^(from|to)/.test(call))).toEqual([
      "from 0 1",
      "to 40 1",
      "from 39 0",
      "to 39 40",
    ]);
  });

  it("outside of the view is not drawn, and no text that nobody can read", () => {
    const text = { ...blank, text: "1" };
    expect(drawn([{ ...text, column: 39, row: 0 }])).toEqual(["color --ink"]);
    expect(drawn([{ ...text, column: 0, row: 0 }], 10)).toEqual([]);
  });
});
