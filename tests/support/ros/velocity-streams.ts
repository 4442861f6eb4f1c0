/**
 * ROS clients that turn a robot by ten velocities a second, whatever happens to their connections.
 * Each velocity differs, so that the commands of the robot show which of them moved it.
 */
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { Ros, Topic } from "roslib";
import { onTestFinished } from "vitest";

const MS_BETWEEN = 100;
const RETRY_MS = 250;
const script = fileURLToPath(new URL("velocity_stream.py", import.meta.url));

export class VelocityStream {
  /** ms of the wall clock, by the number of the velocity */
  readonly published = new Map<number, number>();
  /** number of received poses */
  poses = 0;

  /** Called for each event of the client. */
  record(what: "published" | "pose", number: number, at: number): void {
    if (what === "pose") this.poses += 1;
    else this.published.set(number, at);
  }
}

/** The velocity with this number in rad/s; `velocity_stream.py` has the same formula. */
const angularOf = (number: number): number => 1 + number / 1000;

/** The number of the velocity that became this order. @param right wheel power */
export function numberOf(right: number): number {
  return Math.round(((right * 2.61) / 0.2 - 1) * 1000);
}

/** The library of JavaScript. It does not reconnect by itself: programs do as its documentation shows. */
export function streamByRoslib(url: string): VelocityStream {
  const stream = new VelocityStream();
  const ros = new Ros({ url });
  let isOver = false;
  ros.on("error", () => undefined);
  ros.on("close", () => {
    if (!isOver) setTimeout(() => void ros.connect(url).catch(() => undefined), RETRY_MS);
  });
  const poses = new Topic<{ theta: number }>({
    ros,
    name: "/pose2d",
    messageType: "geometry_msgs/Pose2D",
  });
  poses.subscribe(({ theta }) => stream.record("pose", theta, Date.now()));
  const topic = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
  let number = 0;
  const timer = setInterval(() => {
    number += 1;
    const angular = { x: 0, y: 0, z: angularOf(number) };
    topic.publish({ linear: { x: 0, y: 0, z: 0 }, angular });
    stream.record("published", number, Date.now());
  }, MS_BETWEEN);
  onTestFinished(() => {
    isOver = true;
    clearInterval(timer);
    ros.close();
  });
  return stream;
}

/** The library of Python, which reconnects by itself. */
export function streamByRoslibpy(
  { python, transport }: { python: string; transport: string },
  { url, key }: { url: string; key: string },
): VelocityStream {
  const stream = new VelocityStream();
  const child = spawn(python, [script, url, key], {
    env: { ...process.env, ROSLIBPY_TRANSPORT: transport },
    stdio: ["pipe", "pipe", "ignore"],
  });
  createInterface({ input: child.stdout }).on("line", (line) => {
    const { what, number, at } = JSON.parse(line) as {
      what: "published" | "pose";
      number: number;
      at: number;
    };
    stream.record(what, number, at);
  });
  onTestFinished(() => void child.kill());
  return stream;
}
