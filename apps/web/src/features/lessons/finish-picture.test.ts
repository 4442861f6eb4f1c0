import { beforeAll, describe, expect, it, vi } from "vitest";
import type { Palette } from "../../stage/drawing/palette.ts";
import { firstMaze } from "../../simulator/protocol/first-project.ts";
import { finishPicture } from "./finish-picture.ts";

/** Returns the same colour for every key. */
const palette = new Proxy({} as Palette, { get: () => "#123456" });

beforeAll(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

function draw(dir: "ltr" | "rtl" = "ltr") {
  return finishPicture({
    trail: {
      maze: { ...firstMaze, name: "A <maze>" },
      pose: { x: 150, y: 650, heading: 90 },
      points: [50, 650, 150, 650],
    },
    palette,
    dir,
    startWord: "Start",
    goalWord: "Goal",
    title: "All 14 missions done",
    date: "1 May 2030",
    counts: "Lines written: 20 & more",
    description: "All in words",
  });
}

describe("the picture of the finish", () => {
  it("shows title, date, counts and the maze in one file with a text alternative", () => {
    const { svg, width, height } = draw();
    expect(svg).toContain(">All 14 missions done</text>");
    expect(svg).toContain(">1 May 2030</text>");
    expect(svg).toContain(">Lines written: 20 &amp; more</text>");
    expect(svg).toContain('role="img" aria-label="All in words"');
    expect(svg).toContain("<desc>All in words</desc>");
    expect(svg).not.toContain("A &lt;maze&gt;");
    expect(svg.match(/<svg /g)).toHaveLength(2);
    expect(svg.match(/<\/svg>/g)).toHaveLength(2);
    expect(svg).toContain(`viewBox="0 0 ${width} ${height}"`);
    expect(svg).not.toMatch(/NaN|undefined/);
  });

  it("runs its words right-to-left in Arabic: a date begins with its day", () => {
    const { svg } = draw("rtl");
    const [, words] = /<g direction="rtl">(.*?)<\/g>/s.exec(svg) ?? [];
    expect(words).toContain(">1 May 2030</text>");
  });
});
