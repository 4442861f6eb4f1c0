/**
 * The MCP server of a robot: tools by which an AI agent senses, looks and drives. It knows the
 * robot's port only. A transport connects it, for one request or one connection.
 */
import { RefusedError, type RobotPort } from "@corridor/protocol";
import {
  ProtocolError,
  ProtocolErrorCode,
  Server,
  type CallToolResult,
} from "@modelcontextprotocol/server";
import { instructions, watchInstructions } from "./instructions.ts";
import type { AgentClock, AgentContext } from "./tool.ts";
import { listedTools, tools } from "./tools.ts";

/** Version of the tools: it changes when a tool's arguments or results do. */
const VERSION = "1.0.0";

export interface Agent {
  server: Server;
  /** Ends waits, and closes the port. Commands continue. */
  close(): void;
}

export function createAgent(port: RobotPort, clock: AgentClock): Agent {
  const context: AgentContext = { port, clock, endWaits: new Set() };
  const mayDrive = port.capability === "drive";
  const server = new Server(
    { name: "corridor", title: "Corridor robot", version: VERSION },
    { capabilities: { tools: {} }, instructions: mayDrive ? instructions : watchInstructions },
  );
  server.setRequestHandler("tools/list", () => ({ tools: listedTools(mayDrive) }));
  server.setRequestHandler("tools/call", async ({ params }) =>
    call(context, params.name, params.arguments ?? {}),
  );
  const close = (): void => {
    for (const end of context.endWaits) end();
    port.close();
  };
  return { server, close };
}

/** Refusals are results, so that the agent reads the sentence. */
async function call(context: AgentContext, name: string, args: unknown): Promise<CallToolResult> {
  const tool = tools.find((each) => each.name === name);
  if (tool === undefined) {
    const names = tools.map((each) => each.name).join(", ");
    throw new ProtocolError(
      ProtocolErrorCode.InvalidParams,
      `No tool of this name. Tools: ${names}.`,
    );
  }
  try {
    return await tool.run(context, args);
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    return refusalOf(error);
  }
}

function refusalOf({ problem, retryAfter }: RefusedError): CallToolResult {
  const wait = retryAfter === null ? "" : ` Try again in ${retryAfter} s.`;
  return {
    isError: true,
    content: [{ type: "text", text: `${problem.detail}${wait}` }],
    structuredContent: { problem, retryAfter },
  };
}
