/**
 * Paints the stage on three canvases, each redrawn only when what it shows has changed: the still maze
 * (once a maze, size, theme or scroll position), the trail (each frame appends the new piece; at rest it
 * is one line), and the robot with its beams. One animation frame is asked for at a time, and none
 * while nothing changes. Knows neither page nor worker: it runs in both.
 */
import type { Snapshot } from "@corridor/protocol";
import type { Frame } from "../worker/worker-messages.ts";
import type { LayerCanvases } from "./brush.ts";
import { Camera } from "./camera.ts";
import { bumpMarks, drawBumps, type BumpMark } from "./layers/bumps.ts";
import { awayFrom, type Hit } from "./layers/hit.ts";
import { loadMeasure, measureLayer } from "./layers/lazy-measure.ts";
import { drawLive, type Shown } from "./layers/live.ts";
import { drawPlaces } from "./layers/places.ts";
import { drawRulers } from "./layers/rulers.ts";
import { forgetTextWidths } from "./layers/tags.ts";
import { drawTrail } from "./layers/trail.ts";
import { drawWalls } from "./layers/walls.ts";
import { nudgeOffset, type Nudge } from "./nudge.ts";
import type { Scene } from "./scene.ts";
import { Surface } from "./surface.ts";
import { Trail } from "./trail.ts";
import { followScroll, viewportAt, type Layout, type Scroll, type Viewport } from "./viewport.ts";

/** What the renderer needs from around it. */
export interface RendererPort {
  /** the newest frame, with what the trail gained since the last call; null before the first */
  takeFrame: () => Frame | null;
  requestFrame: (paint: () => void) => number;
  cancelFrame: (request: number) => void;
  /** monotonic milliseconds */
  now: () => number;
  /** scrolls the stage so that the robot stays in sight */
  scrollTo: (scroll: Scroll) => void;
}

/** Frames at most so many ticks apart follow one another. */
const RECENT_TICKS = 30;
/** Bumps that stay marked, the newest. */
const MAX_BUMPS = 100;

type Layer = keyof LayerCanvases;

/** Fields of the scene that make each layer's picture. */
const parts: Record<Layer, readonly (keyof Scene)[]> = {
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
    "ghost",
    "measured",
  ],
};

export class StageRenderer {
  #surfaces: Record<Layer, Surface> | null = null;
  readonly #port: RendererPort;
  readonly #trail = new Trail();
  readonly #stale = new Set<Layer>();
  #scene: Scene | null = null;
  readonly #camera = new Camera();
  /** where the camera stands; null while the stage is scrolled */
  #panned: Scroll | null = null;
  #frame: Frame | null = null;
  /** the snapshot whose numbers the page displays; null until the page has displayed one */
  #numbers: Snapshot | null = null;
  #hit: Hit | null = null;
  #nudge: Nudge | null = null;
  #bumps: BumpMark[] = [];
  #request: number | null = null;
  /** the division of the stage in which the robot was last brought into sight */
  #followed: Layout | null = null;
  /** the requested scroll position, until the page shows another scene */
  #asked: Scroll | null = null;
  /** requests to scroll that the page has not handled yet: they may be for places that the robot has left */
  #unanswered = 0;

  constructor(port: RendererPort) {
    this.#port = port;
  }

  /** Draws on these canvases from now on; the trail and the scene so far stay. */
  attach(canvases: LayerCanvases): void {
    this.#surfaces = {
      maze: new Surface(canvases.maze),
      trail: new Surface(canvases.trail),
      live: new Surface(canvases.live),
    };
    this.#followed = null;
    this.#asked = null;
    this.#unanswered = 0;
    this.repaint();
  }

  /** The canvases are gone: draws nothing until there are others. */
  detach(): void {
    if (this.#request !== null) this.#port.cancelFrame(this.#request);
    this.#request = null;
    this.#surfaces = null;
  }

  /** Shows another scene. Only layers whose part of it differs are drawn again. */
  show(scene: Scene): void {
    const before = this.#scene;
    this.#scene = scene;
    if (before !== null && (before.layout !== scene.layout || before.scroll !== scene.scroll)) {
      // An answer may be for an older layout or an older place of the robot, so its place is checked again.
      if (this.#unanswered > 0) this.#followed = null;
      this.#unanswered = Math.max(0, this.#unanswered - (scene.answers - before.answers));
      this.#asked = null;
    }
    for (const layer of layers) {
      if (before === null || parts[layer].some((part) => before[part] !== scene[part])) {
        this.#stale.add(layer);
      }
    }
    if (this.#stale.size > 0) this.#ask();
    if (scene.measured !== null && measureLayer() === null) {
      // Words say the length, too: without its file the tape is left out, and the next scene asks again.
      loadMeasure().then(
        () => this.repaint(),
        () => undefined,
      );
    }
  }

  /** The page displays the numbers of this snapshot: the stage writes the same ones. */
  showNumbersOf(snapshot: Snapshot): void {
    this.#numbers = snapshot;
    this.#stale.add("live");
    this.#ask();
  }

  /** The font that was waited for is there. */
  fontArrived(): void {
    forgetTextWidths();
    this.repaint();
  }

  /** Draws everything anew. */
  repaint(): void {
    for (const layer of layers) this.#stale.add(layer);
    this.#ask();
  }

  /** A new frame waits at the port. */
  frameArrived(): void {
    this.#ask();
  }

  #ask(): void {
    if (this.#surfaces === null) return;
    this.#request ??= this.#port.requestFrame(() => {
      this.#request = null;
      this.#paint();
    });
  }

  #paint(): void {
    const scene = this.#scene;
    const surfaces = this.#surfaces;
    if (scene === null || surfaces === null) return;
    this.#takeFrame(scene, this.#viewport(scene), surfaces.trail);
    this.#pan(scene);
    const viewport = this.#viewport(scene);
    if (this.#followed !== null && isZoomOf(this.#followed, scene.layout)) {
      // The reader chose what to see.
      this.#followed = scene.layout;
    }
    if (this.#frame !== null && this.#followed !== scene.layout) {
      // A maze that no longer fits begins where the robot is, even while it stands still.
      this.#follow(scene, this.#frame.snapshot.pose);
    }
    if (this.#stale.has("maze")) paintMaze(surfaces.maze, scene, viewport);
    if (this.#stale.has("trail")) {
      paintTrail(surfaces.trail, scene, viewport, this.#trail);
      paintBumps(surfaces.trail, scene, viewport, this.#bumps);
    }
    if (this.#stale.has("live")) {
      surfaces.live.wipe(scene);
      drawLive(surfaces.live, viewport, scene, this.#shown());
    }
    this.#stale.clear();
    if (this.#nudge !== null) {
      this.#stale.add("live");
      this.#ask();
    }
  }

  #shown(): Shown | null {
    const frame = this.#frame;
    if (frame === null) return null;
    const nudge = this.#nudge === null ? null : nudgeOffset(this.#nudge, this.#port.now());
    if (nudge === null) this.#nudge = null;
    const numbers = this.#numbers ?? frame.snapshot;
    return { frame, numbers, hit: this.#hit, nudge: nudge ?? { x: 0, y: 0 } };
  }

  #takeFrame(scene: Scene, viewport: Viewport, surface: Surface): void {
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
    const bumps = bumpMarks(scene.maze, frame.bumps, frame.snapshot.pose.heading);
    if (bumps.length > 0) {
      this.#bumps = [...this.#bumps, ...bumps].slice(-MAX_BUMPS);
      if (change.kind !== "replaced") paintBumps(surface, scene, viewport, bumps);
      this.#hit = hitOf(frame, before);
    }
    if (before?.snapshot !== frame.snapshot) this.#stale.add("live");
    if (!scene.isCalm && before !== null && !frame.trailReset && frame.view !== "past") {
      this.#startNudge(scene, frame, before);
    }
    // Its pieces overlap, and their soft edges add up: what was drawn piece by piece is broader.
    const hasStopped = before?.snapshot.state === "running" && frame.snapshot.state !== "running";
    if (hasStopped && scene.showTrail) this.#stale.add("trail");
    if (change.kind === "none") return;
    this.#follow(scene, frame.snapshot.pose);
    if (change.kind === "replaced") {
      this.#stale.add("trail");
    } else if (scene.showTrail && !this.#stale.has("trail")) {
      surface.clipped(viewport.port, () => {
        drawTrail(surface.brush, viewport, scene.palette, change.points, "butt");
      });
    }
  }

  /** The robot recoils when it bumps and hops when it reaches the goal. */
  #startNudge(scene: Scene, frame: Frame, before: Frame): void {
    const startedAt = this.#port.now();
    if (frame.bumps.length > 0 && this.#hit !== null) {
      this.#nudge = { kind: "recoil", ...awayFrom(scene.maze, this.#hit), startedAt };
    } else if (frame.snapshot.goalReached && !before.snapshot.goalReached) {
      this.#nudge = { kind: "hop", dx: 0, dy: 0, startedAt };
    }
  }

  #viewport({ layout, scroll }: Scene): Viewport {
    return viewportAt(layout, this.#panned ?? scroll);
  }

  /** Moves the camera with the robot; whatever it shows is drawn anew then. */
  #pan({ layout, isCalm, pixelRatio }: Scene): void {
    const pose = this.#frame?.snapshot.pose;
    const before = this.#panned;
    this.#panned =
      layout.follows && pose !== undefined
        ? this.#camera.at(layout, pose, isCalm, 1 / pixelRatio)
        : null;
    if (this.#panned === before) return;
    for (const layer of layers) this.#stale.add(layer);
  }

  #follow({ layout, scroll }: Scene, pose: Snapshot["pose"]): void {
    this.#followed = layout;
    if (!layout.overflows) return;
    const next = followScroll(layout, scroll, pose.x, pose.y);
    if (isSame(next, scroll) || (this.#asked !== null && isSame(next, this.#asked))) return;
    // The page may take a moment to get there; it is asked once.
    this.#asked = next;
    this.#unanswered += 1;
    this.#port.scrollTo(next);
  }
}

const layers = Object.keys(parts) as Layer[];

function paintMaze(surface: Surface, scene: Scene, viewport: Viewport): void {
  surface.renew(scene);
  surface.clipped(viewport.port, () => {
    drawWalls(surface.brush, viewport, scene.palette, scene.maze);
    drawPlaces(surface.brush, viewport, scene.palette, scene.maze, scene);
  });
  if (scene.showRulers) drawRulers(surface.brush, viewport, scene.palette);
}

function paintTrail(surface: Surface, scene: Scene, viewport: Viewport, trail: Trail): void {
  surface.renew(scene);
  if (!scene.showTrail) return;
  surface.clipped(viewport.port, () => {
    drawTrail(surface.brush, viewport, scene.palette, trail.points(), "round");
  });
}

/** They share the trail's canvas: the robot's centre keeps away from walls, so neither covers the other. */
function paintBumps(
  surface: Surface,
  scene: Scene,
  viewport: Viewport,
  bumps: readonly BumpMark[],
): void {
  if (!scene.showTrail) return;
  surface.clipped(viewport.port, () => drawBumps(surface.brush, viewport, scene.palette, bumps));
}

/** The newest bump. What the robot still wanted to drive is what was left right before it. */
function hitOf({ bumps, snapshot }: Frame, before: Frame | null): Hit {
  const [x = 0, y = 0] = bumps.slice(-2);
  const isNext = before !== null && snapshot.tick - before.snapshot.tick < RECENT_TICKS;
  const progress = isNext ? before.progress : null;
  const wanted = progress?.kind === "drive" ? progress.left : null;
  return { pose: { x, y, heading: snapshot.pose.heading }, wanted };
}

/** Whether two layouts differ in the size of their squares alone. */
function isZoomOf(a: Layout, b: Layout): boolean {
  return (
    a.columns === b.columns &&
    a.rows === b.rows &&
    a.view.width === b.view.width &&
    a.view.height === b.view.height &&
    a.cellPx !== b.cellPx
  );
}

/** Browsers round scroll positions to pixels of the device. */
const isSame = (a: Scroll, b: Scroll): boolean =>
  Math.abs(a.x - b.x) < 1 && Math.abs(a.y - b.y) < 1;
