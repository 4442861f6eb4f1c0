/** Placement and size of the four readings around the robot. Pure; pixels of the view. */
import { sensorNames, type SensorName, type Snapshot } from "@corridor/protocol";
import { beamDirection } from "./beams.ts";
import { robotBox } from "./robot.ts";
import {
  lengthInside,
  placeLabels,
  readingCentres,
  type PlacedLabel,
  type LabelRequest,
} from "../drawing/label-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";

/** Pixels of a reading's label. */
interface ReadingStyle {
  height: number;
  /** on either side of the number */
  padding: number;
  font: number;
  /** corner radius */
  corner: number;
}

/** Readings with and without much room. */
const large: ReadingStyle = { height: 22, padding: 7, font: 14, corner: 6 };
const small: ReadingStyle = { height: 14, padding: 3, font: 11, corner: 4 };
/**
 * Pixels per unit below which the maze has no room for large readings and for the marks of all
 * lines.
 */
export const MIN_ROOMY_SCALE = 0.45;

export interface PlacedReading extends PlacedLabel<SensorName> {
  style: ReadingStyle;
}

/**
 * Places the readings, each in its beam's quarter. The shortest beam comes first, because it has
 * the fewest positions.
 * @param occupied boxes that no label may touch
 * @param avoided boxes that a label covers only if it has no other position
 * @param widthOf width in pixels of a sensor's number at a font size
 */
export function placeReadings(
  viewport: Viewport,
  { pose, sensors }: Pick<Snapshot, "pose" | "sensors">,
  occupied: readonly Box[],
  avoided: readonly Box[],
  widthOf: (sensor: SensorName, font: number) => number,
): PlacedReading[] {
  const { scale, port, view } = viewport;
  const origin = { x: viewX(viewport, pose.x), y: viewY(viewport, pose.y) };
  const robot = robotBox(viewport, origin);
  const styles = scale < MIN_ROOMY_SCALE ? [small] : [large, small];
  const requests = sensorNames.map((name): LabelRequest<SensorName> => {
    const beam = { origin, ...beamDirection(name, pose.heading) };
    // If the wall is outside of the view, the reading stands at the edge of the view.
    const length = Math.min(sensors[name] * scale, lengthInside(beam, port));
    const sizes = styles.map(({ height, padding, font }) => {
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
  // If the robot is scrolled out of view, its readings are confined to the port, where none fits.
  const bounds = isInside(origin, port) ? view : port;
  const place = (order: readonly LabelRequest<SensorName>[]) =>
    placeLabels(order, [robot, ...occupied], bounds, avoided);
  return placeAll(requests, place).map((label) => ({
    ...label,
    style: label.height < large.height ? small : large,
  }));
}

/** Retries with the labels first that found no position, and returns the better result. */
function placeAll<Request extends { name: SensorName }>(
  requests: readonly Request[],
  place: (order: readonly Request[]) => PlacedLabel<SensorName>[],
): PlacedLabel<SensorName>[] {
  const placed = place(requests);
  const isPlaced = ({ name }: Request): boolean => placed.some((label) => label.name === name);
  const leftOut = requests.filter((request) => !isPlaced(request));
  if (leftOut.length === 0) return placed;
  const again = place([...leftOut, ...requests.filter(isPlaced)]);
  return again.length > placed.length ? again : placed;
}

function isInside({ x, y }: { x: number; y: number }, box: Box): boolean {
  return x >= box.x && y >= box.y && x <= box.x + box.width && y <= box.y + box.height;
}
