/**
 * The pen in which the robot is tested: an empty rectangle of straight walls, 2 m wide and 5 m
 * long. The robot stands in the near right corner, 50 cm from both walls, and faces along the right
 * wall. The readings there, and after each motion, are known in advance.
 */
import { sensorNames, type SensorReadings, type Snapshot } from "@corridor/protocol";
import type { Host } from "./host.ts";
import { must, NotTestable } from "./mismatch.ts";

/** Distances in cm from the robot's position to the walls, for each sensor. */
export const START_READINGS: SensorReadings = { front: 450, right: 50, back: 50, left: 150 };

/**
 * absolute tolerance in cm, and relative tolerance, of the readings of physical sensors and carpets
 */
const TOLERANCE_CM = 6;
const TOLERANCE_SHARE = 0.15;
/** Factor by which the tolerance grows for the robot's position after earlier checks. */
const START_TOLERANCE = 2;

export function isNear(found: number, expected: number, factor = 1): boolean {
  return (
    Math.abs(found - expected) <= factor * (TOLERANCE_CM + TOLERANCE_SHARE * Math.abs(expected))
  );
}

export function areNear(found: SensorReadings, expected: SensorReadings, factor = 1): boolean {
  return sensorNames.every((side) => isNear(found[side], expected[side], factor));
}

/** The expected readings after quarter turns to the right; negative numbers turn to the left. */
export function turned(readings: SensorReadings, quarters: number): SensorReadings {
  const at = (index: number) =>
    readings[sensorNames[(((index + quarters) % 4) + 4) % 4] ?? "front"];
  return { front: at(0), right: at(1), back: at(2), left: at(3) };
}

/** The expected readings after a move of `distance` cm; negative numbers move backward. */
export function moved(readings: SensorReadings, distance: number): SensorReadings {
  return { ...readings, front: readings.front - distance, back: readings.back + distance };
}

export async function readings(host: Host): Promise<SensorReadings> {
  return (await host.snapshot()).sensors;
}

/** @throws Mismatch unless the current readings are the expected ones */
export async function mustHaveReadings(host: Host, expected: SensorReadings, after: string) {
  const found = await readings(host);
  must(areNear(found, expected), `about ${show(expected)} ${after}`, show(found));
}

/**
 * Moves the robot along the right wall to its position.
 * @throws NotTestable if it does not arrive
 */
export async function moveToStart(host: Host): Promise<Snapshot> {
  const { sensors } = await host.snapshot();
  const ahead = sensors.front - START_READINGS.front;
  const isOnItsWay = areNear(moved(sensors, ahead), START_READINGS, START_TOLERANCE);
  if (isOnItsWay && Math.abs(ahead) > 3)
    await host.sendAndWait({ action: "move", distance: ahead });
  const snapshot = await host.snapshot();
  if (areNear(snapshot.sensors, START_READINGS, START_TOLERANCE)) return snapshot;
  throw new NotTestable(
    `the robot is not at its place in the pen (${show(snapshot.sensors)}): an earlier check may ` +
      "have left it elsewhere. Put it back and run the kit again",
  );
}

/** @throws Mismatch if the robot moves within half a second */
export async function mustStand(host: Host): Promise<void> {
  const first = await host.snapshot();
  await new Promise((resolve) => setTimeout(resolve, 500));
  const later = await host.snapshot(`?after=${first.seq}&wait=5`);
  const isSame = sensorNames.every(
    (side) => Math.abs(first.sensors[side] - later.sensors[side]) < 5,
  );
  must(isSame, "a robot that stands", `${show(first.sensors)}, then ${show(later.sensors)}`);
}

export function show(readings: SensorReadings): string {
  return sensorNames.map((side) => `${side} ${Math.round(readings[side])}`).join(", ");
}
