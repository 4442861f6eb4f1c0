import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { beforeEach, expect, it, vi } from "vitest";
import { frameOf } from "../testing/frame-of.ts";
import type { LayerCanvas } from "../drawing/drawing-context.ts";
import { readPalette } from "../drawing/palette.ts";
import { CanvasLayer } from "./canvas-layer.ts";
import { layOut, viewportAt, viewX } from "../drawing/viewport.ts";
import type { Hit } from "./hit.ts";
import { drawLive } from "./live.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["...", "..#", "..."],
  start: { column: 0, row: 1, heading: "east" },
  goals: [],
};

beforeEach(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

/** room for rulers and large readings */
const layout = layOut(
  { columns: 3, rows: 3 },
  { width: 400, height: 400 },
  { top: 36, right: 34, bottom: 20, left: 70 },
  30,
);
const scroll = { x: 0, y: 0 };
const viewport = viewportAt(layout, scroll);

/** @returns the drawn texts, and each name that `nameOf` gives to a started line, in order */
function drawnIn(
  snapshot: Snapshot,
  rules: ProgramDocument["rules"],
  hit: Hit | null,
  nameOf: (x: number, y: number) => string | null,
): string[] {
  const done: string[] = [];
  const context = new Proxy(
    {},
    {
      get: (_, name) => {
        if (name === "measureText") return () => ({ width: 20 });
        if (name === "fillText") return (text: string) => done.push(text);
        if (name === "moveTo") {
          return (x: number, y: number) => {
            const line = nameOf(x, y);
            if (line !== null) done.push(line);
          };
        }
        return () => undefined;
      },
      set: () => true,
    },
  );
  const canvas = { width: 0, height: 0, getContext: () => context } as unknown as LayerCanvas;
  drawLive(
    new CanvasLayer(canvas),
    viewport,
    {
      layout,
      scroll,
      answers: 0,
      pixelRatio: 1,
      palette: readPalette(() => "black"),
      maze,
      program: { format: "corridor/program", version: 1, name: "", default: "forward", rules },
      startWord: "Start",
      goalWord: "Goal",
      showBeams: true,
      showTrail: true,
      showRulers: true,
      preview: null,
      measured: null,
      isCalm: true,
    },
    {
      frame: frameOf({ snapshot, corners: [], trailReset: false }),
      numbers: snapshot,
      hit,
      nudge: scroll,
    },
  );
  return done;
}

it("draws a reading beside the frame over the ruler's mark at the same position", () => {
  const snapshot = snapshotOf({
    pose: { x: 50, y: 150, heading: 90 },
    sensors: { front: 250, right: 150, back: 50, left: 150 },
  });
  const mark = { x: layout.port.x - 4, y: layout.port.y + layout.port.height / 2 };
  const done = drawnIn(snapshot, [], null, (x, y) =>
    x === mark.x && y === mark.y ? "mark" : null,
  );
  expect(done).toContain("mark");
  expect(done).toContain("50");
  expect(done.indexOf("mark")).toBeLessThan(done.indexOf("50"));
});

it("does not strike through the robot's radius with the mark of a line", () => {
  // The robot touches a wall that no beam meets, as at a corner.
  const pose = { x: 175, y: 150, heading: 90 };
  const snapshot = snapshotOf({
    driver: "program",
    pose,
    sensors: { front: 125, right: 150, back: 175, left: 150 },
  });
  const rules: ProgramDocument["rules"] = [
    { when: { sensor: "front", is: ">", than: 60 }, do: "forward" },
  ];
  const barX = viewX(viewport, pose.x + 60);
  const done = drawnIn(snapshot, rules, { pose, wanted: null }, (x) =>
    Math.abs(x - barX) < 0.5 ? "bar" : null,
  );
  expect(done).toContain("bar");
  expect(done).toContain("25");
  expect(done.indexOf("bar")).toBeLessThan(done.indexOf("25"));
});
