/** Everything that moves with the run, in one picture: ghost, beams, robot, tags, ruler marks, tape. */
import type { Snapshot } from "@corridor/protocol";
import type { Palette } from "../palette.ts";
import { limitsOf, litSensors } from "../running-line.ts";
import type { Scene } from "../scene.ts";
import type { Surface } from "../surface.ts";
import type { Viewport } from "../viewport.ts";
import { drawBeams } from "./beams.ts";
import { drawGhost } from "./ghost.ts";
import { drawMeasure } from "./measure.ts";
import { drawRobot, faceOf } from "./robot.ts";
import { drawRulerMarks } from "./rulers.ts";
import { drawTags } from "./tags.ts";

/** Draws the live layer over what was wiped. @param snapshot null before the first frame */
export function drawLive(
  surface: Surface,
  viewport: Viewport,
  scene: Scene,
  snapshot: Snapshot | null,
): void {
  const { brush, dirt } = surface;
  const palette: Palette = scene.palette;
  surface.clipped(viewport, () => {
    if (scene.ghost !== null) drawGhost(brush, viewport, palette, scene.ghost, scene, dirt);
    if (snapshot !== null) {
      const lit = litSensors(scene.program, snapshot);
      if (scene.showBeams) drawBeams(brush, viewport, palette, snapshot, lit, dirt);
      drawRobot(brush, viewport, palette, snapshot.pose, faceOf(snapshot), dirt);
      if (scene.showBeams) {
        const limits = limitsOf(scene.program, snapshot);
        drawTags(brush, viewport, palette, snapshot, lit, limits, dirt);
      }
    }
    if (scene.measured !== null) drawMeasure(brush, viewport, palette, scene.measured, dirt);
  });
  if (snapshot !== null && scene.showRulers) {
    drawRulerMarks(brush, viewport, palette, snapshot.pose, dirt);
  }
}
