import { RefusedError } from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { settled } from "@corridor/protocol/testing";
import { ManualPort } from "../../../../packages/ros/src/testing/manual-port.ts";
import { BridgedRobot } from "./bridged-robot.ts";

const move = { action: "move", distance: 100 } as const;
const drive = { action: "drive", left: 1, right: 1 } as const;

function bridged() {
  const port = new ManualPort();
  return { port, robot: new BridgedRobot(port) };
}

describe("the robot of a bridge", () => {
  it("ends every command that has not ended when the bridge stops", async () => {
    const { port, robot } = bridged();
    const program = robot.openPort();
    for (let i = 0; i < 4; i += 1) await program.send(move);
    port.end(1, { state: "completed" });
    port.miss([{ seq: 3, state: "started" }]);
    await robot.stop();
    expect(port.cancelled).toEqual([3]);
  });

  it("ends a command that is being sent when the bridge stops", async () => {
    const { port, robot } = bridged();
    const sent = robot.openPort().send(move);
    await robot.stop();
    expect(port.cancelled).toEqual([(await sent).seq]);
  });

  it("leaves commands of other scripts alone", async () => {
    const { port, robot } = bridged();
    await port.send(move);
    await robot.openPort().send(move);
    await robot.stop();
    expect(port.cancelled).toEqual([2]);
  });

  it("does not end a command whose end arrives before its number", async () => {
    const { port, robot } = bridged();
    const send = port.send.bind(port);
    port.send = async (order, key) => {
      const record = await send(order, key);
      port.end(record.seq, { state: "completed" });
      return { ...record, state: "accepted" };
    };
    await robot.openPort().send(move);
    await robot.stop();
    expect(port.cancelled).toEqual([]);
  });

  it("stops although the network is lost", async () => {
    const { port, robot } = bridged();
    await robot.openPort().send(move);
    const cancelled: number[] = [];
    port.cancel = (seq) => {
      cancelled.push(seq);
      return new Promise(() => undefined);
    };
    vi.useFakeTimers();
    onTestFinished(() => void vi.useRealTimers());
    const stopped = robot.stop();
    await vi.advanceTimersByTimeAsync(2_000);
    await stopped;
    expect(cancelled).toEqual([1]);
  });

  it("throws refusals, and has nothing to end then", async () => {
    const { port, robot } = bridged();
    const wrong = robot.openPort().send({ action: "move", distance: 1e9 });
    await expect(wrong).rejects.toThrow(RefusedError);
    await robot.stop();
    expect(port.cancelled).toEqual([]);
  });
});

describe("the port of a program", () => {
  it("ends its motions without an end when the program disconnects", async () => {
    const { port, robot } = bridged();
    const program = robot.openPort();
    const other = robot.openPort();
    await other.send({ action: "forward" });
    for (const order of [
      move,
      { action: "reverse" } as const,
      drive,
      { ...drive, milliseconds: 9 },
    ]) {
      await program.send(order);
    }
    program.close();
    await settled();
    expect(port.cancelled).toEqual([3, 4]);
    expect(port.isClosed).toBe(false);
  });

  it("leaves the velocities of ROS clients to their lease, and ends guarded drives", async () => {
    const { port, robot } = bridged();
    const program = robot.openPort({ keepsVelocities: true });
    await program.send(drive);
    await program.send({ ...drive, until: [{ goal: true }] });
    program.close();
    await settled();
    expect(port.cancelled).toEqual([2]);
  });

  it("receives nothing after it was closed", async () => {
    const { port, robot } = bridged();
    const program = robot.openPort();
    const states: string[] = [];
    program.subscribe({
      snapshot: () => undefined,
      state: ({ state }) => void states.push(state),
      gap: () => undefined,
      maze: () => undefined,
      end: () => undefined,
    });
    await program.send(move);
    port.end(1, { state: "started" });
    program.close();
    port.end(1, { state: "completed" });
    expect(states).toEqual(["started"]);
  });
});
