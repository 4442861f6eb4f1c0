/** A ROS client that is connected to a session with a manual robot. */
import { snapshotOf } from "@corridor/protocol/testing";
import { RosSession } from "../ros-session.ts";
import { ManualTimers, settled } from "@corridor/protocol/testing";
import { ManualPort } from "./manual-port.ts";

/** 3 x 2 cells; the robot of `snapshotOf` stands in the right one of the upper row. */
export const maze = {
  format: "corridor/maze",
  version: 1,
  name: "Test",
  blocks: ["#..", "..#"],
  start: { column: 1, row: 0, heading: "east" },
  goals: [],
};

export interface Frame {
  op: string;
  [field: string]: unknown;
}

export class RosClient {
  readonly port: ManualPort;
  readonly timers = new ManualTimers();
  readonly frames: Frame[] = [];
  readonly problems: string[] = [];
  readonly failures: unknown[] = [];
  readonly closings: number[] = [];
  readonly session: RosSession;

  private constructor(port: ManualPort) {
    this.port = port;
    this.session = new RosSession({
      port,
      timers: this.timers,
      send: (text) => void this.frames.push(JSON.parse(text) as Frame),
      close: ({ code }) => void this.closings.push(code),
      onProblem: ({ message }) => void this.problems.push(message),
      onFailure: (error) => void this.failures.push(error),
      onEnd: () => undefined,
    });
  }

  /** Connects to a robot that has reported, and lets the first 300 ms pass. */
  static async connect(
    capability: "drive" | "watch" = "drive",
    hasMaze = true,
  ): Promise<RosClient> {
    const port = new ManualPort(capability);
    if (hasMaze) port.maze = maze;
    port.newest = snapshotOf();
    const client = new RosClient(port);
    await client.timers.pass(300);
    return client;
  }

  async send(message: object): Promise<void> {
    this.session.receive(JSON.stringify(message));
    await settled();
  }

  /** The messages that a topic has received. */
  received(topic: string): unknown[] {
    return this.frames.filter((frame) => frame["topic"] === topic).map(({ msg }) => msg);
  }

  /** The answer of a service. */
  async call(service: string, args: unknown = {}): Promise<Frame> {
    await this.send({ op: "call_service", id: `call:${service}`, service, args });
    const answer = this.frames.findLast((frame) => frame["id"] === `call:${service}`);
    if (answer === undefined) throw new Error(`${service} has not answered`);
    return answer;
  }

  /** Publishes a velocity, and lets it be sent. */
  async drive(linear: number, angular = 0): Promise<void> {
    const msg = { linear: { x: linear }, angular: { z: angular } };
    await this.send({ op: "publish", topic: "/cmd_vel", msg });
    await this.timers.pass(0);
  }
}
