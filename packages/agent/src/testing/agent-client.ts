/** An agent that is connected to a robot without a network, by the SDK's client. */
import type { MazeDocument } from "@corridor/maze";
import { Client } from "@modelcontextprotocol/client";
import { InMemoryTransport } from "@modelcontextprotocol/server";
import { onTestFinished } from "vitest";
import { createAgent } from "../agent-server.ts";
import type { AgentClock } from "../tool.ts";
import { MazePort } from "./maze-port.ts";
import { MazeRobot } from "./maze-robot.ts";

/** The corridor of the instructions: ahead, then to the right, with the goal at its end. */
export const corridor: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Corridor",
  blocks: ["######", "#....#", "####.#", "####.#", "######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 4, row: 3 }],
};

/** A clock that stands until the test lets time pass. */
export class StandingClock implements AgentClock {
  #now = 0;
  readonly #calls = new Set<{ at: number; call: () => void }>();

  now(): number {
    return this.#now;
  }

  after(milliseconds: number, call: () => void): () => void {
    const entry = { at: this.#now + milliseconds, call };
    this.#calls.add(entry);
    return () => void this.#calls.delete(entry);
  }

  pass(milliseconds: number): void {
    this.#now += milliseconds;
    for (const entry of this.#calls) {
      if (entry.at > this.#now) continue;
      this.#calls.delete(entry);
      entry.call();
    }
  }

  get waiting(): number {
    return this.#calls.size;
  }
}

export interface ToolAnswer {
  isError: boolean;
  text: string;
  /** MIME types and data of pictures */
  pictures: { data: string; mimeType: string }[];
  structured: Record<string, unknown>;
}

export async function agentFor(
  options: { maze?: MazeDocument; capability?: "drive" | "watch" } = {},
) {
  const robot = new MazeRobot(options.maze ?? corridor);
  const port = new MazePort(robot, options.capability);
  const clock = new StandingClock();
  const agent = createAgent(port, clock);
  const [near, far] = InMemoryTransport.createLinkedPair();
  const client = new Client({ name: "test", version: "1.0.0" });
  await Promise.all([agent.server.connect(near), client.connect(far)]);
  onTestFinished(() => client.close());
  const call = async (name: string, args: Record<string, unknown> = {}): Promise<ToolAnswer> =>
    answerOf(await client.callTool({ name, arguments: args }));
  return { robot, port, clock, agent, client, call };
}

interface RawResult {
  isError?: boolean | undefined;
  content: readonly { type: string }[];
  structuredContent?: unknown;
}

/** The parts of a result that tests read. */
export function answerOf({ isError, content, structuredContent }: RawResult): ToolAnswer {
  const texts = content.flatMap((each) => ("text" in each ? [String(each.text)] : []));
  const pictures = content.flatMap((each) =>
    "data" in each && "mimeType" in each
      ? [{ data: String(each.data), mimeType: String(each.mimeType) }]
      : [],
  );
  const structured = (structuredContent ?? {}) as Record<string, unknown>;
  return { isError: isError === true, text: texts.join("\n"), pictures, structured };
}
