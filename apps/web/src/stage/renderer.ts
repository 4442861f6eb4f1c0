/**
 * Paints the stage on three canvases. Each is redrawn only when it changes:
 *
 * - the static maze: once per maze, size, theme or scroll position
 * - the trail: each frame appends the new piece; at rest it is one line
 * - the robot with its beams
 *
 * At most one animation frame is requested at a time, and none while nothing changes. The class
 * depends on neither page nor worker and runs in both.
 */
import type { Snapshot } from "@corridor/protocol";
import { MAX_BUMPS, type Frame } from "./drawing/frame.ts";
import type { LayerCanvases } from "./drawing/drawing-context.ts";
import { Camera } from "./camera.ts";
import { bumpMarks, drawBumps, type BumpMark } from "./layers/bumps.ts";
import { recoilDirection, type Hit } from "./layers/hit.ts";
import { lateMarks } from "./layers/late-marks.ts";
import { loadMeasure, measureLayer } from "./layers/lazy-measure.ts";
import { drawLive, type DisplayedRun } from "./layers/live.ts";
import { drawPlaces } from "./layers/places.ts";
import { drawRulers } from "./layers/rulers.ts";
import { clearTextWidths } from "./layers/beam-labels.ts";
import { drawTrail } from "./layers/trail.ts";
import { drawWalls } from "./layers/walls.ts";
import { nudgeOffset, type Nudge } from "./nudge.ts";
import type { StageModel } from "./layers/stage-model.ts";
import { CanvasLayer } from "./layers/canvas-layer.ts";
import { isSamePicture, isSameSnapshot } from "./drawing/same-picture.ts";
import { Trail } from "./drawing/trail.ts";
import {
  followScroll,
  viewportAt,
  type Layout,
  type Scroll,
  type Viewport,
} from "./drawing/viewport.ts";

/** Environment of the renderer. */
export interface RendererPort {
  /** the newest frame, with the trail's growth since the last call; null before the first */
  takeFrame: () => Frame | null;
  requestFrame: (paint: () => void) => number;
  cancelFrame: (request: number) => void;
  /** monotonic milliseconds */
  now: () => number;
  /** scrolls the stage so that the robot stays visible */
  scrollTo: (scroll: Scroll) => void;
}

/** Frames at most this many ticks apart are consecutive. */
const RECENT_TICKS = 30;

type Layer = keyof LayerCanvases;

/** Fields of the stage model that each layer depends on. */
const parts: Record<Layer, readonly (keyof StageModel)[]> = {
  maze: [
    "layout",
    "scroll",
    "pixelRatio",
    "palette",
    "maze",
    "startWord",
    "goalWord",
    "showRulers",
  ],
  trail: ["layout", "scroll", "pixelRatio", "palette", "showTrail"],
  live: [
    "layout",
    "scroll",
    "pixelRatio",
    "palette",
    "maze",
    "program",
    "startWord",
    "goalWord",
    "showBeams",
    "showRulers",
    "preview",
    "measured",
  ],
};

export class StageRenderer {
  #layers: Record<Layer, CanvasLayer> | null = null;
  readonly #port: RendererPort;
  readonly #trail = new Trail();
  readonly #outdated = new Set<Layer>();
  #model: StageModel | null = null;
  readonly #camera = new Camera();
  /** position of the camera; null while the user scrolls the stage */
  #cameraScroll: Scroll | null = null;
  #frame: Frame | null = null;
  /** the snapshot whose numbers the page displays; null until the page has displayed one */
  #numbers: Snapshot | null = null;
  #hit: Hit | null = null;
  #nudge: Nudge | null = null;
  #bumps: BumpMark[] = [];
  #request: number | null = null;
  /** the layout in which the robot was last scrolled into view */
  #followed: Layout | null = null;
  /** the requested scroll position, until the page shows another stage model */
  #requested: Scroll | null = null;
  /** scroll requests that the page has not handled yet; the robot may have left their target */
  #pendingScrolls = 0;

  constructor(port: RendererPort) {
    this.#port = port;
  }

  /** Draws on these canvases from now on. Trail and stage model are retained. */
  attach(canvases: LayerCanvases): void {
    this.#layers = {
      maze: new CanvasLayer(canvases.maze),
      trail: new CanvasLayer(canvases.trail),
      live: new CanvasLayer(canvases.live),
    };
    this.#followed = null;
    this.#requested = null;
    this.#pendingScrolls = 0;
    this.repaint();
  }

  /** The canvases were removed: draws nothing until there are others. */
  detach(): void {
    if (this.#request !== null) this.#port.cancelFrame(this.#request);
    this.#request = null;
    this.#layers = null;
  }

  /** Shows another stage model. Only layers that depend on a changed field are redrawn. */
  show(model: StageModel): void {
    const before = this.#model;
    this.#model = model;
    if (before !== null && (before.layout !== model.layout || before.scroll !== model.scroll)) {
      // The answer may be for an older layout or an older pose, so the robot's position is checked
      // again.
      if (this.#pendingScrolls > 0) this.#followed = null;
      this.#pendingScrolls = Math.max(0, this.#pendingScrolls - (model.answers - before.answers));
      this.#requested = null;
    }
    for (const layer of layers) {
      if (before === null || parts[layer].some((part) => before[part] !== model[part])) {
        this.#outdated.add(layer);
      }
    }
    if (this.#outdated.size > 0) this.#requestPaint();
    if (model.measured !== null && measureLayer() === null) {
      // The page shows the length as text, too. If the file does not load, the tape is omitted, and
      // the next stage model tries again.
      loadMeasure().then(
        () => this.repaint(),
        () => undefined,
      );
    }
  }

  /** The page displays the numbers of this snapshot: the stage writes the same ones. */
  showNumbersOf(snapshot: Snapshot): void {
    const before = this.#numbers;
    this.#numbers = snapshot;
    if (before !== null && isSameSnapshot(before, snapshot)) return;
    this.#outdated.add("live");
    this.#requestPaint();
  }

  /** The page's font has loaded. */
  fontLoaded(): void {
    clearTextWidths();
    this.repaint();
  }

  /** Redraws everything. */
  repaint(): void {
    for (const layer of layers) this.#outdated.add(layer);
    this.#requestPaint();
  }

  /**
   * A new frame is available at the port. While a robot waits for a script, time passes in every
   * frame but nothing else changes: such frames are not painted.
   */
  frameArrived(frame: Frame): void {
    if (this.#frame === null || !isSamePicture(this.#frame, frame)) this.#requestPaint();
  }

  #requestPaint(): void {
    if (this.#layers === null) return;
    this.#request ??= this.#port.requestFrame(() => {
      this.#request = null;
      this.#paint();
    });
  }

  #paint(): void {
    const model = this.#model;
    const canvasLayers = this.#layers;
    if (model === null || canvasLayers === null) return;
    this.#takeFrame(model, this.#viewport(model), canvasLayers.trail);
    this.#pan(model);
    const viewport = this.#viewport(model);
    if (this.#followed !== null && isZoomOf(this.#followed, model.layout)) {
      // The user zoomed and chose what to see.
      this.#followed = model.layout;
    }
    if (this.#frame !== null && this.#followed !== model.layout) {
      // A maze that no longer fits starts at the robot, even if the robot stands still.
      this.#follow(model, this.#frame.snapshot.pose);
    }
    if (this.#outdated.has("maze")) paintMaze(canvasLayers.maze, model, viewport, this.#frame);
    if (this.#outdated.has("trail")) {
      paintTrail(canvasLayers.trail, model, viewport, this.#trail);
      paintBumps(canvasLayers.trail, model, viewport, this.#bumps);
    }
    if (this.#outdated.has("live")) {
      canvasLayers.live.erase(model);
      drawLive(canvasLayers.live, viewport, model, this.#displayed());
    }
    this.#outdated.clear();
    if (this.#nudge !== null) {
      this.#outdated.add("live");
      this.#requestPaint();
    }
  }

  #displayed(): DisplayedRun | null {
    const frame = this.#frame;
    if (frame === null) return null;
    const nudge = this.#nudge === null ? null : nudgeOffset(this.#nudge, this.#port.now());
    if (nudge === null) this.#nudge = null;
    const numbers = this.#numbers ?? frame.snapshot;
    return { frame, numbers, hit: this.#hit, nudge: nudge ?? { x: 0, y: 0 } };
  }

  #takeFrame(model: StageModel, viewport: Viewport, layer: CanvasLayer): void {
    const frame = this.#port.takeFrame();
    if (frame === null) return;
    const before = this.#frame;
    this.#frame = frame;
    const change = this.#trail.add(frame.corners, frame.snapshot.pose, frame.trailReset);
    if (frame.trailReset) {
      this.#bumps = [];
      this.#hit = null;
      this.#nudge = null;
    }
    const bumps = bumpMarks(model.maze, frame.bumps, frame.snapshot.pose.heading);
    if (bumps.length > 0) {
      this.#bumps = [...this.#bumps, ...bumps].slice(-MAX_BUMPS);
      if (change.kind !== "replaced") paintBumps(layer, model, viewport, bumps);
      this.#hit = hitOf(frame, before);
    }
    if (before === null || !isSamePicture(before, frame)) this.#outdated.add("live");
    if (before?.marks !== frame.marks) this.#outdated.add("maze");
    if (!model.isCalm && before !== null && !frame.trailReset && frame.view !== "past") {
      this.#startNudge(model, frame, before);
    }
    // The pieces overlap, and their anti-aliased edges add up: a trail drawn in pieces looks
    // broader.
    const hasStopped = before?.snapshot.state === "running" && frame.snapshot.state !== "running";
    if (hasStopped && model.showTrail) this.#outdated.add("trail");
    if (change.kind === "none") return;
    this.#follow(model, frame.snapshot.pose);
    if (change.kind === "replaced") {
      this.#outdated.add("trail");
    } else if (model.showTrail && !this.#outdated.has("trail")) {
      layer.clipped(viewport.port, () => {
        drawTrail(layer.context, viewport, model.palette, change.points, "butt");
      });
    }
  }

  /** Starts the recoil at a bump and the hop on the goal. */
  #startNudge(model: StageModel, frame: Frame, before: Frame): void {
    const startedAt = this.#port.now();
    if (frame.bumps.length > 0 && this.#hit !== null) {
      this.#nudge = { kind: "recoil", ...recoilDirection(model.maze, this.#hit), startedAt };
    } else if (frame.snapshot.goalReached && !before.snapshot.goalReached) {
      this.#nudge = { kind: "hop", dx: 0, dy: 0, startedAt };
    }
  }

  #viewport({ layout, scroll }: StageModel): Viewport {
    return viewportAt(layout, this.#cameraScroll ?? scroll);
  }

  /** Moves the camera with the robot, which makes every layer outdated. */
  #pan({ layout, isCalm, pixelRatio }: StageModel): void {
    const pose = this.#frame?.snapshot.pose;
    const before = this.#cameraScroll;
    this.#cameraScroll =
      layout.follows && pose !== undefined
        ? this.#camera.at(layout, pose, isCalm, 1 / pixelRatio)
        : null;
    if (this.#cameraScroll === before) return;
    for (const layer of layers) this.#outdated.add(layer);
  }

  #follow({ layout, scroll }: StageModel, pose: Snapshot["pose"]): void {
    this.#followed = layout;
    if (!layout.overflows) return;
    const next = followScroll(layout, scroll, pose.x, pose.y);
    if (isSame(next, scroll) || (this.#requested !== null && isSame(next, this.#requested))) return;
    // The page may take a moment to scroll, so the request is sent once.
    this.#requested = next;
    this.#pendingScrolls += 1;
    this.#port.scrollTo(next);
  }
}

const layers = Object.keys(parts) as Layer[];

function paintMaze(
  layer: CanvasLayer,
  model: StageModel,
  viewport: Viewport,
  frame: Frame | null,
): void {
  layer.reset(model);
  layer.clipped(viewport.port, () => {
    drawWalls(layer.context, viewport, model.palette, model.maze);
    if (frame?.marks) lateMarks.draw?.(layer.context, viewport, model.palette, frame.marks);
    drawPlaces(layer.context, viewport, model.palette, model.maze, model);
  });
  if (model.showRulers) drawRulers(layer.context, viewport, model.palette);
}

function paintTrail(layer: CanvasLayer, model: StageModel, viewport: Viewport, trail: Trail): void {
  layer.reset(model);
  if (!model.showTrail) return;
  layer.clipped(viewport.port, () => {
    drawTrail(layer.context, viewport, model.palette, trail.points(), "round");
  });
}

/**
 * Bumps share the trail's canvas: the robot's centre is never close to a wall, so neither covers
 * the other.
 */
function paintBumps(
  layer: CanvasLayer,
  model: StageModel,
  viewport: Viewport,
  bumps: readonly BumpMark[],
): void {
  if (!model.showTrail) return;
  layer.clipped(viewport.port, () => drawBumps(layer.context, viewport, model.palette, bumps));
}

/** The newest bump. Its `wanted` is the distance that was left in the frame before. */
function hitOf({ bumps, snapshot }: Frame, before: Frame | null): Hit {
  const [x = 0, y = 0] = bumps.slice(-2);
  const isNext = before !== null && snapshot.tick - before.snapshot.tick < RECENT_TICKS;
  const progress = isNext ? before.progress : null;
  const wanted = progress?.kind === "drive" ? progress.left : null;
  return { pose: { x, y, heading: snapshot.pose.heading }, wanted };
}

/** Whether two layouts differ only in the size of their cells. */
function isZoomOf(a: Layout, b: Layout): boolean {
  return (
    a.columns === b.columns &&
    a.rows === b.rows &&
    a.view.width === b.view.width &&
    a.view.height === b.view.height &&
    a.cellPx !== b.cellPx
  );
}

/** Browsers round scroll positions to device pixels. */
const isSame = (a: Scroll, b: Scroll): boolean =>
  Math.abs(a.x - b.x) < 1 && Math.abs(a.y - b.y) < 1;
