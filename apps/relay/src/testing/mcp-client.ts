/** Agents for tests: clients of both eras of the Model Context Protocol, and single messages. */
import type { Registration } from "@corridor/protocol";
import { Client, StreamableHTTPClientTransport } from "@modelcontextprotocol/client";
import { onTestFinished } from "vitest";

export const eras = ["2026-07-28", "2025"] as const;
export type Era = (typeof eras)[number];

export const mcpUrl = ({ origin }: { origin: string }, { id }: Registration): string =>
  `${origin}/r/${id}/mcp`;

/** Connects a client with a key in the header, or none. */
export async function connectAgent(url: string, key: string | null, era: Era): Promise<Client> {
  const headers = key === null ? {} : { Authorization: `Bearer ${key}` };
  const transport = new StreamableHTTPClientTransport(new URL(url), { requestInit: { headers } });
  const mode = era === "2025" ? "legacy" : { pin: era };
  const client = new Client({ name: "test", version: "1.0.0" }, { versionNegotiation: { mode } });
  onTestFinished(() => client.close());
  await client.connect(transport);
  return client;
}

/** Text of a tool's result, and whether it is a refusal. */
export async function callTool(
  client: Client,
  name: string,
  args: Record<string, unknown> = {},
): Promise<{ isError: boolean; text: string; structured: Record<string, unknown> }> {
  const { isError, content, structuredContent } = await client.callTool({ name, arguments: args });
  const texts = content.flatMap((each) => (each.type === "text" ? [each.text] : []));
  const structured = (structuredContent ?? {}) as Record<string, unknown>;
  return { isError: isError === true, text: texts.join("\n"), structured };
}

/** A call of a tool as one message of a client of 2025. */
export function callMessage(name: string, args: unknown = {}, id = 1): unknown {
  return { jsonrpc: "2.0", id, method: "tools/call", params: { name, arguments: args } };
}
