import { describe, expect, it } from "vitest";
import { layOutWorksheet, LINE_HEIGHT } from "./worksheet-layout.ts";

describe("a worksheet", () => {
  it.each([
    { columns: 11, rows: 7, isLandscape: false },
    { columns: 5, rows: 33, isLandscape: false },
    { columns: 33, rows: 5, isLandscape: true },
  ])("shows a maze of $columns by $rows as large as it can", ({ isLandscape, ...maze }) => {
    for (const paper of ["a4", "letter"] as const) {
      expect(layOutWorksheet(maze, paper, null).isLandscape).toBe(isLandscape);
    }
  });

  it("has room for lines, whatever the maze", () => {
    for (const [columns, rows] of [
      [1, 1],
      [33, 33],
      [160, 160],
      [1_000, 3],
      [3, 1_000],
    ] as const) {
      const { sheet, square, lines } = layOutWorksheet({ columns, rows }, "letter", null);
      expect(lines).toBeGreaterThanOrEqual(4);
      expect(square * columns).toBeLessThan(sheet.width);
      expect(square * rows + lines * LINE_HEIGHT).toBeLessThan(sheet.height);
    }
  });

  it.each([
    { most: 3, lines: 4 },
    { most: 0, lines: 1 },
    { most: 200, lines: 10 },
    { most: null, lines: 10 },
  ])("has $lines lines where the task allows $most and one for otherwise", ({ most, lines }) => {
    expect(layOutWorksheet({ columns: 9, rows: 4 }, "a4", most).lines).toBe(lines);
  });
});
