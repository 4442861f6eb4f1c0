/**
 * The tags on the beams: the reading at each wall, and the numbers of the program's lines with the
 * line's badge, on a bar across the beam: whole where the beam reaches it, dashed where a wall is nearer.
 */
import type { Cell } from "@corridor/maze";
import { type SensorName, type Snapshot } from "@corridor/protocol";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import type { Limit } from "../running-line.ts";
import {
  markCentres,
  placeTags,
  type Beam,
  type PlacedTag,
  type TagRequest,
} from "../tag-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "../viewport.ts";
import { placeReadings, ROOMY_FROM, type PlacedReading } from "../reading-places.ts";
import { beamDirection } from "./beams.ts";
import { cellBox, goalPicture } from "./places.ts";
import { robotBox } from "./robot.ts";

/** Pixels of a mark where there is room, and where there is little. */
const largeMark = { height: 18, padding: 6, font: 12, badge: 16, reach: 13 };
const smallMark = { height: 14, padding: 4, font: 11, badge: 13, reach: 9 };
type MarkLook = typeof largeMark;
/** Of a maze full of goals, so many are looked at: a frame has no time for all. */
const MAX_FLAGS = 16;

/** What the tags are drawn by, besides the robot. */
interface TagScene {
  /** the sensors that the running line reads */
  lit: readonly SensorName[];
  limits: readonly Limit[];
  /** looks at a wall that was hit */
  bumped: SensorName | null;
  /** the readings as the page displays them: of the same tick as every other number on the screen */
  sensors: Snapshot["sensors"];
  /** their flags stay in sight where a tag has another place */
  goals: readonly Cell[];
  /** what else stands on the stage and no tag may cover */
  taken: readonly Box[];
}

/** Draws readings and marks. @param snapshot where the robot and its beams are drawn */
export function drawTags(
  context: Brush,
  viewport: Viewport,
  palette: Palette,
  snapshot: Snapshot,
  dirt: Dirt,
  { lit, limits, bumped, sensors, goals, taken }: TagScene,
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
  const readings = placeReadings(viewport, snapshot, [robot, ...taken], flags, (sensor, font) => {
    context.font = `600 ${font}px ${palette.font}`;
    return textWidth(context, readingText(sensors[sensor]));
  });

  const shown = shownMarks(limits, viewport.scale, bumped !== null);
  const others = [robot, ...taken, ...readings];
  drawMarks(context, viewport, palette, sensors, shown, beamOf, others, dirt);

  for (const tag of readings) {
    dirt.add(tag.x, tag.y, tag.width, tag.height);
    drawReading(
      context,
      palette,
      tag,
      readingText(sensors[tag.name]),
      tag.name === bumped ? "bumped" : lit.includes(tag.name) ? "lit" : "plain",
    );
  }
}

/** All marks where there is room; else that of the running line, and none at a bump, which shows its own number. */
export function shownMarks(
  limits: readonly Limit[],
  scale: number,
  isAtBump: boolean,
): readonly Limit[] {
  if (scale >= ROOMY_FROM) return limits;
  return isAtBump ? [] : limits.filter((each) => each.isRunning);
}

/** A reading as it is written on the stage: whole centimetres. */
function readingText(reading: number): string {
  return String(Math.round(reading));
}

/** Widths that were measured, by font and text: a frame asks for the same few numbers as the one before. */
const widths = new Map<string, number>();
const MAX_WIDTHS = 4000;

function textWidth(context: Brush, text: string): number {
  const key = `${context.font} ${text}`;
  let width = widths.get(key);
  if (width === undefined) {
    if (widths.size >= MAX_WIDTHS) widths.clear();
    width = Math.ceil(context.measureText(text).width);
    widths.set(key, width);
  }
  return width;
}

/** Another font may stand behind the same name from now on. */
export function forgetTextWidths(): void {
  widths.clear();
}

function drawReading(
  context: Brush,
  palette: Palette,
  box: PlacedReading,
  text: string,
  look: "plain" | "lit" | "bumped",
): void {
  const { font, corner } = box.look;
  context.font = `600 ${font}px ${palette.font}`;
  context.beginPath();
  context.roundRect(box.x + 0.5, box.y + 0.5, box.width - 1, box.height - 1, corner);
  const fill = { plain: palette.surface, lit: palette.live, bumped: palette.bad }[look];
  context.fillStyle = fill;
  context.fill();
  context.strokeStyle = look === "plain" ? palette.edge : fill;
  context.lineWidth = 1;
  context.stroke();
  context.fillStyle = { plain: palette.ink, lit: palette.onLive, bumped: palette.onInk }[look];
  context.fillText(text, box.x + box.width / 2, box.y + box.height / 2 + 0.5);
}

function drawMarks(
  context: Brush,
  viewport: Viewport,
  palette: Palette,
  sensors: Snapshot["sensors"],
  limits: readonly Limit[],
  beamOf: (sensor: SensorName) => Beam,
  taken: readonly Box[],
  dirt: Dirt,
): void {
  const look = viewport.scale < ROOMY_FROM ? smallMark : largeMark;
  context.font = `600 ${look.font}px ${palette.font}`;
  const requests = limits.map((limit): TagRequest<Limit> => {
    const beam = beamOf(limit.sensor);
    const width = look.badge + textWidth(context, String(limit.distance)) + 2 * look.padding;
    const distance = limit.distance * viewport.scale;
    const centres = markCentres(beam, distance, look.reach, width, look.height);
    return { name: limit, sizes: [{ width, height: look.height, centres }] };
  });
  const tags = placeTags(requests, taken, viewport.view);
  const isReached = ({ distance, sensor }: Limit): boolean => distance <= sensors[sensor];
  for (const limit of limits) {
    // A bar without its number says nothing, but for the line that the panel shows as running.
    if (!limit.isRunning && !tags.some(({ name }) => name === limit)) continue;
    const distance = limit.distance * viewport.scale;
    drawBar(context, palette, beamOf(limit.sensor), distance, limit, isReached(limit), look, dirt);
  }
  for (const tag of tags) {
    dirt.add(tag.x, tag.y, tag.width, tag.height);
    drawMark(context, palette, tag, isReached(tag.name), look);
  }
}

function drawBar(
  context: Brush,
  palette: Palette,
  { origin, dx, dy }: Beam,
  distance: number,
  { isRunning }: Limit,
  isReached: boolean,
  { reach }: MarkLook,
  dirt: Dirt,
): void {
  const x = origin.x + dx * distance;
  const y = origin.y + dy * distance;
  dirt.add(x - reach, y - reach, 2 * reach, 2 * reach);
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
  context: Brush,
  palette: Palette,
  tag: PlacedTag<Limit>,
  isReached: boolean,
  { badge }: MarkLook,
): void {
  const { isRunning, line, distance } = tag.name;
  const colour = isRunning ? palette.live : palette.ink2;
  context.beginPath();
  context.roundRect(tag.x + 0.5, tag.y + 0.5, tag.width - 1, tag.height - 1, 4);
  context.fillStyle = palette.surface;
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash(isReached ? [] : [3, 2]);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.roundRect(tag.x, tag.y, badge, tag.height, [4, 0, 0, 4]);
  context.fillStyle = colour;
  context.fill();
  const middle = tag.y + tag.height / 2 + 0.5;
  context.fillStyle = isRunning ? palette.onLive : palette.onInk;
  context.fillText(String(line + 1), tag.x + badge / 2, middle, badge - 2);
  context.fillStyle = palette.ink;
  context.fillText(String(distance), tag.x + badge + (tag.width - badge) / 2, middle);
}
