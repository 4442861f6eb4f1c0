/**
 * The labels on the beams: the reading at each wall, and the limits of the program's lines. A limit
 * is a bar across the beam with the line's badge: solid where the beam reaches it, dashed where a
 * wall is nearer.
 */
import type { Cell } from "@corridor/maze";
import { type SensorName, type Snapshot } from "@corridor/protocol";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import type { Limit } from "../drawing/running-line.ts";
import {
  markCentres,
  placeLabels,
  type Beam,
  type PlacedLabel,
  type LabelRequest,
} from "../drawing/label-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";
import { placeReadings, MIN_ROOMY_SCALE, type PlacedReading } from "./reading-placement.ts";
import { beamDirection } from "./beams.ts";
import { cellBox, goalPicture } from "./places.ts";
import { robotBox } from "./robot.ts";

/** Pixels of a mark, with and without much room. */
const largeMark = { height: 18, padding: 6, font: 12, badge: 16, reach: 13 };
const smallMark = { height: 14, padding: 4, font: 11, badge: 13, reach: 9 };
type MarkStyle = typeof largeMark;
/**
 * Largest number of flags that labels avoid, so that a maze full of goals does not slow down a frame.
 */
const MAX_FLAGS = 16;

/** What the labels depend on, besides the robot. */
interface TagModel {
  /** the sensors that the running line reads */
  lit: readonly SensorName[];
  limits: readonly Limit[];
  /** the sensor that measures a wall that was hit */
  bumped: SensorName | null;
  /** the readings that the page displays: of the same tick as every other number on the screen */
  sensors: Snapshot["sensors"];
  /** their flags stay visible if a label has another position */
  goals: readonly Cell[];
  /** other boxes on the stage that no label may cover */
  occupied: readonly Box[];
}

/**
 * Draws readings and marks.
 * @param snapshot where the robot and its beams are drawn
 */
export function drawBeamLabels(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  snapshot: Snapshot,
  dirty: DirtyRects,
  { lit, limits, bumped, sensors, goals, occupied }: TagModel,
): void {
  const origin = { x: viewX(viewport, snapshot.pose.x), y: viewY(viewport, snapshot.pose.y) };
  const beamOf = (sensor: SensorName): Beam => ({
    origin,
    ...beamDirection(sensor, snapshot.pose.heading),
  });
  const robot = robotBox(viewport, origin);
  context.textAlign = "center";
  context.textBaseline = "middle";

  const flags = goals.slice(0, MAX_FLAGS).map((goal) => goalPicture(cellBox(viewport, goal)));
  const readings = placeReadings(
    viewport,
    snapshot,
    [robot, ...occupied],
    flags,
    (sensor, font) => {
      context.font = `600 ${font}px ${palette.font}`;
      return textWidth(context, readingText(sensors[sensor]));
    },
  );

  const visible = visibleMarks(limits, viewport.scale, bumped !== null);
  const others = [robot, ...occupied, ...readings];
  drawMarks(context, viewport, palette, sensors, visible, beamOf, others, dirty);

  for (const label of readings) {
    dirty.add(label.x, label.y, label.width, label.height);
    drawReading(
      context,
      palette,
      label,
      readingText(sensors[label.name]),
      label.name === bumped ? "bumped" : lit.includes(label.name) ? "lit" : "plain",
    );
  }
}

/**
 * All marks if there is room; otherwise that of the running line. At a bump, which shows its own
 * number, none.
 */
export function visibleMarks(
  limits: readonly Limit[],
  scale: number,
  isAtBump: boolean,
): readonly Limit[] {
  if (scale >= MIN_ROOMY_SCALE) return limits;
  return isAtBump ? [] : limits.filter((each) => each.isRunning);
}

/** A reading in whole units. */
function readingText(reading: number): string {
  return String(Math.round(reading));
}

/** Measured widths, by font and text. Consecutive frames need almost the same numbers. */
const widths = new Map<string, number>();
const MAX_WIDTHS = 4000;

function textWidth(context: DrawingContext, text: string): number {
  const key = `${context.font} ${text}`;
  let width = widths.get(key);
  if (width === undefined) {
    if (widths.size >= MAX_WIDTHS) widths.clear();
    width = Math.ceil(context.measureText(text).width);
    widths.set(key, width);
  }
  return width;
}

/**
 * Discards measured widths after a font has loaded, because the same name stands for another font.
 */
export function clearTextWidths(): void {
  widths.clear();
}

function drawReading(
  context: DrawingContext,
  palette: Palette,
  box: PlacedReading,
  text: string,
  style: "plain" | "lit" | "bumped",
): void {
  const { font, corner } = box.style;
  context.font = `600 ${font}px ${palette.font}`;
  context.beginPath();
  context.roundRect(box.x + 0.5, box.y + 0.5, box.width - 1, box.height - 1, corner);
  const fill = { plain: palette.surface, lit: palette.live, bumped: palette.bad }[style];
  context.fillStyle = fill;
  context.fill();
  context.strokeStyle = style === "plain" ? palette.edge : fill;
  context.lineWidth = 1;
  context.stroke();
  context.fillStyle = { plain: palette.ink, lit: palette.onLive, bumped: palette.onInk }[style];
  context.fillText(text, box.x + box.width / 2, box.y + box.height / 2 + 0.5);
}

function drawMarks(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  sensors: Snapshot["sensors"],
  limits: readonly Limit[],
  beamOf: (sensor: SensorName) => Beam,
  occupied: readonly Box[],
  dirty: DirtyRects,
): void {
  const style = viewport.scale < MIN_ROOMY_SCALE ? smallMark : largeMark;
  context.font = `600 ${style.font}px ${palette.font}`;
  const requests = limits.map((limit): LabelRequest<Limit> => {
    const beam = beamOf(limit.sensor);
    const width = style.badge + textWidth(context, String(limit.distance)) + 2 * style.padding;
    const distance = limit.distance * viewport.scale;
    const centres = markCentres(beam, distance, style.reach, width, style.height);
    return { name: limit, sizes: [{ width, height: style.height, centres }] };
  });
  const labels = placeLabels(requests, occupied, viewport.view);
  const isReached = ({ distance, sensor }: Limit): boolean => distance <= sensors[sensor];
  for (const limit of limits) {
    // A bar without a number is useless, except for the line that the panel shows as running.
    if (!limit.isRunning && !labels.some(({ name }) => name === limit)) continue;
    const distance = limit.distance * viewport.scale;
    drawBar(
      context,
      palette,
      beamOf(limit.sensor),
      distance,
      limit,
      isReached(limit),
      style,
      dirty,
    );
  }
  for (const label of labels) {
    dirty.add(label.x, label.y, label.width, label.height);
    drawMark(context, palette, label, isReached(label.name), style);
  }
}

function drawBar(
  context: DrawingContext,
  palette: Palette,
  { origin, dx, dy }: Beam,
  distance: number,
  { isRunning }: Limit,
  isReached: boolean,
  { reach }: MarkStyle,
  dirty: DirtyRects,
): void {
  const x = origin.x + dx * distance;
  const y = origin.y + dy * distance;
  dirty.add(x - reach, y - reach, 2 * reach, 2 * reach);
  context.beginPath();
  context.moveTo(x - dy * reach, y + dx * reach);
  context.lineTo(x + dy * reach, y - dx * reach);
  context.strokeStyle = isRunning ? palette.liveInk : palette.ink2;
  context.lineWidth = 2;
  context.setLineDash(isReached ? [] : [3, 2]);
  context.stroke();
  context.setLineDash([]);
}

function drawMark(
  context: DrawingContext,
  palette: Palette,
  label: PlacedLabel<Limit>,
  isReached: boolean,
  { badge }: MarkStyle,
): void {
  const { isRunning, line, distance } = label.name;
  const colour = isRunning ? palette.live : palette.ink2;
  context.beginPath();
  context.roundRect(label.x + 0.5, label.y + 0.5, label.width - 1, label.height - 1, 4);
  context.fillStyle = palette.surface;
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash(isReached ? [] : [3, 2]);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.roundRect(label.x, label.y, badge, label.height, [4, 0, 0, 4]);
  context.fillStyle = colour;
  context.fill();
  const middle = label.y + label.height / 2 + 0.5;
  context.fillStyle = isRunning ? palette.onLive : palette.onInk;
  context.fillText(String(line + 1), label.x + badge / 2, middle, badge - 2);
  context.fillStyle = palette.ink;
  context.fillText(String(distance), label.x + badge + (label.width - badge) / 2, middle);
}
