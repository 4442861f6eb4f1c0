/** The shape of a tool, and what it works with. */
import {
  describeProblem,
  readValue,
  RefusedError,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import type { z } from "zod";

/** Clock of the platform, for waits. */
export interface AgentClock {
  /** milliseconds of a monotonic clock */
  now(): number;
  /** @returns a function that cancels the call */
  after(milliseconds: number, call: () => void): () => void;
}

/** What the tools of one connection, or of one request, work with. */
export interface AgentContext {
  port: RobotPort;
  clock: AgentClock;
  /** ends the waits of tools; called when the client has disconnected */
  endWaits: Set<() => void>;
}

export type ToolContent =
  | { type: "text"; text: string }
  | { type: "image"; data: string; mimeType: "image/png" };

/** The result of a call, as the protocol returns it. A type, because results have other fields. */
export type ToolResult = {
  content: ToolContent[];
  structuredContent: Record<string, unknown>;
};

export interface Tool {
  name: string;
  description: string;
  /** shape of the arguments, for clients */
  input: z.ZodType;
  /** shape of `structuredContent`, for clients */
  output: z.ZodType;
  /** whether it needs a key that may drive */
  drives: boolean;
  /** @throws RefusedError */
  run(context: AgentContext, args: unknown): Promise<ToolResult>;
}

export function textResult(text: string, structuredContent: Record<string, unknown>): ToolResult {
  return { content: [{ type: "text", text }], structuredContent };
}

/** @throws RefusedError bad-request, which names the first wrong field */
export function readArguments<T>(schema: z.ZodType<T>, args: unknown): T {
  const result = readValue(schema, args);
  if (result.ok) return result.value;
  const [first] = result.problems;
  const sentence = first === undefined ? "" : ` ${describeProblem(first)}.`;
  throw new RefusedError({
    type: "/problems/bad-request",
    title: "Invalid request",
    status: 400,
    detail: `Invalid arguments.${sentence}`.replaceAll('"', "'"),
    errors: result.problems,
  });
}

export const NOT_REPORTED =
  "The robot has not reported yet. Ask its owner to open the page and choose Remote, then try again.";

const ignore = (): void => undefined;
const noListener = { snapshot: ignore, state: ignore, gap: ignore, maze: ignore, end: ignore };

/** @throws RefusedError no-snapshot before the robot's first report, or why the port may not read */
export function newestOf(port: RobotPort): Snapshot {
  if (port.newest !== null) return port.newest;
  // A port that may no longer read has no snapshot either, and refuses subscriptions.
  port.subscribe(noListener)();
  throw new RefusedError({
    type: "/problems/no-snapshot",
    title: "No snapshot yet",
    status: 409,
    detail: NOT_REPORTED,
    errors: [],
  });
}
