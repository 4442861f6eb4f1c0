/** Where the four readings stand around the robot, and how large. Pure; pixels of the view. */
import { sensorNames, type SensorName, type Snapshot } from "@corridor/protocol";
import { beamDirection } from "./layers/beams.ts";
import { robotBox } from "./layers/robot.ts";
import {
  lengthInside,
  placeTags,
  readingCentres,
  type PlacedTag,
  type TagRequest,
} from "./tag-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "./viewport.ts";

/** Pixels of a reading's tag. */
interface ReadingLook {
  height: number;
  /** on either side of the number */
  padding: number;
  font: number;
  /** radius of its corners */
  corner: number;
}

/** A reading where there is room, and where there is little. */
const large: ReadingLook = { height: 22, padding: 7, font: 14, corner: 6 };
const small: ReadingLook = { height: 14, padding: 3, font: 11, corner: 4 };
/** Below this scale the maze has no room for large readings and for the marks of all lines, pixels per unit. */
export const ROOMY_FROM = 0.45;

export interface PlacedReading extends PlacedTag<SensorName> {
  look: ReadingLook;
}

/**
 * Places the readings: each in its beam's quarter, the shortest beam first, which has the fewest places.
 * @param taken what no tag may touch
 * @param spared what a tag covers only where it has no other place
 * @param widthOf pixels of a sensor's number in a font of so many pixels
 */
export function placeReadings(
  viewport: Viewport,
  { pose, sensors }: Pick<Snapshot, "pose" | "sensors">,
  taken: readonly Box[],
  spared: readonly Box[],
  widthOf: (sensor: SensorName, font: number) => number,
): PlacedReading[] {
  const { scale, port, view } = viewport;
  const origin = { x: viewX(viewport, pose.x), y: viewY(viewport, pose.y) };
  const robot = robotBox(viewport, origin);
  const looks = scale < ROOMY_FROM ? [small] : [large, small];
  const requests = sensorNames.map((name): TagRequest<SensorName> => {
    const beam = { origin, ...beamDirection(name, pose.heading) };
    // Where the wall is out of sight, the reading stands at the edge of what shows.
    const length = Math.min(sensors[name] * scale, lengthInside(beam, port));
    const sizes = looks.map(({ height, padding, font }) => {
      const width = widthOf(name, font) + 2 * padding;
      return {
        width,
        height,
        centres: readingCentres(beam, length, robot.width / 2, width, height),
      };
    });
    return { name, sizes };
  });
  requests.sort((a, b) => sensors[a.name] - sensors[b.name]);
  // Readings around a robot that is scrolled out of sight would belong to nothing.
  const bounds = isInside(origin, port) ? view : port;
  const place = (order: readonly TagRequest<SensorName>[]) =>
    placeTags(order, [robot, ...taken], bounds, spared);
  return placeAll(requests, place).map((tag) => ({
    ...tag,
    look: tag.height < large.height ? small : large,
  }));
}

/** Where a place is gone that was another one's only place, that one chooses first. */
function placeAll<Request extends { name: SensorName }>(
  requests: readonly Request[],
  place: (order: readonly Request[]) => PlacedTag<SensorName>[],
): PlacedTag<SensorName>[] {
  const placed = place(requests);
  const isPlaced = ({ name }: Request): boolean => placed.some((tag) => tag.name === name);
  const leftOut = requests.filter((request) => !isPlaced(request));
  if (leftOut.length === 0) return placed;
  const again = place([...leftOut, ...requests.filter(isPlaced)]);
  return again.length > placed.length ? again : placed;
}

function isInside({ x, y }: { x: number; y: number }, box: Box): boolean {
  return x >= box.x && y >= box.y && x <= box.x + box.width && y <= box.y + box.height;
}
