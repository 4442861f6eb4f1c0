/**
 * Publishes velocities, and measures the speed of the robot in its own time: a busy computer delays
 * messages and wall time, but not the ticks of a robot.
 */
import { type Snapshot, TICKS_PER_SECOND } from "@corridor/protocol";
import { pause, type Host } from "./host.ts";
import type { RosConnection } from "./ros-connection.ts";

/** ms between two velocities. The lease of a velocity is longer. */
const INTERVAL_MS = 100;
/** ms after which a robot that does not move is given up */
const TIMEOUT_MS = 10_000;

/** How far the robot has moved between two snapshots, in the unit of the amount. */
type Travel = (from: Snapshot, to: Snapshot) => number;

/** cm in which the wall in front comes nearer */
export const distance: Travel = (from, to) => from.sensors.front - to.sensors.front;

export interface Motion {
  /** how far the robot has moved */
  travelled: number;
  /**
   * Mean speed in the fastest second of the robot's time. Between two velocities that arrive late, the
   * robot stands, which only lowers the speed of other seconds.
   */
  speed: number;
}

/** Publishes a velocity until the robot has moved by an amount, and for at least a second. */
export async function drive(
  host: Host,
  ros: RosConnection,
  { velocity, amount, travel }: { velocity: object; amount: number; travel: Travel },
): Promise<Motion> {
  const deadline = performance.now() + TIMEOUT_MS;
  let last = await host.snapshot();
  const points = [{ tick: last.tick, travelled: 0 }];
  let travelled = 0;
  let speed = 0;
  while (performance.now() < deadline) {
    publish(ros, velocity);
    await pause(INTERVAL_MS);
    const snapshot = await host.snapshot();
    const { tick } = snapshot;
    travelled += travel(last, snapshot);
    last = snapshot;
    const start = points.findLast((point) => tick - point.tick >= TICKS_PER_SECOND);
    points.push({ tick, travelled });
    if (start === undefined) continue;
    const found = ((travelled - start.travelled) / (tick - start.tick)) * TICKS_PER_SECOND;
    if (Math.abs(found) > Math.abs(speed)) speed = found;
    if (Math.abs(travelled) >= amount) break;
  }
  return { travelled, speed };
}

export function publish(ros: RosConnection, velocity: object): void {
  ros.send({ op: "publish", topic: "/cmd_vel", msg: velocity });
}
