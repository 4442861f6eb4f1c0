/**
 * The live layer, everything that moves with the run: edit preview, path ahead, beams, robot, labels,
 * ruler marks, tape.
 */
import type { Snapshot } from "@corridor/protocol";
import { limitsOf, litSensors } from "../drawing/running-line.ts";
import { endOf } from "./path-ahead.ts";
import type { StageModel } from "./stage-model.ts";
import type { CanvasLayer } from "./canvas-layer.ts";
import { runBox, type Viewport } from "../drawing/viewport.ts";
import type { Frame } from "../drawing/frame.ts";
import { drawBeams } from "./beams.ts";
import { drawPreview } from "./edit-preview.ts";
import { drawHit, hitSensor, isAtHit, type Hit } from "./hit.ts";
import { measureLayer } from "./lazy-measure.ts";
import { raceGhostsLayer } from "./lazy-race-ghosts.ts";
import { drawCelebration, isOnReachedGoal } from "./celebration.ts";
import { drawOutline, drawPath } from "./path.ts";
import { drawRadius, drawRadiusLabel, placeRadiusLabel } from "./radius.ts";
import { drawRobot, faceOf } from "./robot.ts";
import { drawRulerMarks } from "./rulers.ts";
import { drawBeamLabels } from "./beam-labels.ts";

/** The displayed state of the run. */
export interface DisplayedRun {
  frame: Frame;
  /** the snapshot whose numbers the page displays; robot and beams may be some ticks ahead */
  numbers: Snapshot;
  /** the newest bump; null if there is none */
  hit: Hit | null;
  /** offset in pixels of the robot from its position, during a nudge */
  nudge: { x: number; y: number };
}

/**
 * Draws the live layer after it was erased.
 * @param displayed null before the first frame
 */
export function drawLive(
  layer: CanvasLayer,
  viewport: Viewport,
  model: StageModel,
  displayed: DisplayedRun | null,
): void {
  const { context, dirty } = layer;
  const { palette } = model;
  layer.clipped(runBox(viewport), () => {
    if (model.preview !== null)
      drawPreview(context, viewport, palette, model.preview, model, dirty);
    if (displayed !== null) drawRun(layer, viewport, model, displayed);
    if (model.measured !== null)
      measureLayer()?.(context, viewport, palette, model.measured, dirty);
  });
  if (displayed === null) return;
  // Below the numbers: beside the frame both may have the same position.
  if (model.showRulers) {
    drawRulerMarks(context, viewport, palette, displayed.frame.snapshot.pose, dirty);
  }
  drawNumbers(layer, viewport, model, displayed);
}

/** The bump that the robot has not left. */
function hitAt({ hit, frame }: DisplayedRun): Hit | null {
  return isAtHit(hit, frame.snapshot.pose) ? hit : null;
}

/** On a reached goal the beams are hidden, so that the goal is visible. */
function isCelebrating({ maze }: StageModel, displayed: DisplayedRun): boolean {
  return hitAt(displayed) === null && isOnReachedGoal(maze, displayed.frame.snapshot);
}

function drawRun(
  layer: CanvasLayer,
  viewport: Viewport,
  model: StageModel,
  displayed: DisplayedRun,
): void {
  const { context, dirty } = layer;
  const { palette, maze, program } = model;
  const { snapshot, progress, ghosts } = displayed.frame;
  const { pose } = snapshot;
  const hit = hitAt(displayed);
  if (hit !== null) drawHit(context, viewport, palette, maze, hit, dirty);
  if (isCelebrating(model, displayed)) {
    drawCelebration(context, viewport, palette, pose, dirty);
  } else if (model.showBeams) {
    drawBeams(context, viewport, palette, snapshot, litSensors(program, displayed.numbers), dirty);
  }
  if (ghosts !== undefined) raceGhostsLayer()?.(context, viewport, palette, ghosts, dirty);
  drawPath(context, viewport, palette, pose, progress, dirty);
  const end = snapshot.driver === "remote" ? endOf(pose, progress) : null;
  if (end !== null) drawOutline(context, viewport, palette.liveInk, end, dirty);
  const face = hit === null ? faceOf(snapshot) : "bumped";
  drawRobot(context, viewport, palette, pose, face, dirty, displayed.nudge);
}

/** Numbers may stand outside of the maze: a robot in a corner leaves no room for them inside. */
function drawNumbers(
  layer: CanvasLayer,
  viewport: Viewport,
  model: StageModel,
  displayed: DisplayedRun,
): void {
  const { context, dirty } = layer;
  const { palette, maze, program, showBeams } = model;
  const { numbers } = displayed;
  const { snapshot } = displayed.frame;
  const hit = hitAt(displayed);
  const bumped = hit === null ? null : hitSensor(maze, hit, snapshot);
  const drawMeasured = ({ pose }: Hit) =>
    layer.clipped(runBox(viewport), () =>
      drawRadius(context, viewport, palette, maze, pose, dirty),
    );
  const measure = hit === null ? null : drawMeasured(hit);
  const hasReadings = showBeams && !isCelebrating(model, displayed);
  // A red reading already shows the distance.
  const needsLabel = measure !== null && !(hasReadings && bumped !== null);
  const label = needsLabel ? placeRadiusLabel(viewport, measure) : null;
  if (hasReadings) {
    drawBeamLabels(context, viewport, palette, snapshot, dirty, {
      lit: litSensors(program, numbers),
      limits: limitsOf(program, numbers),
      bumped,
      sensors: numbers.sensors,
      goals: maze.goals,
      occupied: label === null ? [] : [label],
    });
  }
  // After the marks: a line's bar across the beam would strike the number through.
  if (label !== null) drawRadiusLabel(context, palette, label, dirty);
}
