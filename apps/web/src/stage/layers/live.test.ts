import type { MazeDocument } from "@corridor/maze";
import { snapshotOf } from "@corridor/protocol/testing";
import { beforeEach, expect, it, vi } from "vitest";
import { frameOf } from "../testing/frame-of.ts";
import type { LayerCanvas } from "../drawing/drawing-context.ts";
import { readPalette } from "../drawing/palette.ts";
import { CanvasLayer } from "./canvas-layer.ts";
import { layOut, viewportAt } from "../drawing/viewport.ts";
import { drawLive } from "./live.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["...", "...", "..."],
  start: { column: 0, row: 1, heading: "east" },
  goals: [],
};

beforeEach(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

it("draws a reading beside the frame over the ruler's mark at the same position", () => {
  const layout = layOut(
    { columns: 3, rows: 3 },
    { width: 400, height: 400 },
    { top: 36, right: 34, bottom: 20, left: 70 },
    30,
  );
  const done: string[] = [];
  const context = new Proxy(
    {},
    {
      get: (_, name) => {
        if (name === "measureText") return () => ({ width: 20 });
        if (name === "fillText") return (text: string) => done.push(text);
        if (name === "moveTo") {
          return (x: number, y: number) => {
            if (x === layout.port.x - 4 && y === layout.port.y + layout.port.height / 2) {
              done.push("mark");
            }
          };
        }
        return () => undefined;
      },
      set: () => true,
    },
  );
  const canvas = { width: 0, height: 0, getContext: () => context } as unknown as LayerCanvas;
  const snapshot = snapshotOf({
    pose: { x: 50, y: 150, heading: 90 },
    sensors: { front: 250, right: 150, back: 50, left: 150 },
  });
  const scroll = { x: 0, y: 0 };
  drawLive(
    new CanvasLayer(canvas),
    viewportAt(layout, scroll),
    {
      layout,
      scroll,
      answers: 0,
      pixelRatio: 1,
      palette: readPalette(() => "black"),
      maze,
      program: { format: "corridor/program", version: 1, name: "", default: "forward", rules: [] },
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
      hit: null,
      nudge: scroll,
    },
  );
  expect(done).toContain("mark");
  expect(done).toContain("50");
  expect(done.indexOf("mark")).toBeLessThan(done.indexOf("50"));
});
