/**
 * Which canvas is drawn again when. There is no canvas in Node: a recording one stands in, and how the
 * pictures look is seen in the browser's tests.
 */
import { snapshotOf } from "@corridor/protocol/testing";
import type { MazeDocument } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import { beforeEach, describe, expect, it, vi } from "vitest";
import { frameOf } from "../worker/testing/frame-of.ts";
import type { Frame } from "../worker/worker-messages.ts";
import type { LayerCanvas, LayerCanvases } from "./brush.ts";
import { readPalette } from "./palette.ts";
import { StageRenderer } from "./renderer.ts";
import type { Scene } from "./scene.ts";
import { layOut, type Scroll } from "./viewport.ts";

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

const scene: Scene = {
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
  ghost: null,
  measured: null,
  isCalm: false,
};

function snapshotAt(x: number, y: number, state: Snapshot["state"] = "running"): Snapshot {
  const sensors = { front: 250, right: 250, back: 50, left: 50 };
  return snapshotOf({ driver: "program", line: 0, sensors, state, pose: { x, y, heading: 90 } });
}

/** A canvas that counts how often it is emptied as a whole and in part, clipped for a picture, and stroked. */
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
      const taken = frame;
      if (taken !== null) frame = { ...taken, corners: [], trailReset: false };
      return taken;
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
    renderer.frameArrived();
    paint();
  };
  const drive = (x: number, y: number, isReset = false): void =>
    show(snapshotAt(x, y), isReset ? [x, y] : [], isReset);
  const rest = (x: number, y: number): void => show(snapshotAt(x, y, "paused"), [], false);
  /** How often each layer has been drawn anew since the last call; the robot's is wiped in part for it. */
  const redrawn = (): { maze: number; trail: number; live: number } => {
    const now = {
      maze: layers.maze.counts.cleared,
      trail: layers.trail.counts.cleared,
      live: layers.live.counts.pictures,
    };
    for (const { counts } of Object.values(layers)) counts.cleared = counts.pictures = 0;
    return now;
  };
  return { renderer, layers, canvases, requestFrame, paint, show, drive, rest, redrawn, scrolls };
}

beforeEach(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

describe("the stage", () => {
  it("draws all three layers once at first, at the size of the screen's pixels", () => {
    const { renderer, canvases, paint, redrawn } = newStage();
    renderer.show({ ...scene, pixelRatio: 2 });
    paint();
    expect(redrawn()).toEqual({ maze: 1, trail: 1, live: 1 });
    expect(canvases.maze).toMatchObject({ width: 2056, height: 1288 });
  });

  it("touches neither maze nor old trail while the robot drives", () => {
    const { renderer, layers, paint, drive, redrawn } = newStage();
    renderer.show(scene);
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
      change: { ghost: { kind: "block", cell: { column: 1, row: 0 } } },
      redrawn: { maze: 0, trail: 0, live: 1 },
    },
    { name: "beams hidden", change: { showBeams: false }, redrawn: { maze: 0, trail: 0, live: 1 } },
    {
      name: "rulers hidden",
      change: { showRulers: false },
      redrawn: { maze: 1, trail: 0, live: 1 },
    },
    { name: "nothing", change: {}, redrawn: { maze: 0, trail: 0, live: 0 } },
  ] satisfies { name: string; change: Partial<Scene>; redrawn: object }[])(
    "redraws only what shows it: $name",
    ({ change, redrawn }) => {
      const { renderer, paint, redrawn: drawn } = newStage();
      renderer.show(scene);
      paint();
      drawn();
      renderer.show({ ...scene, ...change });
      paint();
      expect(drawn()).toEqual(redrawn);
    },
  );

  it("asks for one animation frame, however much changes, and for none while nothing does", () => {
    const { renderer, requestFrame, paint } = newStage();
    renderer.show(scene);
    renderer.show({ ...scene, showBeams: false });
    renderer.frameArrived();
    expect(requestFrame).toHaveBeenCalledTimes(1);
    paint();
    renderer.show({ ...scene, showBeams: false });
    expect(requestFrame).toHaveBeenCalledTimes(1);
  });

  it("draws the trail anew when the robot goes back to its start", () => {
    const { renderer, drive, redrawn } = newStage();
    renderer.show(scene);
    drive(50, 50, true);
    drive(80, 50);
    redrawn();
    drive(50, 50, true);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 1 });
  });

  it("draws the trail as one line when the robot comes to rest, and leaves it then", () => {
    const { renderer, drive, rest, redrawn } = newStage();
    renderer.show(scene);
    drive(50, 50, true);
    drive(80, 50);
    redrawn();
    rest(80, 50);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 1 });
    rest(80, 50);
    drive(81, 50);
    expect(redrawn()).toMatchObject({ maze: 0, trail: 0 });
  });

  it("draws nothing while it has no canvases, and all on the next ones", () => {
    const { renderer, canvases, paint, drive, redrawn } = newStage();
    renderer.show(scene);
    drive(50, 50, true);
    renderer.detach();
    redrawn();
    drive(80, 50);
    expect(redrawn()).toEqual({ maze: 0, trail: 0, live: 0 });
    renderer.attach(canvases);
    paint();
    expect(redrawn()).toEqual({ maze: 1, trail: 1, live: 1 });
  });

  it("wipes only where the robot and its beams were, not the whole picture", () => {
    const { renderer, layers, drive } = newStage();
    renderer.show(scene);
    drive(50, 50, true);
    layers.live.counts.cleared = 0;
    for (let x = 51; x <= 60; x++) drive(x, 50);
    expect(layers.live.counts.cleared).toBe(0);
    expect(layers.live.counts.wiped).toBeGreaterThan(10);
  });
});

describe("a maze larger than the stage", () => {
  const large = {
    ...scene,
    layout: layOut({ columns: 256, rows: 256 }, view, padding, 30),
    maze: { ...maze, blocks: Array.from({ length: 256 }, () => ".".repeat(256)) },
  };

  it("follows the robot out of sight, and stands still while it is well in sight", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show(large);
    drive(12_000, 12_000, true);
    expect(scrolls).toHaveLength(1);
    renderer.show({ ...large, scroll: scrolls[0] ?? { x: 0, y: 0 }, answers: 1 });
    paint();
    drive(12_001, 12_000);
    expect(scrolls).toHaveLength(1);
  });

  it("shows the robot when the stage becomes too small, though it stands still", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show({ ...large, layout: { ...large.layout, overflows: false } });
    drive(12_000, 12_000, true);
    expect(scrolls).toHaveLength(0);
    renderer.show(large);
    paint();
    expect(scrolls).toHaveLength(1);
  });

  it("asks again where the page answered with another place, as it does for an older layout", () => {
    const { renderer, paint, drive, scrolls } = newStage();
    renderer.show(large);
    drive(12_000, 12_000, true);
    renderer.show({ ...large, scroll: { x: 0, y: 0 }, answers: 1 });
    paint();
    expect(scrolls).toHaveLength(2);
    expect(scrolls[1]).toEqual(scrolls[0]);
  });

  it("draws every layer again where it has been scrolled", () => {
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
    const told = (front: number, tick: number) => {
      const sensors = { front, right: 50, back: 50, left: 50 };
      return { ...snapshotAt(50, 50), sensors, tick };
    };
    renderer.show({ ...scene, program: { ...scene.program, rules: [] } });
    show(told(250, 1), [50, 50], true);
    renderer.showNumbersOf(told(250, 1));
    paint();
    expect(readings(layers.live)).toContain("250");
    for (let tick = 2; tick < 12; tick++) {
      show(told(252 - tick, tick), [], false);
      expect(readings(layers.live)).toContain("250");
    }
    renderer.showNumbersOf(told(240, 12));
    paint();
    const next = readings(layers.live);
    expect(next).toContain("240");
    expect(next).not.toContain("250");
  });
});
