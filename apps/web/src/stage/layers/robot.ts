/**
 * The robot: one shape, three faces. Shapes are in units around its centre, facing north, and equal
 * the SVG files of the design.
 */
import { ROBOT_RADIUS } from "@corridor/simulation";
import type { Snapshot } from "@corridor/protocol";
import type { DrawingContext, VectorContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { ROBOT_BODY } from "../../ui/robot-outline.ts";
import { svgPath } from "../drawing/svg-path.ts";
import { viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";

export type Face = "driving" | "bumped" | "solved";

/** The face for a snapshot. A bump takes precedence over a goal. */
export function faceOf(snapshot: Pick<Snapshot, "bumping" | "goalReached">): Face {
  if (snapshot.bumping) return "bumped";
  return snapshot.goalReached ? "solved" : "driving";
}

const faces: Record<
  Face,
  { eyes: string; eyesWidth: number; mouth: string; isMouthOpen: boolean }
> = {
  driving: {
    eyes: "M-11-9.5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0M4-9.5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0",
    eyesWidth: 0,
    mouth: "M-5 9q5 4.5 10 0",
    isMouthOpen: false,
  },
  bumped: {
    eyes: "M-10-12l5 5m0-5-5 5M5-12l5 5m0-5-5 5",
    eyesWidth: 2.4,
    mouth: "M-3.4 11a3.4 4 0 1 0 6.8 0a3.4 4 0 1 0-6.8 0",
    isMouthOpen: true,
  },
  solved: {
    eyes: "M-11-8q3.5-5 7 0M4-8q3.5-5 7 0",
    eyesWidth: 2.6,
    mouth: "M-7 7h14q-1.5 8-7 8t-7-8z",
    isMouthOpen: true,
  },
};

/** Units from the robot's centre to the corner of a wheel, including its outline. */
const REACH = 32;

/** Units around the robot's disc that no label may cover, because its wheels protrude. */
const MARGIN = 1;

/** Pixels around the robot's centre that labels may not cover. */
export function robotBox({ scale }: Viewport, { x, y }: { x: number; y: number }): Box {
  const radius = (ROBOT_RADIUS + MARGIN) * scale;
  return { x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius };
}

interface Shapes {
  body: Path2D;
  eyes: Path2D;
  mouth: Path2D;
}

const shapes = new Map<Face, Shapes>();

/** Parses the paths once per face: parsing them on every frame would cost more than drawing. */
function shapesOf(face: Face): Shapes {
  let known = shapes.get(face);
  if (known === undefined) {
    const { eyes, mouth } = faces[face];
    known = { body: svgPath(ROBOT_BODY), eyes: svgPath(eyes), mouth: svgPath(mouth) };
    shapes.set(face, known);
  }
  return known;
}

/** Strokes the body's outline. The context is in units around the robot's centre. */
export function traceBody(context: DrawingContext): void {
  context.stroke(shapesOf("driving").body);
}

/** Fills the body. The context is in units around the robot's centre. */
export function fillBody(context: DrawingContext): void {
  context.fill(shapesOf("driving").body);
}

/**
 * Draws the robot at its pose.
 * @param offset CSS pixels between the pose and the drawing
 */
export function drawRobot(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  pose: Snapshot["pose"],
  face: Face,
  dirty: DirtyRects,
  offset: { x: number; y: number } = { x: 0, y: 0 },
): void {
  const { eyesWidth, isMouthOpen } = faces[face];
  const { body, eyes, mouth } = shapesOf(face);
  const x = viewX(viewport, pose.x) + offset.x;
  const y = viewY(viewport, pose.y) + offset.y;
  const reach = REACH * viewport.scale;
  dirty.add(x - reach, y - reach, 2 * reach, 2 * reach);
  context.save();
  context.translate(x, y);
  context.rotate((pose.heading * Math.PI) / 180);
  context.scale(viewport.scale, viewport.scale);
  context.lineCap = "round";

  context.fillStyle = palette.robotWheel;
  context.beginPath();
  context.roundRect(-26, -15, 9, 30, 4.5);
  context.roundRect(17, -15, 9, 30, 4.5);
  context.fill();

  context.fillStyle = palette.live;
  context.fill(body);
  context.strokeStyle = palette.robotEdge;
  context.lineWidth = 2;
  context.stroke(body);

  context.fillStyle = palette.robotVisor;
  context.beginPath();
  context.roundRect(-15, -17, 30, 15, 7.5);
  context.fill();
  if (eyesWidth === 0) {
    context.fillStyle = palette.robotEye;
    context.fill(eyes);
  } else {
    context.strokeStyle = palette.robotEye;
    context.lineWidth = eyesWidth;
    context.stroke(eyes);
  }
  if (isMouthOpen) {
    context.fillStyle = palette.robotVisor;
    context.fill(mouth);
  } else {
    context.strokeStyle = palette.robotVisor;
    context.lineWidth = 2.6;
    context.stroke(mouth);
  }
  context.restore();
}
