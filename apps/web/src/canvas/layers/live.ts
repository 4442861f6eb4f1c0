/** Everything that moves with the run, in one picture: ghost, way ahead, beams, robot, tags, ruler marks, tape. */
import type { Snapshot } from "@corridor/protocol";
import { limitsOf, litSensors } from "../running-line.ts";
import { endOf } from "../path-ahead.ts";
import type { Scene } from "../scene.ts";
import type { Surface } from "../surface.ts";
import type { Viewport } from "../viewport.ts";
import type { Frame } from "../../worker/worker-messages.ts";
import { drawBeams } from "./beams.ts";
import { drawGhost } from "./ghost.ts";
import { drawHit, hitSensor, isAtHit, type Hit } from "./hit.ts";
import { raceGhostsLayer } from "./lazy-race-ghosts.ts";
import { drawJoy, isOnReachedGoal } from "./joy.ts";
import { drawMeasure } from "./measure.ts";
import { drawOutline, drawPath } from "./path.ts";
import { drawRadius } from "./radius.ts";
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
  surface.clipped(viewport.paper, () => {
    if (scene.ghost !== null) drawGhost(brush, viewport, scene.palette, scene.ghost, scene, dirt);
    if (shown !== null) drawRun(surface, viewport, scene, shown);
    if (scene.measured !== null) drawMeasure(brush, viewport, scene.palette, scene.measured, dirt);
  });
  if (shown !== null && scene.showRulers) {
    drawRulerMarks(brush, viewport, scene.palette, shown.frame.snapshot.pose, dirt);
  }
}

function drawRun(surface: Surface, viewport: Viewport, scene: Scene, shown: Shown): void {
  const { brush, dirt } = surface;
  const { palette, maze, program } = scene;
  const { snapshot, progress } = shown.frame;
  const { pose } = snapshot;
  const hit = isAtHit(shown.hit, pose) ? shown.hit : null;
  const { numbers } = shown;
  const lit = litSensors(program, numbers);
  if (hit !== null) drawHit(brush, viewport, palette, maze, hit, dirt);
  // Nothing is left to be measured there, and the goal is in sight.
  const isJoyful = hit === null && isOnReachedGoal(maze, snapshot);
  const showBeams = scene.showBeams && !isJoyful;
  if (showBeams) drawBeams(brush, viewport, palette, snapshot, lit, dirt);
  if (isJoyful) drawJoy(brush, viewport, palette, pose, dirt);
  const { ghosts } = shown.frame;
  if (ghosts !== undefined) raceGhostsLayer()?.(brush, viewport, palette, ghosts, dirt);
  drawPath(brush, viewport, palette, pose, progress, dirt);
  const end = snapshot.driver === "remote" ? endOf(pose, progress) : null;
  if (end !== null) drawOutline(brush, viewport, palette.liveInk, end, dirt);
  const face = hit === null ? faceOf(snapshot) : "bumped";
  drawRobot(brush, viewport, palette, pose, face, dirt, shown.nudge);
  const bumped = hit === null ? null : hitSensor(maze, hit, snapshot);
  const hasReading = showBeams && bumped !== null;
  const label =
    hit === null
      ? null
      : drawRadius(brush, viewport, palette, maze, { pose: hit.pose, hasReading }, dirt);
  if (!showBeams) return;
  const limits = limitsOf(program, numbers);
  const { sensors } = numbers;
  const { goals } = maze;
  const taken = label === null ? [] : [label];
  drawTags(brush, viewport, palette, snapshot, dirt, {
    lit,
    limits,
    bumped,
    sensors,
    goals,
    taken,
  });
}
