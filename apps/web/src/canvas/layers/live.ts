/** Everything that moves with the run, in one picture: ghost, way ahead, beams, robot, tags, ruler marks, tape. */
import type { Snapshot } from "@corridor/protocol";
import { limitsOf, litSensors } from "../running-line.ts";
import { endOf } from "../path-ahead.ts";
import type { Scene } from "../scene.ts";
import type { Surface } from "../surface.ts";
import { runBox, type Viewport } from "../viewport.ts";
import type { Frame } from "../../worker/worker-messages.ts";
import { drawBeams } from "./beams.ts";
import { drawGhost } from "./ghost.ts";
import { drawHit, hitSensor, isAtHit, type Hit } from "./hit.ts";
import { measureLayer } from "./lazy-measure.ts";
import { raceGhostsLayer } from "./lazy-race-ghosts.ts";
import { drawJoy, isOnReachedGoal } from "./joy.ts";
import { drawOutline, drawPath } from "./path.ts";
import { drawRadius, drawRadiusLabel } from "./radius.ts";
import { drawRobot, faceOf } from "./robot.ts";
import { drawRulerMarks } from "./rulers.ts";
import { drawTags } from "./tags.ts";

/** The run as it is to be drawn. */
export interface Shown {
  frame: Frame;
  /** the snapshot whose numbers the page displays; robot and beams may be some ticks further */
  numbers: Snapshot;
  /** the newest bump; null when there is none */
  hit: Hit | null;
  /** pixels by which the robot is drawn beside its place, for a moment */
  nudge: { x: number; y: number };
}

/** Draws the live layer over what was wiped. @param shown null before the first frame */
export function drawLive(
  surface: Surface,
  viewport: Viewport,
  scene: Scene,
  shown: Shown | null,
): void {
  const { brush, dirt } = surface;
  const { palette } = scene;
  surface.clipped(runBox(viewport), () => {
    if (scene.ghost !== null) drawGhost(brush, viewport, palette, scene.ghost, scene, dirt);
    if (shown !== null) drawRun(surface, viewport, scene, shown);
    if (scene.measured !== null) measureLayer()?.(brush, viewport, palette, scene.measured, dirt);
  });
  if (shown === null) return;
  // Below the numbers: beside the frame both may have the same place.
  if (scene.showRulers) {
    drawRulerMarks(brush, viewport, palette, shown.frame.snapshot.pose, dirt);
  }
  drawNumbers(surface, viewport, scene, shown);
}

/** The bump at which the robot stands. */
function hitAt({ hit, frame }: Shown): Hit | null {
  return isAtHit(hit, frame.snapshot.pose) ? hit : null;
}

/** On a reached goal nothing is left to be measured, and the goal is in sight. */
function isJoyful({ maze }: Scene, shown: Shown): boolean {
  return hitAt(shown) === null && isOnReachedGoal(maze, shown.frame.snapshot);
}

function drawRun(surface: Surface, viewport: Viewport, scene: Scene, shown: Shown): void {
  const { brush, dirt } = surface;
  const { palette, maze, program } = scene;
  const { snapshot, progress, ghosts } = shown.frame;
  const { pose } = snapshot;
  const hit = hitAt(shown);
  if (hit !== null) drawHit(brush, viewport, palette, maze, hit, dirt);
  if (isJoyful(scene, shown)) {
    drawJoy(brush, viewport, palette, pose, dirt);
  } else if (scene.showBeams) {
    drawBeams(brush, viewport, palette, snapshot, litSensors(program, shown.numbers), dirt);
  }
  if (ghosts !== undefined) raceGhostsLayer()?.(brush, viewport, palette, ghosts, dirt);
  drawPath(brush, viewport, palette, pose, progress, dirt);
  const end = snapshot.driver === "remote" ? endOf(pose, progress) : null;
  if (end !== null) drawOutline(brush, viewport, palette.liveInk, end, dirt);
  const face = hit === null ? faceOf(snapshot) : "bumped";
  drawRobot(brush, viewport, palette, pose, face, dirt, shown.nudge);
}

/** Numbers may stand outside of the maze: a robot in its corner has no room for them inside. */
function drawNumbers(surface: Surface, viewport: Viewport, scene: Scene, shown: Shown): void {
  const { brush, dirt } = surface;
  const { palette, maze, program, showBeams } = scene;
  const { numbers } = shown;
  const { snapshot } = shown.frame;
  const hit = hitAt(shown);
  const bumped = hit === null ? null : hitSensor(maze, hit, snapshot);
  const drawMeasured = ({ pose }: Hit) =>
    surface.clipped(runBox(viewport), () => drawRadius(brush, viewport, palette, maze, pose, dirt));
  const measure = hit === null ? null : drawMeasured(hit);
  const areReadingsShown = showBeams && !isJoyful(scene, shown);
  // A red reading already says it.
  const needsLabel = measure !== null && !(areReadingsShown && bumped !== null);
  const label = needsLabel ? drawRadiusLabel(brush, viewport, palette, measure, dirt) : null;
  if (!areReadingsShown) return;
  drawTags(brush, viewport, palette, snapshot, dirt, {
    lit: litSensors(program, numbers),
    limits: limitsOf(program, numbers),
    bumped,
    sensors: numbers.sensors,
    goals: maze.goals,
    taken: label === null ? [] : [label],
  });
}
