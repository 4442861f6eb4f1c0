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

/** @param onRefused called for each refusal that an agent receives, for metrics and logs */
export function createAgent(
  port: RobotPort,
  clock: AgentClock,
  onRefused: (error: RefusedError) => void = () => undefined,
): Agent {
  const context: AgentContext = { port, clock, endWaits: new Set() };
  const mayDrive = port.capability === "drive";
  const server = new Server(
    { name: "corridor", title: "Corridor robot", version: VERSION },
    { capabilities: { tools: {} }, instructions: mayDrive ? instructions : watchInstructions },
  );
  server.setRequestHandler("tools/list", () => ({ tools: listedTools(mayDrive) }));
  server.setRequestHandler("tools/call", async ({ params }) => {
    try {
      return await call(context, params.name, params.arguments ?? {});
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
      onRefused(error);
      return refusalOf(error);
    }
  });
  const close = (): void => {
    for (const end of context.endWaits) end();
    port.close();
  };
  return { server, close };
}

/** @throws RefusedError, or ProtocolError if there is no such tool */
async function call(context: AgentContext, name: string, args: unknown): Promise<CallToolResult> {
  const tool = tools.find((each) => each.name === name);
  if (tool !== undefined) return tool.run(context, args);
  const names = tools.map((each) => each.name).join(", ");
  throw new ProtocolError(
    ProtocolErrorCode.InvalidParams,
    `No tool has this name. Tools: ${names}.`,
  );
}

/** A refusal is a result, so that the agent reads the sentence. */
function refusalOf({ problem, retryAfter }: RefusedError): CallToolResult {
  const wait = retryAfter === null ? "" : ` Try again in ${retryAfter} s.`;
  return {
    isError: true,
    content: [{ type: "text", text: `${problem.detail}${wait}` }],
    structuredContent: { problem, retryAfter },
  };
}
