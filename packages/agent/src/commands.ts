/** Tools that send commands: `act`, `stop` and `reset`. */
import {
  hasEnded,
  sendAndWait,
  type CommandRecord,
  type Order,
  type RobotPort,
} from "@corridor/protocol";
import {
  actArguments,
  commandResult,
  MAX_WAIT_SECONDS,
  noArguments,
  resetArguments,
} from "./arguments.ts";
import { describeSnapshot } from "./snapshot-words.ts";
import { NOT_REPORTED, readArguments, textResult, type Tool, type ToolResult } from "./tool.ts";

export const actTool: Tool = {
  name: "act",
  description: `Sends one command and waits up to ${MAX_WAIT_SECONDS} s for its end; returns the command's record and the sensors after it.`,
  input: actArguments,
  output: commandResult,
  drives: true,
  async run({ port }, args) {
    const { key, ...order } = fieldsOf(args);
    // The port checks the command and its key, so that the owner sees wrong ones too.
    return act(port, order as Order, key as string | undefined);
  },
};

export const stopTool: Tool = {
  name: "stop",
  description: "Stops the robot at once, and cancels all commands that run or wait.",
  input: noArguments,
  output: commandResult,
  drives: true,
  async run({ port }, args) {
    readArguments(noArguments, args);
    return act(port, { action: "stop" });
  },
};

export const resetTool: Tool = {
  name: "reset",
  description:
    "Puts the robot back at the start of its maze and starts a new run. It ends all earlier commands.",
  input: resetArguments,
  output: commandResult,
  drives: true,
  async run({ port }, args) {
    const { key } = readArguments(resetArguments, args);
    return act(port, { action: "reset" }, key);
  },
};

function fieldsOf(args: unknown): Record<string, unknown> {
  return typeof args === "object" && args !== null ? { ...args } : {};
}

async function act(port: RobotPort, order: Order, key?: string): Promise<ToolResult> {
  const record = await sendAndWait(port, order, key, MAX_WAIT_SECONDS * 1000);
  // Not an error if there is none: the command was sent.
  const snapshot = port.newest;
  const after = snapshot === null ? NOT_REPORTED : describeSnapshot(snapshot);
  return textResult(`${describeRecord(record)}\n${after}`, { record, snapshot });
}

function describeRecord(record: CommandRecord): string {
  const { seq, action, state, reason, distance, duplicate, key } = record;
  const parts = [`Command ${seq} (${action}): ${state}`];
  if (distance !== null && distance > 0)
    parts.push(`, ${Math.round(distance * 10) / 10} cm driven`);
  parts.push(".");
  if (state === "collided") parts.push(" The robot touched a wall and stands still.");
  if (reason !== null) parts.push(` ${reason}`);
  if (duplicate) {
    parts.push(
      " This key was sent before, so the robot did not move again. If this is a new command, send it with another key.",
    );
  }
  if (!hasEnded(state)) {
    const how = key === null ? "call wait or sense" : "send the same act with the same key";
    parts.push(` It has not ended yet: to follow it, ${how}.`);
  }
  return parts.join("");
}
