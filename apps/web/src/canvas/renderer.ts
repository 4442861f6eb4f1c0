/**
 * Paints the stage on three canvases, each redrawn only when what it shows has changed:
 * the still maze (once a maze, size, theme or scroll position), the trail (each frame appends the
 * new piece), and the robot with its beams. One animation frame is asked for at a time, and none
 * while nothing changes.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import type { Frame } from "../worker/worker-messages.ts";
import { drawBeams } from "./layers/beams.ts";
import { bumpMark, drawBumps, type BumpMark } from "./layers/bumps.ts";
import { drawGhost, type Ghost } from "./layers/ghost.ts";
import { drawPlaces, type PlaceWords } from "./layers/places.ts";
import { drawRobot, faceOf } from "./layers/robot.ts";
import { drawRulerMarks, drawRulers } from "./layers/rulers.ts";
import { drawTags } from "./layers/tags.ts";
import { drawTrail } from "./layers/trail.ts";
import { drawWalls } from "./layers/walls.ts";
import type { Palette } from "./palette.ts";
import { limitsOf, litSensors } from "./running-line.ts";
import { Trail } from "./trail.ts";
import { followScroll, viewportAt, type Layout, type Scroll, type Viewport } from "./viewport.ts";

/** The three canvases, back to front. */
export interface LayerCanvases {
  maze: HTMLCanvasElement;
  trail: HTMLCanvasElement;
  live: HTMLCanvasElement;
}

/** All that is drawn besides the robot; handed over whole, compared field by field. */
export interface Scene extends PlaceWords {
  layout: Layout;
  /** device pixels per CSS pixel */
  pixelRatio: number;
  palette: Palette;
  maze: MazeDocument;
  program: ProgramDocument;
  showBeams: boolean;
  showTrail: boolean;
  showRulers: boolean;
  ghost: Ghost | null;
}

/** What the renderer needs from around it. */
export interface RendererPort {
  /** the newest frame, with what the trail gained since the last call; null before the first */
  takeFrame: () => Frame | null;
  requestFrame: (paint: () => void) => number;
  cancelFrame: (request: number) => void;
  /** scrolls the stage so that the robot stays in sight */
  scrollTo: (scroll: Scroll) => void;
}

/** Bumps that stay marked, the newest. */
const MAX_BUMPS = 100;

type Layer = keyof LayerCanvases;

/** Fields of the scene that make each layer's picture. */
const parts: Record<Layer, readonly (keyof Scene)[]> = {
  maze: ["layout", "pixelRatio", "palette", "maze", "startWord", "goalWord", "showRulers"],
  trail: ["layout", "pixelRatio", "palette", "showTrail"],
  live: [
    "layout",
    "pixelRatio",
    "palette",
    "program",
    "startWord",
    "goalWord",
    "showBeams",
    "showTrail",
    "showRulers",
    "ghost",
  ],
};

export class StageRenderer {
  readonly #canvases: LayerCanvases;
  readonly #port: RendererPort;
  readonly #trail = new Trail();
  readonly #stale = new Set<Layer>();
  #scene: Scene | null = null;
  #scroll: Scroll = { x: 0, y: 0 };
  #snapshot: Snapshot | null = null;
  #bumps: BumpMark[] = [];
  #request: number | null = null;
  /** the division of the stage in which the robot was last brought into sight */
  #followed: Layout | null = null;

  constructor(canvases: LayerCanvases, port: RendererPort) {
    this.#canvases = canvases;
    this.#port = port;
  }

  /** Shows another scene. Only layers whose part of it differs are drawn again. */
  show(scene: Scene): void {
    const before = this.#scene;
    this.#scene = scene;
    for (const layer of layers) {
      if (before === null || parts[layer].some((part) => before[part] !== scene[part])) {
        this.#stale.add(layer);
      }
    }
    if (this.#stale.size > 0) this.#ask();
  }

  /** Shows another part of a maze that is larger than the view. */
  scrollTo(scroll: Scroll): void {
    if (scroll.x === this.#scroll.x && scroll.y === this.#scroll.y) return;
    this.#scroll = scroll;
    for (const layer of layers) this.#stale.add(layer);
    this.#ask();
  }

  /** A new frame waits at the port. */
  frameArrived(): void {
    this.#ask();
  }

  /** The robot has touched a wall. */
  bumped(pose: Snapshot["pose"]): void {
    if (this.#scene === null) return;
    this.#bumps = [...this.#bumps, bumpMark(this.#scene.maze, pose)].slice(-MAX_BUMPS);
    this.#stale.add("live");
    this.#ask();
  }

  /** Where the robot was when it was last drawn; null before the first frame. */
  pose(): Snapshot["pose"] | null {
    return this.#snapshot?.pose ?? null;
  }

  /** Stops drawing for good. */
  destroy(): void {
    if (this.#request !== null) this.#port.cancelFrame(this.#request);
    this.#scene = null;
  }

  #ask(): void {
    this.#request ??= this.#port.requestFrame(() => {
      this.#request = null;
      this.#paint();
    });
  }

  #paint(): void {
    const scene = this.#scene;
    if (scene === null) return;
    const viewport = viewportAt(scene.layout, this.#scroll);
    this.#takeFrame(scene, viewport);
    if (this.#snapshot !== null && this.#followed !== scene.layout) {
      // A maze that no longer fits begins where the robot is, even while it stands still.
      this.#follow(scene.layout, this.#snapshot.pose);
    }
    if (this.#stale.has("maze")) this.#paintMaze(scene, viewport);
    if (this.#stale.has("trail")) this.#paintTrail(scene, viewport);
    if (this.#stale.has("live")) this.#paintLive(scene, viewport);
    this.#stale.clear();
  }

  #takeFrame(scene: Scene, viewport: Viewport): void {
    const frame = this.#port.takeFrame();
    if (frame === null) return;
    const before = this.#snapshot;
    this.#snapshot = frame.snapshot;
    const change = this.#trail.add(frame.corners, frame.snapshot.pose, frame.trailReset);
    if (frame.trailReset) this.#bumps = [];
    if (before !== frame.snapshot) this.#stale.add("live");
    if (change.kind === "none") return;
    this.#follow(scene.layout, frame.snapshot.pose);
    if (change.kind === "replaced") {
      this.#stale.add("trail");
    } else if (scene.showTrail && !this.#stale.has("trail")) {
      const context = contextOf(this.#canvases.trail);
      clipped(context, viewport, () => {
        drawTrail(context, viewport, scene.palette, change.points, "butt");
      });
    }
  }

  #follow(layout: Layout, pose: Snapshot["pose"]): void {
    this.#followed = layout;
    if (!layout.overflows) return;
    const scroll = followScroll(layout, this.#scroll, pose.x, pose.y);
    if (scroll.x !== this.#scroll.x || scroll.y !== this.#scroll.y) this.#port.scrollTo(scroll);
  }

  #paintMaze(scene: Scene, viewport: Viewport): void {
    const context = fresh(this.#canvases.maze, scene);
    clipped(context, viewport, () => {
      drawWalls(context, viewport, scene.palette, scene.maze);
      drawPlaces(context, viewport, scene.palette, scene.maze, scene);
    });
    if (scene.showRulers) drawRulers(context, viewport, scene.palette);
  }

  #paintTrail(scene: Scene, viewport: Viewport): void {
    const context = fresh(this.#canvases.trail, scene);
    if (!scene.showTrail) return;
    clipped(context, viewport, () => {
      drawTrail(context, viewport, scene.palette, this.#trail.points(), "round");
    });
  }

  #paintLive(scene: Scene, viewport: Viewport): void {
    const context = fresh(this.#canvases.live, scene);
    const snapshot = this.#snapshot;
    clipped(context, viewport, () => {
      if (scene.ghost !== null) {
        drawGhost(context, viewport, scene.palette, scene.ghost, scene);
      }
      if (snapshot === null) return;
      if (scene.showTrail) drawBumps(context, viewport, scene.palette, this.#bumps);
      const lit = litSensors(scene.program, snapshot);
      if (scene.showBeams) drawBeams(context, viewport, scene.palette, snapshot, lit);
      drawRobot(context, viewport, scene.palette, snapshot.pose, faceOf(snapshot));
      if (scene.showBeams) {
        const limits = limitsOf(scene.program, snapshot);
        drawTags(context, viewport, scene.palette, snapshot, lit, limits);
      }
    });
    if (snapshot !== null && scene.showRulers) {
      drawRulerMarks(context, viewport, scene.palette, snapshot.pose);
    }
  }
}

const layers = Object.keys(parts) as Layer[];

/** An empty canvas of the scene's size whose unit is the CSS pixel. */
function fresh(canvas: HTMLCanvasElement, scene: Scene): CanvasRenderingContext2D {
  const context = contextOf(canvas);
  const { view } = scene.layout;
  const width = Math.round(view.width * scene.pixelRatio);
  const height = Math.round(view.height * scene.pixelRatio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  context.setTransform(scene.pixelRatio, 0, 0, scene.pixelRatio, 0, 0);
  context.clearRect(0, 0, view.width, view.height);
  return context;
}

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext("2d");
  if (context === null) throw new Error("This browser gives no 2D canvas.");
  return context;
}

/** Pixels around the port in which outlines of the frame may still show. */
const OUTLINE = 2;

/** Draws inside the port only, so that a maze that is scrolled stays off the rulers. */
function clipped(context: CanvasRenderingContext2D, { port }: Viewport, draw: () => void): void {
  context.save();
  context.beginPath();
  context.rect(
    port.x - OUTLINE,
    port.y - OUTLINE,
    port.width + 2 * OUTLINE,
    port.height + 2 * OUTLINE,
  );
  context.clip();
  draw();
  context.restore();
}
