/**
 * The drawn maze, the grid for keyboard and screen readers, and the pointer agree after any
 * sequence of events. The test uses the real painter, on a canvas that records where the maze's
 * frame is drawn. The scroll container is a model of the browser's: it loses and restores its
 * position without an event.
 */
import { CELL, type Cell, type MazeDocument } from "@corridor/maze";
import { snapshotOf } from "@corridor/protocol/testing";
import fc from "fast-check";
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { LayerCanvas } from "../drawing/drawing-context.ts";
import { Camera } from "../camera.ts";
import { readPalette } from "../drawing/palette.ts";
import { StageRenderer } from "../renderer.ts";
import { cellAt, type Layout, type Scroll } from "../drawing/viewport.ts";
import { frameOf } from "../testing/frame-of.ts";
import type { Frame } from "../drawing/frame.ts";
import { gridOffset, isInPort } from "./grid-place.ts";
import { divideStage, type StageRoom } from "./stage-layout.ts";
import { applyScroll, followRequest, readScroll, setLayout } from "./stage-scroll.ts";
import { createStageView } from "./stage-view.ts";
import { zoomStage, type ZoomBy } from "./stage-zoom.ts";

const palette = readPalette(() => "black");
const robotRadius = 25;

/**
 * A canvas that records where the maze's frame was drawn last: the first round rectangle after a
 * clear.
 */
function frameRecorder() {
  const drawn = { frame: null as { x: number; y: number; width: number } | null, isEmpty: true };
  const context = new Proxy(
    {},
    {
      get: (_, name) => {
        if (name === "clearRect") return () => (drawn.isEmpty = true);
        if (name === "measureText") return () => ({ width: 20 });
        if (name !== "roundRect") return () => undefined;
        return (x: number, y: number, width: number) => {
          if (drawn.isEmpty) drawn.frame = { x, y, width };
          drawn.isEmpty = false;
        };
      },
      set: () => true,
    },
  );
  const canvas = { width: 0, height: 0, getContext: () => context } as unknown as LayerCanvas;
  return { canvas, drawn };
}

/** A scroll container: positions are clamped, and only scrolling fires an event. */
class Box {
  isScrolling = false;
  most: Scroll = { x: 0, y: 0 };
  hasEvent = false;
  #at: Scroll = { x: 0, y: 0 };

  get scrollLeft(): number {
    return this.isScrolling ? Math.min(this.#at.x, this.most.x) : 0;
  }
  get scrollTop(): number {
    return this.isScrolling ? Math.min(this.#at.y, this.most.y) : 0;
  }
  scrollTo({ left = 0, top = 0 }: ScrollToOptions): void {
    if (!this.isScrolling) return;
    // Browsers round to device pixels.
    const whole = (at: number, most: number) => Math.min(most, Math.max(0, Math.floor(at)));
    this.#at = { x: whole(left, this.most.x), y: whole(top, this.most.y) };
    this.hasEvent = true;
  }
}

class Stage {
  readonly view = createStageView();
  readonly box = new Box();
  room = { width: 1028, height: 644 };
  size = { columns: 11, rows: 7 };
  robot: { x: number; y: number } = { x: 50, y: 50 };
  isCalm = false;
  follows = false;
  readonly #recorder = frameRecorder();
  readonly #camera = new Camera();
  readonly #renderer: StageRenderer;
  #frame: Frame | null = null;
  #paint: (() => void) | null = null;
  #requests: Scroll[] = [];
  #maze: MazeDocument | null = null;

  constructor() {
    this.#renderer = new StageRenderer({
      takeFrame: () => {
        const frame = this.#frame;
        if (frame !== null) this.#frame = { ...frame, corners: [], trailReset: false };
        return frame;
      },
      requestFrame: (paint) => {
        this.#paint = paint;
        return 1;
      },
      cancelFrame: () => (this.#paint = null),
      now: () => 0,
      scrollTo: (scroll) => this.#requests.push(scroll),
    });
    const { canvas } = this.#recorder;
    const other = frameRecorder().canvas;
    this.#renderer.attach({ maze: canvas, trail: other, live: other });
    this.view.subscribe(() => this.#show());
    this.openMaze(this.size.columns, this.size.rows);
  }

  openMaze(columns: number, rows: number): void {
    this.size = { columns, rows };
    this.view.setState({ zoom: null });
    this.#maze = {
      format: "corridor/maze",
      version: 1,
      name: "",
      blocks: Array.from({ length: rows }, () => ".".repeat(columns)),
      start: { column: 0, row: 0, heading: "east" },
      goals: [],
    };
    this.divide();
    this.drive(0, 0, true);
  }

  divide(): void {
    const layout = divideStage(this.#divided());
    if (setLayout(this.view, layout)) this.#applyLayout(layout);
  }

  zoom(by: ZoomBy, at: Scroll | null): void {
    zoomStage(this.view, this.#divided(), by, at, this.robot);
    const { layout } = this.view.getState();
    if (layout !== null) this.#applyLayout(layout);
  }

  #divided(): StageRoom {
    const { size: maze, room: view, follows } = this;
    return { maze, view, showRulers: true, follows, zoom: this.view.getState().zoom };
  }

  #applyLayout(layout: Layout): void {
    // React applies the sizes to the elements before any other event.
    this.box.isScrolling = layout.overflows;
    this.box.most = {
      x: Math.max(0, layout.content.width - layout.view.width),
      y: Math.max(0, layout.content.height - layout.view.height),
    };
    applyScroll(this.view, this.box);
  }

  /** The robot appears at a share of the maze's width and height. */
  drive(right: number, down: number, isReset = false): void {
    const along = (share: number, cells: number) =>
      robotRadius + share * (cells * CELL - 2 * robotRadius);
    this.robot = { x: along(right, this.size.columns), y: along(down, this.size.rows) };
    const pose = { ...this.robot, heading: 90 };
    this.#frame = frameOf({
      snapshot: snapshotOf({ pose }),
      corners: isReset ? [pose.x, pose.y] : [],
      trailReset: isReset || this.#frame?.trailReset === true,
    });
    this.#renderer.frameArrived(this.#frame);
  }

  paint(): void {
    const paint = this.#paint;
    this.#paint = null;
    paint?.();
  }

  /** The page handles the painter's oldest request. */
  answer(): void {
    const scroll = this.#requests.shift();
    if (scroll !== undefined) followRequest(this.view, this.box, scroll);
  }

  /** The page handles a scroll event. */
  fireScroll(): void {
    if (!this.box.hasEvent) return;
    this.box.hasEvent = false;
    readScroll(this.view, this.box);
  }

  /** Handles events until none is pending. @throws Error if events remain */
  settle(): void {
    // A round handles one request, and the response to an outdated request can lead to a new one.
    const rounds = 20 + 2 * this.#requests.length;
    for (let round = 0; round < rounds; round++) {
      this.paint();
      this.answer();
      this.fireScroll();
      const isQuiet = this.#paint === null && this.#requests.length === 0 && !this.box.hasEvent;
      if (isQuiet) return;
    }
    throw new Error("the stage never comes to rest");
  }

  #show(): void {
    const { layout, scroll, answers } = this.view.getState();
    if (layout === null || this.#maze === null) return;
    this.#renderer.show({
      layout,
      scroll,
      answers,
      pixelRatio: 1,
      palette,
      maze: this.#maze,
      program: { format: "corridor/program", version: 1, name: "", default: "forward", rules: [] },
      startWord: "Start",
      goalWord: "Goal",
      showBeams: true,
      showTrail: true,
      showRulers: true,
      preview: null,
      measured: null,
      isCalm: this.isCalm,
    });
  }

  /** The position of the grid's corner in the view. */
  grid(): { x: number; y: number; width: number } {
    const { layout } = this.view.getState();
    if (layout === null) throw new Error("the stage has no layout");
    const pose = { ...this.robot, heading: 90 };
    const offset = gridOffset(this.#camera, layout, pose, this.isCalm, 1);
    return {
      x: layout.origin.x - this.box.scrollLeft + offset.x,
      y: layout.origin.y - this.box.scrollTop + offset.y,
      width: layout.cellPx * layout.columns,
    };
  }

  /** The position of the drawn maze's corner in the view. */
  drawn(): { x: number; y: number; width: number } {
    const { frame } = this.#recorder.drawn;
    if (frame === null) throw new Error("nothing was drawn");
    return { ...frame, width: Math.round(frame.width) };
  }

  robotSquare(): Cell {
    return { column: Math.floor(this.robot.x / CELL), row: Math.floor(this.robot.y / CELL) };
  }

  /** The square that a pointer on the drawn robot edits. */
  squareUnderPointer(): Cell | null {
    const { layout } = this.view.getState();
    if (layout === null) return null;
    const [drawn, grid] = [this.drawn(), this.grid()];
    const scale = layout.cellPx / CELL;
    return cellAt(
      layout,
      drawn.x + this.robot.x * scale - grid.x,
      drawn.y + this.robot.y * scale - grid.y,
    );
  }

  robotIsInView(): boolean {
    const { layout } = this.view.getState();
    if (layout === null) return false;
    const grid = this.grid();
    const scale = layout.cellPx / CELL;
    return isInPort(layout, grid.x + this.robot.x * scale, grid.y + this.robot.y * scale);
  }
}

const share = fc.double({ min: 0, max: 1, noNaN: true });
const side = fc.constantFrom(1, 3, 7, 11, 21, 37, 60, 256);
type Step = (stage: Stage) => void;
/** Steps of the page and its painter, in any order. */
const anyTurn = fc.constantFrom<Step>(
  (stage) => stage.paint(),
  (stage) => stage.answer(),
  (stage) => stage.fireScroll(),
);
const anyDrive = fc.tuple(share, share).map(
  ([x, y]): Step =>
    (stage) =>
      stage.drive(x, y),
);
const anyMaze = fc.tuple(side, side).map(
  ([columns, rows]): Step =>
    (stage) =>
      stage.openMaze(columns, rows),
);
const anyRoom = fc
  .record({
    width: fc.integer({ min: 200, max: 2000 }),
    height: fc.integer({ min: 108, max: 1400 }),
  })
  .map((room): Step => (stage) => {
    stage.room = room;
    stage.divide();
  });
const anyFollowing = fc.boolean().map((follows): Step => (stage) => {
  stage.follows = follows;
  stage.divide();
});
/** The user scrolls. */
const anyScroll = fc.tuple(share, share).map(
  ([x, y]): Step =>
    (stage) =>
      stage.box.scrollTo({ left: x * stage.box.most.x, top: y * stage.box.most.y }),
);
const anyZoom = fc
  .tuple(
    fc.oneof(
      fc.constantFrom<ZoomBy>("in", "out", "fit"),
      fc.record({ factor: fc.double({ min: 0.3, max: 3, noNaN: true }) }),
    ),
    fc.option(fc.tuple(share, share)),
  )
  .map(
    ([by, at]): Step =>
      (stage) =>
        stage.zoom(
          by,
          at === null ? null : { x: at[0] * stage.room.width, y: at[1] * stage.room.height },
        ),
  );
const anyStep = fc.oneof(anyTurn, anyDrive, anyMaze, anyRoom, anyFollowing, anyScroll, anyZoom);
/** All steps but the user's scrolling; mostly drives that the page cannot follow in time. */
const anyEvent = fc.oneof(
  { weight: 6, arbitrary: anyTurn },
  { weight: 4, arbitrary: anyDrive },
  { weight: 2, arbitrary: anyRoom },
  anyMaze,
  anyFollowing,
);

beforeEach(() => {
  vi.stubGlobal("Path2D", class {});
  return () => vi.unstubAllGlobals();
});

describe("the drawn maze, the grid and the pointer", () => {
  it("agree after any maze changes, resizes, scrolls and camera moves, and the robot comes into view", () => {
    fc.assert(
      fc.property(
        fc.array(anyStep, { maxLength: 30 }),
        fc.boolean(),
        share,
        share,
        (steps, isCalm, x, y) => {
          const stage = new Stage();
          stage.isCalm = isCalm;
          for (const step of steps) step(stage);
          stage.settle();
          expect(stage.drawn()).toEqual(stage.grid());
          expect(stage.squareUnderPointer()).toEqual(stage.robotSquare());
          stage.drive(x, y);
          // A robot that has not moved since the user scrolled does not scroll the view back.
          stage.settle();
          stage.drive(x < 0.5 ? x + 0.2 : x - 0.2, y);
          stage.settle();
          expect(stage.drawn()).toEqual(stage.grid());
          expect(stage.squareUnderPointer()).toEqual(stage.robotSquare());
          expect(stage.robotIsInView()).toBe(true);
        },
      ),
      { numRuns: 300 },
    );
  });

  it("keep the robot in view as long as the reader does not move the view", () => {
    fc.assert(
      fc.property(fc.array(anyEvent, { maxLength: 30 }), (steps) => {
        const stage = new Stage();
        for (const step of steps) step(stage);
        stage.settle();
        expect(stage.robotIsInView()).toBe(true);
      }),
      { numRuns: 1000 },
    );
  });

  it("keep the robot in view when a card makes the stage smaller while the robot drives fast", () => {
    const stage = new Stage();
    stage.openMaze(37, 37);
    stage.settle();
    // The page responds late, for a position that the robot has left.
    stage.drive(0.5, 0.9);
    stage.paint();
    stage.drive(0.5, 0.1);
    stage.room = { width: 1028, height: 600 };
    stage.divide();
    stage.settle();
    expect(stage.robotIsInView()).toBe(true);
  });

  it("agree after the robot has left the view more often than the page has answered", () => {
    const stage = new Stage();
    stage.openMaze(256, 256);
    stage.settle();
    for (let time = 0; time < 15; time++) {
      stage.drive(time % 2 === 0 ? 0.1 : 0.9, time / 15);
      stage.paint();
    }
    stage.settle();
    expect(stage.drawn()).toEqual(stage.grid());
    expect(stage.squareUnderPointer()).toEqual(stage.robotSquare());
    expect(stage.robotIsInView()).toBe(true);
  });

  it("agree when a small maze follows a large one that was scrolled, and when the large one is back", () => {
    const stage = new Stage();
    stage.openMaze(37, 37);
    stage.settle();
    stage.box.scrollTo({ left: 100, top: 300 });
    stage.settle();
    expect(stage.grid()).toMatchObject({ x: -30, y: -264 });
    stage.openMaze(11, 7);
    stage.settle();
    expect(stage.drawn()).toEqual(stage.grid());
    expect(stage.squareUnderPointer()).toEqual(stage.robotSquare());
    expect(stage.grid()).toMatchObject({ x: 70, y: 36 });
    expect(stage.robotIsInView()).toBe(true);
    stage.openMaze(37, 37);
    stage.settle();
    expect(stage.drawn()).toEqual(stage.grid());
    expect(stage.squareUnderPointer()).toEqual(stage.robotSquare());
    expect(stage.robotIsInView()).toBe(true);
  });

  it("agree after zooming, and the maze stays where the pointer is", () => {
    const stage = new Stage();
    stage.openMaze(37, 37);
    stage.settle();
    stage.drive(0.5, 0.5);
    stage.settle();
    const pointer = { x: 400, y: 300 };
    const unitsUnder = () => {
      const { x, y, width } = stage.grid();
      const scale = width / (37 * CELL);
      return { x: (pointer.x - x) / scale, y: (pointer.y - y) / scale };
    };
    const before = unitsUnder();
    stage.zoom({ factor: 1.7 }, pointer);
    stage.settle();
    expect(stage.drawn()).toEqual(stage.grid());
    expect(Math.abs(unitsUnder().x - before.x)).toBeLessThan(3);
    expect(Math.abs(unitsUnder().y - before.y)).toBeLessThan(3);
  });

  it.each([
    { by: "in", times: 3 },
    { by: "out", times: 2 },
    { by: "fit", times: 1 },
  ] as const)("keep the robot in view at $by", ({ by, times }) => {
    const stage = new Stage();
    stage.openMaze(60, 60);
    stage.drive(0.8, 0.7);
    stage.settle();
    stage.box.scrollTo({ left: 0, top: 0 });
    stage.settle();
    for (let time = 0; time < times; time++) stage.zoom(by, null);
    stage.settle();
    expect(stage.robotIsInView()).toBe(true);
    expect(stage.drawn()).toEqual(stage.grid());
  });
});
