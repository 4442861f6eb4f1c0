/**
 * The four range beams as tape measures, from the robot's centre to the wall. Ticks every 10 units,
 * longer at 50 and 100. The sensors that the running line reads are highlighted.
 */
import { ROBOT_RADIUS } from "@corridor/simulation";
import { sensorNames, type SensorName, type Snapshot } from "@corridor/protocol";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

const TICK = 10;
/**
 * Ticks closer than this many pixels would look like a grey band; only every fifth is drawn then.
 */
const TICKS_FROM_PX = 2.5;

/** Pixels from a beam to the end of its longest mark. */
const WIDEST = 9;

/** A unit vector along a sensor's beam. */
export interface Direction {
  dx: number;
  dy: number;
}

/**
 * Unit vector along the beam of a sensor.
 * @param heading degrees clockwise from north
 */
export function beamDirection(sensor: SensorName, heading: number): Direction {
  const degrees = heading + 90 * sensorNames.indexOf(sensor);
  const radians = (degrees * Math.PI) / 180;
  return { dx: Math.sin(radians), dy: -Math.cos(radians) };
}

/**
 * Draws the beams.
 * @param lit the sensors that the running line reads
 */
export function drawBeams(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  snapshot: Snapshot,
  lit: readonly SensorName[],
  dirty: DirtyRects,
): void {
  const x = viewX(viewport, snapshot.pose.x);
  const y = viewY(viewport, snapshot.pose.y);
  const reach = reachOf(viewport);
  // Highlighted beams come last, so that no other beam covers them.
  for (const isLit of [false, true]) {
    for (const sensor of sensorNames) {
      if (lit.includes(sensor) !== isLit) continue;
      const { dx, dy } = beamDirection(sensor, snapshot.pose.heading);
      const length = Math.min(snapshot.sensors[sensor], reach) * viewport.scale;
      dirty.addLine(x, y, x + dx * length, y + dy * length, WIDEST);
      context.save();
      context.translate(x, y);
      // From here on the beam runs along the x axis.
      context.rotate(Math.atan2(dy, dx));
      drawBeam(context, viewport, palette, snapshot.sensors[sensor], isLit);
      context.restore();
    }
  }
}

/** Length in units beyond which a beam leaves the view. A beam can be 25,600 units long. */
function reachOf({ port, scale }: Viewport): number {
  return (port.width + port.height) / scale;
}

function drawBeam(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  reading: number,
  isLit: boolean,
): void {
  const { scale } = viewport;
  const reach = Math.min(reading, reachOf(viewport));
  const length = reach * scale;
  const band = Math.min(9, Math.max(5, 10 * scale));
  const colour = isLit ? palette.live : palette.beam;
  context.lineCap = "butt";
  if (isLit) {
    context.strokeStyle = palette.liveSoft;
    context.lineWidth = band;
    line(context, 0, 0, length, 0);
  }
  context.strokeStyle = colour;
  context.lineWidth = isLit ? 2.5 : 1.25;
  line(context, 0, 0, length, 0);

  const step = TICK * scale >= TICKS_FROM_PX ? TICK : TICK * 5;
  context.beginPath();
  for (let at = Math.ceil(ROBOT_RADIUS / step) * step; at < reach; at += step) {
    const half = at % 100 === 0 ? band * 0.75 : at % 50 === 0 ? band * 0.6 : band * 0.3;
    context.moveTo(at * scale, -half);
    context.lineTo(at * scale, half);
  }
  context.strokeStyle = isLit ? palette.liveInk : palette.beam;
  context.lineWidth = 1;
  context.stroke();

  if (reach < reading) return;
  context.strokeStyle = colour;
  context.lineWidth = isLit ? 3 : 2.5;
  const half = Math.min(8, Math.max(4, 10 * scale));
  line(context, length - 1, -half, length - 1, half);
}

function line(
  context: DrawingContext,
  fromX: number,
  fromY: number,
  toX: number,
  toY: number,
): void {
  context.beginPath();
  context.moveTo(fromX, fromY);
  context.lineTo(toX, toY);
  context.stroke();
}
