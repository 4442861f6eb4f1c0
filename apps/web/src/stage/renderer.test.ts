/**
 * Which canvas is redrawn when. Node has no canvas, so a recording one replaces it. The browser
 * tests check how the result looks.
 */
import { snapshotOf } from "@corridor/protocol/testing";
import type { MazeDocument } from "@corridor/maze";
import type { CellMark, Snapshot } from "@corridor/protocol";
import { beforeEach, describe, expect, it, onTestFinished, vi } from "vitest";
import { frameOf } from "./testing/frame-of.ts";
import type { Frame } from "./drawing/frame.ts";
import type { LayerCanvas, LayerCanvases } from "./drawing/drawing-context.ts";
import { readPalette } from "./drawing/palette.ts";
import { lateMarks } from "./layers/late-marks.ts";
import { StageRenderer } from "./renderer.ts";
import type { StageModel } from "./layers/stage-model.ts";
import { layOut, type Scroll } from "./drawing/viewport.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["...", ".#.", "..."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 2, row: 2 }],
};
const padding = { top: 36, right: 34, bottom: 20, left: 70 };
const view = { width: 1028, height: 644 };

const model: StageModel = {
  layout: layOut({ columns: 3, rows: 3 }, view, padding, 30),
  scroll: { x: 0, y: 0 },
  answers: 0,
  pixelRatio: 1,
  palette: readPalette(() => "black"),
  maze,
  program: {
    format: "corridor/program",
    version: 1,
    name: "",
    default: "forward",
    rules: [{ when: { sensor: "right", is: ">", than: 60 }, do: "right 90" }],
  },
  startWord: "Start",
  goalWord: "Goal",
  showBeams: true,
  showTrail: true,
  showRulers: true,
  preview: null,
  measured: null,
  isCalm: false,
};

function snapshotAt(x: number, y: number, state: Snapshot["state"] = "running"): Snapshot {
  const sensors = { front: 250, right: 250, back: 50, left: 50 };
  return snapshotOf({ driver: "program", line: 0, sensors, state, pose: { x, y, heading: 90 } });
}

/**
 * A canvas that counts how often it is cleared fully and partially, clipped for a layer, and
 * stroked.
 */
function recordingCanvas() {
  const counts = { cleared: 0, wiped: 0, strokes: 0, pictures: 0 };
  const texts: string[] = [];
  const canvas = { width: 0, height: 0, getContext: () => context };
  const wipe = (x: number, y: number, width: number): void => {
    const isWhole = x === 0 && y === 0 && width >= Math.min(canvas.width, view.width);
    counts[isWhole ? "cleared" : "wiped"]++;
  };
  const context = new Proxy(
    {},
    {
      get: (_, name) => {
        if (name === "clearRect") return wipe;
        if (name === "clip") return () => counts.pictures++;
        if (name === "stroke") return () => counts.strokes++;
        if (name === "fillText") return (text: string) => texts.push(text);
        if (name === "measureText") return () => ({ width: 20 });
        return () => undefined;
      },
      set: () => true,
    },
  );
  return { canvas: canvas as unknown as LayerCanvas, counts, texts };
}

function newStage() {
  const layers = { maze: recordingCanvas(), trail: recordingCanvas(), live: recordingCanvas() };
  const canvases: LayerCanvases = {
    maze: layers.maze.canvas,
    trail: layers.trail.canvas,
    live: layers.live.canvas,
  };
  let frame: Frame | null = null;
  let waiting: (() => void) | null = null;
  const scrolls: Scroll[] = [];
  const requestFrame = vi.fn<(paint: () => void) => number>((paint: () => void) => {
    waiting = paint;
    return 1;
  });
  const renderer = new StageRenderer({
    takeFrame: () => {
      const occupied = frame;
      if (occupied !== null) frame = { ...occupied, corners: [], trailReset: false };
      return occupied;
    },
    requestFrame,
    cancelFrame: () => (waiting = null),
    now: () => 0,
    scrollTo: (scroll) => scrolls.push(scroll),
  });
  const paint = (): void => {
    const next = waiting;
    waiting = null;
    next?.();
  };
  renderer.attach(canvases);
  paint();
  requestFrame.mockClear();
  const show = (snapshot: Snapshot, corners: number[], trailReset: boolean): void => {
    frame = frameOf({ snapshot, corners, trailReset });
    renderer.frameArrived(frame);
    paint();
  };
  const standing = snapshotAt(50, 50);
  const mark = (marks: Frame["marks"]): void => {
    frame = { ...frameOf({ snapshot: standing, corners: [], trailReset: false }), marks };
    renderer.frameArrived(frame);
    paint();
  };
  const drive = (x: number, y: number, isReset = false): void =>
    show(snapshotAt(x, y), isReset ? [x, y] : [], isReset);
  const rest = (x: number, y: number): void => show(snapshotAt(x, y, "paused"), [], false);
  /**
   * How often each layer was redrawn since the last call; the live layer is cleared partially for
   * it.
   */
  const redrawn = (): { maze: number; trail: number; live: number } => {
    const now = {
      maze: layers.maze.counts.cleared,
      trail: layers.trail.counts.cleared,
      live: layers.live.counts.pictures,
    };
    for (const { counts } of Object.values(layers)) counts.cleared = counts.pictures = 0;
    return now;
  };
  return {
    renderer,
    layers,
    canvases,
    requestFrame,
    paint,
    show,
    mark,
    drive,
    rest,
    redrawn,
    scrolls,
  };
}

beforeEach(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

describe("the stage", () => {
  it("draws all three layers once at first, at the size of the screen's pixels", () => {
    const { renderer, canvases, paint, redrawn } = newStage();
    renderer.show({ ...model, pixelRatio: 2 });
    paint();
    expect(redrawn()).toEqual({ maze: 1, trail: 1, live: 1 });
    expect(canvases.maze).toMatchObject({ width: 2056, height: 1288 });
  });

  it("redraws the maze when marks of scripts have changed, also while the robot stands", () => {
    const { renderer, paint, drive, redrawn, mark } = newStage();
    lateMarks.draw = vi.fn<NonNullable<typeof lateMarks.draw>>();
    onTestFinished(() => {
      lateMarks.draw = null;
    });
    renderer.show(model);
    drive(50, 50, true);
    paint();
    redrawn();
    const marks: CellMark[] = [{ column: 0, row: 0, text: "1", color: null, walls: "" }];
    mark(marks);
    mark(marks);
    expect(redrawn().maze).toBe(1);
    expect(lateMarks.draw).toHaveBeenCalledOnce();
    expect(vi.mocked(lateMarks.draw).mock.lastCall?.[3]).toBe(marks);
    mark(undefined);
    expect(redrawn().maze).toBe(1);
    expect(lateMarks.draw).toHaveBeenCalledOnce();
  });

  it("leaves maze and old trail alone while the robot drives", () => {
    const { renderer, layers, paint, drive, redrawn } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    paint();
    redrawn();
    const strokes = layers.trail.counts.strokes;
    for (let x = 51; x <= 60; x++) drive(x, 50);
    expect(redrawn()).toEqual({ maze: 0, trail: 0, live: 10 });
    expect(layers.trail.counts.strokes - strokes).toBe(10);
  });

  it.each([
    {
      name: "another block",
      change: { maze: { ...maze } },
      redrawn: { maze: 1, trail: 0, live: 1 },
    },
    {
      name: "another theme",
      change: { palette: readPalette(() => "white") },
      redrawn: { maze: 1, trail: 1, live: 1 },
    },
    {
      name: "another size",
      change: { layout: layOut({ columns: 3, rows: 3 }, { width: 500, height: 500 }, padding, 30) },
      redrawn: { maze: 1, trail: 1, live: 1 },
    },
    {
      name: "a hovered square",
      change: { preview: { kind: "block", cell: { column: 1, row: 0 } } },
      redrawn: { maze: 0, trail: 0, live: 1 },
    },
    { name: "beams hidden", change: { showBeams: false }, redrawn: { maze: 0, trail: 0, live: 1 } },
    {
      name: "rulers hidden",
      change: { showRulers: false },
      redrawn: { maze: 1, trail: 0, live: 1 },
    },
    { name: "nothing", change: {}, redrawn: { maze: 0, trail: 0, live: 0 } },
  ] satisfies { name: string; change: Partial<StageModel>; redrawn: object }[])(
    "redraws only what shows it: $name",
    ({ change, redrawn }) => {
      const { renderer, paint, redrawn: drawn } = newStage();
      renderer.show(model);
      paint();
      drawn();
      renderer.show({ ...model, ...change });
      paint();
      expect(drawn()).toEqual(redrawn);
    },
  );

  it("requests one animation frame for any number of changes, and none without a change", () => {
    const { renderer, requestFrame, paint } = newStage();
    renderer.show(model);
    renderer.show({ ...model, showBeams: false });
    renderer.frameArrived(frameOf());
    expect(requestFrame).toHaveBeenCalledTimes(1);
    paint();
    renderer.show({ ...model, showBeams: false });
    expect(requestFrame).toHaveBeenCalledTimes(1);
  });

  it("draws nothing while only time passes, as when a robot waits for its script", () => {
    const { renderer, requestFrame, paint, drive, show, redrawn } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    drive(60, 50);
    paint();
    redrawn();
    requestFrame.mockClear();
    const standing = snapshotAt(60, 50);
    for (let tick = 1; tick <= 10; tick++) show({ ...standing, tick, seq: tick }, [], false);
    expect(requestFrame).not.toHaveBeenCalled();
    renderer.showNumbersOf(standing);
    paint();
    redrawn();
    requestFrame.mockClear();
    renderer.showNumbersOf({ ...standing, tick: 10, seq: 10 });
    expect(requestFrame).not.toHaveBeenCalled();
    show({ ...standing, tick: 11, goalReached: true }, [], false);
    expect(redrawn()).toEqual({ maze: 0, trail: 0, live: 1 });
  });

  it("redraws the trail when the robot returns to its start", () => {
    const { renderer, drive, redrawn } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    drive(80, 50);
    redrawn();
    drive(50, 50, true);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 1 });
  });

  it("redraws the trail as one line when the robot stops, and not again after that", () => {
    const { renderer, drive, rest, redrawn } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    drive(80, 50);
    redrawn();
    rest(80, 50);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 1 });
    rest(80, 50);
    drive(81, 50);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 0 });
  });

  it("draws nothing while it has no canvases, and everything on the next ones", () => {
    const { renderer, canvases, paint, drive, redrawn } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    renderer.detach();
    redrawn();
    drive(80, 50);
    expect(redrawn()).toEqual({ maze: 0, trail: 0, live: 0 });
    renderer.attach(canvases);
    paint();
    expect(redrawn()).toEqual({ maze: 1, trail: 1, live: 1 });
  });

  it("erases only the area of the robot and its beams", () => {
    const { renderer, layers, drive } = newStage();
    renderer.show(model);
    drive(50, 50, true);
    layers.live.counts.cleared = 0;
    for (let x = 51; x <= 60; x++) drive(x, 50);
    expect(layers.live.counts.cleared).toBe(0);
    expect(layers.live.counts.wiped).toBeGreaterThan(10);
  });
});

describe("a maze larger than the stage", () => {
  const large = {
    ...model,
    layout: layOut({ columns: 256, rows: 256 }, view, padding, 30),
    maze: { ...maze, blocks: Array.from({ length: 256 }, () => ".".repeat(256)) },
  };

  it("scrolls to a robot that leaves the view, and stands still while the robot is well inside", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show(large);
    drive(12_000, 12_000, true);
    expect(scrolls).toHaveLength(1);
    renderer.show({ ...large, scroll: scrolls[0] ?? { x: 0, y: 0 }, answers: 1 });
    paint();
    drive(12_001, 12_000);
    expect(scrolls).toHaveLength(1);
  });

  it("shows a robot that stands still when the stage becomes too small", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show({ ...large, layout: { ...large.layout, overflows: false } });
    drive(12_000, 12_000, true);
    expect(scrolls).toHaveLength(0);
    renderer.show(large);
    paint();
    expect(scrolls).toHaveLength(1);
  });

  it("requests again if the page scrolled elsewhere, as it does for an older layout", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show(large);
    drive(12_000, 12_000, true);
    renderer.show({ ...large, scroll: { x: 0, y: 0 }, answers: 1 });
    paint();
    expect(scrolls).toHaveLength(2);
    expect(scrolls[1]).toEqual(scrolls[0]);
  });

  it("redraws every layer after a scroll", () => {
    const { renderer, paint, redrawn } = newStage();
    renderer.show(large);
    paint();
    redrawn();
    renderer.show({ ...large, scroll: { x: 100, y: 0 } });
    paint();
    expect(redrawn()).toEqual({ maze: 1, trail: 1, live: 1 });
  });
});

describe("the readings on the beams", () => {
  const readings = (layer: ReturnType<typeof recordingCanvas>): string[] =>
    layer.texts.splice(0).filter((text) => /^\d{2,}$/.test(text));

  it("are those that the page displays, however far the robot has driven since", () => {
    const { renderer, layers, paint, show } = newStage();
    const withFront = (front: number, tick: number) => {
      const sensors = { front, right: 50, back: 50, left: 50 };
      return { ...snapshotAt(50, 50), sensors, tick };
    };
    renderer.show({ ...model, program: { ...model.program, rules: [] } });
    show(withFront(250, 1), [50, 50], true);
    renderer.showNumbersOf(withFront(250, 1));
    paint();
    expect(readings(layers.live)).toContain("250");
    for (let tick = 2; tick < 12; tick++) {
      show(withFront(251 - tick, tick), [], false);
      expect(readings(layers.live)).toContain("250");
    }
    renderer.showNumbersOf(withFront(240, 12));
    paint();
    const next = readings(layers.live);
    expect(next).toContain("240");
    expect(next).not.toContain("250");
  });
});
