import { describe, expect, it } from "vitest";
import { OVERLAP } from "./paper.ts";
import { MAX_SHEETS, printedSize, squareBounds, tileMaze } from "./tiles.ts";

const preset = { columns: 11, rows: 7 };

describe("a maze on sheets to glue together", () => {
  it.each([
    { square: 1, paper: "a4", sheets: 1, isLandscape: false },
    { square: 2, paper: "a4", sheets: 1, isLandscape: true },
    { square: 5, paper: "a4", sheets: 8, isLandscape: false },
    { square: 5, paper: "letter", sheets: 6, isLandscape: false },
  ] as const)("takes $sheets $paper sheets at $square cm", ({ square, paper, ...expected }) => {
    const tiling = tileMaze(preset, square, paper);
    expect(tiling).toMatchObject({ ok: true, isLandscape: expected.isLandscape });
    expect(tiling.ok && tiling.sheets).toHaveLength(expected.sheets);
  });

  it("covers the whole maze, and neighbours share 10 mm", () => {
    for (const [columns, rows] of [
      [1, 1],
      [33, 5],
      [5, 33],
      [20, 20],
    ] as const) {
      for (let square = 1; square <= 12; square += 0.5) {
        for (const paper of ["a4", "letter"] as const) {
          const tiling = tileMaze({ columns, rows }, square, paper);
          if (!tiling.ok) continue;
          const whole = printedSize({ columns, rows }, square);
          const { part } = tiling;
          const last = tiling.sheets.at(-1) ?? { x: 0, y: 0 };
          expect(last.x + part.width).toBeGreaterThanOrEqual(whole.width);
          expect(last.y + part.height).toBeGreaterThanOrEqual(whole.height);
          // No sheet is empty.
          expect(last.x).toBeLessThan(whole.width);
          expect(last.y).toBeLessThan(whole.height);
          const [first, second] = tiling.sheets;
          if (first === undefined || second === undefined || tiling.columns === 1) continue;
          expect(first.x + part.width - second.x).toBeCloseTo(OVERLAP);
        }
      }
    }
  });

  it("lies on its side where that takes fewer sheets", () => {
    const wide = tileMaze({ columns: 26, rows: 3 }, 5, "a4");
    const high = tileMaze({ columns: 3, rows: 26 }, 5, "a4");
    expect(wide).toMatchObject({ isLandscape: true });
    expect(high).toMatchObject({ isLandscape: false });
  });

  it("is refused above 60 sheets, with the largest square that fits", () => {
    const refused = tileMaze({ columns: 33, rows: 33 }, 10, "a4");
    expect(refused.ok).toBe(false);
    if (refused.ok || refused.most === null) return;
    expect(refused.sheets).toBeGreaterThan(MAX_SHEETS);
    expect(refused.most).toBeLessThan(10);
    expect(tileMaze({ columns: 33, rows: 33 }, refused.most, "a4").ok).toBe(true);
    expect(tileMaze({ columns: 33, rows: 33 }, refused.most + 0.5, "a4").ok).toBe(false);
  });

  it("is refused without a proposal if no square fits", () => {
    const refused = tileMaze({ columns: 1_000, rows: 1_000 }, squareBounds.min, "a4");
    expect(refused).toMatchObject({ ok: false, most: null });
  });
});
