import { arbitraryMaze } from "@corridor/maze/testing";
import { mazePresets } from "@corridor/maze";
import fc from "fast-check";
import { beforeAll, describe, expect, it, vi } from "vitest";
import { readPalette } from "../drawing/palette.ts";
import { mazeSvg, type PictureScene } from "./maze-svg.ts";

beforeAll(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

const [, , spiral] = mazePresets.map(({ maze }) => maze);
if (spiral === undefined) throw new Error("a preset is gone");
const scene: PictureScene = {
  maze: spiral,
  palette: readPalette((property) =>
    property === "--font-ui" ? '"Inter", sans-serif' : "#123456",
  ),
  startWord: "Start",
  goalWord: "Goal & end",
  hasRulers: true,
  run: {
    pose: { x: 250, y: 150, heading: 90 },
    face: "driving",
    points: [150, 150, 250, 150],
    bumps: [250, 150],
  },
};

/** Whether all tags are balanced, and no character appears where XML forbids it. */
function isWellFormed(text: string): boolean {
  const open: string[] = [];
  for (const [, isEnd, name = "", isEmpty] of text.matchAll(
    /<(\/?)([a-z]+)(?: [\w:-]+="[^"<]*")*(\/?)>/g,
  )) {
    if (isEnd !== "" && open.pop() !== name) return false;
    if (isEnd === "" && isEmpty === "") open.push(name);
  }
  const rest = text.replaceAll(/<(\/?)([a-z]+)(?: [\w:-]+="[^"<]*")*(\/?)>/g, "");
  return open.length === 0 && !/[<>]|&(?!(amp|lt|gt|quot);)/.test(rest);
}

describe("a picture as SVG", () => {
  it("shows maze, trail, robot, words and rulers, in one file that asks for no other", () => {
    const { text, width, height } = mazeSvg(scene);
    expect(isWellFormed(text)).toBe(true);
    expect(text).toContain(`viewBox="0 0 ${width} ${height}"`);
    for (const part of [">Start</text>", ">Goal &amp; end</text>", ">1100</text>", "rotate(90)"]) {
      expect(text).toContain(part);
    }
    expect(text.replace("http://www.w3.org/2000/svg", "")).not.toMatch(/https?:|url\(|href/);
  });

  it("omits rulers and robot on request", () => {
    const { text } = mazeSvg({ ...scene, hasRulers: false, run: null });
    expect(text).not.toContain(">1100</text>");
    expect(text).not.toContain("rotate(90) scale");
  });

  it("is well formed whatever a maze is called and whatever words there are", () => {
    const anyText = fc.string({ unit: "binary", maxLength: 20 });
    fc.assert(
      fc.property(arbitraryMaze, anyText, anyText, (maze, name, word) => {
        const { text, width, height } = mazeSvg({
          ...scene,
          maze: { ...maze, name },
          goalWord: word,
        });
        expect(isWellFormed(text)).toBe(true);
        expect(Math.max(width, height)).toBeLessThanOrEqual(256 * 8 + 100);
      }),
      { numRuns: 30 },
    );
  });
});
